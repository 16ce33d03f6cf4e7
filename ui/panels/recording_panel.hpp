#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Shows the recording that is being imported: the coordinates of the selected label over the file's time, and the gaps
/// of all labels. Available only during an import.
///
/// Emits ChangeImport when the line at the start is dragged, and ChooseLabel. Item names begin with "recording/".
class RecordingPanel : public Panel {
public:
    std::string name() const override { return "recording"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    bool offered(const commands::WorkbenchState& state) const override { return state.import != nullptr; }
    void draw(PanelContext& context) override;

private:
    /// Another file, or the same one read with another unit, starts with all its data in view.
    void follow(const commands::RecordingImport& import);
    /// @param area  of the first plot, for the time axis
    /// @param height  of a row [pixels]
    /// Rows of all labels below the plots.
    ///
    void draw_gaps(PanelContext& context, const plot::PlotArea& area, float height);

    std::shared_ptr<const measurement::Recording> recording_;   // of seen_ and the zoom
    std::vector<std::vector<std::pair<double, double>>> seen_;  // per label, intervals in which it was seen [s]
    plot::LinkedAxis time_;                                     // time axis of the three plots
    std::array<plot::PlotState, 3> plots_;                      // zoom of the plots of x, y and z
    plot::HiddenSeries hidden_;                                 // curves switched off in the legend
};

}  // namespace myo::ui::panels
