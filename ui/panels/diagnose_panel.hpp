#pragma once

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Shows what the model lacks: the verdict; the ranking of effects while the diagnosis runs and afterwards; the effect
/// of the selected row on residuals and errors; and a button that adds it to the model.
///
/// Emits Diagnose, Cancel, ChooseCandidate, AddEffect, ChooseMarker, ChooseTrial and SetTime. Comes to the front with
/// the task Diagnose. Item names begin with "diagnose/".
class DiagnosePanel : public Panel {
public:
    std::string name() const override { return "diagnose"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Task> task() const override { return commands::Task::diagnose; }
    void draw(PanelContext& context) override;

private:
    // Parts of the panel, from top to bottom.
    /// Button, verdict and its reasons; while a diagnosis runs, its progress.
    void draw_head(PanelContext& context);
    /// Table of the rows, best first. A click selects a row.
    void draw_ranking(PanelContext& context);
    /// Alternatives of the detail view, and the choice of marker and axis. `none`: the ranking is shown instead of the
    /// details.
    void draw_choices(PanelContext& context, bool none);
    /// @param width  of the list [pixels]
    void draw_axis_choice(PanelContext& context, float width);
    /// Effect of the selected row: residual, force or errors. `narrow`: the ranking is one of the alternatives.
    void draw_details(PanelContext& context, bool narrow);
    /// Plot of the measured residual and of the change that the selected row predicts.
    void draw_residual(PanelContext& context, const commands::DiagnosisRow& row);
    /// Plot of the missing force over time.
    void draw_force(PanelContext& context);
    /// Table of errors per trial, before and with the selected row.
    void draw_errors(PanelContext& context, const commands::DiagnosisRow& row);
    /// Keeps zoom and selected axis consistent with what is shown.
    void follow(const commands::WorkbenchState& state);

    bool ranking_ = true;    // narrow window: shows the ranking instead of the details of its row
    bool errors_ = false;    // shows the table of errors instead of the plot
    int axis_ = 0;           // plotted coordinate: 0, 1, 2 = x, y, z
    plot::LinkedAxis time_;  // shared time axis
    plot::PlotState plot_;
    plot::HiddenSeries hidden_;                     // curves switched off in the legend
    std::shared_ptr<const commands::Scene> scene_;  // scene of the zoom and the axis
    std::string followed_;                          // scene, row, trial, marker and axis that the zoom belongs to
    bool axis_chosen_ = false;                      // by the user
};

}  // namespace myo::ui::panels
