#pragma once

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// What the model lacks: the verdict, the ranking of effects while and after it is worked out, what the chosen one
/// would do to the residual and to the errors, and a button that adds it to the model.
class DiagnosePanel : public Panel {
public:
    std::string name() const override { return "diagnose"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Step> step() const override { return commands::Step::diagnose; }
    void draw(PanelContext& context) override;

private:
    void draw_head(PanelContext& context);
    void draw_ranking(PanelContext& context);
    void draw_choices(PanelContext& context, bool none);
    void draw_residual(PanelContext& context, const commands::DiagnosisRow& row);
    void draw_force(PanelContext& context);
    void draw_errors(PanelContext& context, const commands::DiagnosisRow& row);
    void follow(const commands::WorkbenchState& state);

    bool ranking_ = true;  // in a narrow window: the ranking instead of what its row does
    bool errors_ = false;  // the table of errors instead of the plot
    int axis_ = 0;
    plot::LinkedAxis time_;
    plot::PlotState plot_;
    plot::HiddenSeries hidden_;
    std::shared_ptr<const commands::Scene> scene_;  // whose plots are zoomed
    std::string followed_;                          // scene, row, trial, marker and axis that the zoom belongs to
    bool axis_chosen_ = false;                      // by the person
};

}  // namespace myo::ui::panels
