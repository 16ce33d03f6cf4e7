#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fibre/signal.hpp"
#include "panels/number_field.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// A curve whose knots can be edited in a plot.
struct KnotCurve {
    std::string name;                                             // of the actuator; unique in the editor
    std::string item;                                             // name of its knots for tests: "signals/knot"
    fibre::Signal signal;                                         // SI
    std::string quantity;                                         // "Pressure"
    commands::Dimension dimension = commands::Dimension::number;  // of a value
    std::string unit;                                             // shown
    double per_unit = 1.0;                                        // SI per shown unit
    commands::Limits limits{0.0, 1.0};                            // of a value, SI
    ImVec4 color;                                                 // of its knots
    bool constant = false;                                        // no knots can be added
};

/// A plot with the curves, as drawn in this frame.
struct KnotPlot {
    const plot::PlotResult& drawn;
    plot::LinkedAxis& x_axis;  // held still during a drag
    plot::PlotState& state;    // the same of the values
};

/// A changed curve.
struct KnotEdit {
    std::size_t curve = 0;  // index
    fibre::Signal signal;   // SI
    bool goes_on = false;   // continues a drag
};

/// Draws knots over plots and edits them with the mouse: a drag moves one, on round values if it snaps; a double click
/// beside the knots adds one to the nearest curve; Delete removes the one that was clicked last; a right click opens a
/// menu with its numbers. While one is dragged, its values with their units are shown, and the axes stand still.
///
/// One object for all plots of a panel, kept by it.
class KnotEditor {
public:
    /// Call it after the plot was drawn. Plots smaller than their labels show no knots.
    ///
    /// @return  the change of this frame; empty: none
    std::optional<KnotEdit> edit(PanelContext& context, const KnotPlot& plot, const std::vector<KnotCurve>& curves);
    /// Button that switches the snapping.
    void snap_button(PanelContext& context);
    /// Whether a knot is being dragged. The plot must not pan meanwhile.
    bool held() const { return grabbed_.has_value(); }
    /// Drops drag and selection, as curves of another subject are shown.
    void forget();

private:
    /// A knot of one of the curves.
    struct Knot {
        std::string curve;
        std::size_t index = 0;

        bool operator==(const Knot&) const = default;
    };
    /// A drag in progress.
    struct Drag {
        Knot knot;
        ImVec2 offset;                     // from the mouse to the knot at the press [pixels]
        bool moved = false;                // undo merges further changes
        std::optional<chart::Range> x, y;  // zoom before the drag
    };

    /// The curve and index of a knot among those given, if it still exists.
    static const KnotCurve* curve_of(const Knot& knot, const std::vector<KnotCurve>& curves);
    /// The knot nearest to the mouse within reach.
    static std::optional<Knot> knot_at(const plot::PlotArea& area, const std::vector<KnotCurve>& curves, float within);
    void draw(PanelContext& context, const plot::PlotArea& area, const std::vector<KnotCurve>& curves) const;
    /// Takes the knot and holds the axes still.
    void press(const KnotPlot& plot, const KnotCurve& curve, const Knot& knot);
    /// Moves the grabbed knot, or lets it go.
    std::optional<KnotEdit> drag(PanelContext& context, const KnotPlot& plot, const std::vector<KnotCurve>& curves);
    /// Changes by double click and by Delete.
    std::optional<KnotEdit> add_or_remove(PanelContext& context, const KnotPlot& plot,
                                          const std::vector<KnotCurve>& curves);
    /// Menu of a knot: its numbers, and the entry that removes it.
    std::optional<KnotEdit> menu(PanelContext& context, const std::vector<KnotCurve>& curves);
    /// Whether the next place of a knot is a round one.
    bool snaps() const { return snap_ != ImGui::GetIO().KeyCtrl; }

    std::optional<Drag> grabbed_;
    std::optional<Knot> chosen_;  // clicked last
    std::optional<Knot> menu_;    // whose menu is open
    NumberEdits edits_;           // of the menu
    bool snap_ = false;           // drags go to round values
};

}  // namespace myo::ui::panels
