#pragma once

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo {

/// What the model lacks: the verdict, the ranking of effects while and after it is worked out, what the chosen one would do to the
/// residual and to the errors, and a button that adds it to the model.
class DiagnosePanel : public Panel {
public:
    std::string name() const override { return "diagnose"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<Step> step() const override { return Step::diagnose; }
    void draw(PanelContext& context) override;

private:
    void draw_head(PanelContext& context);
    void draw_ranking(PanelContext& context);
    void draw_choices(PanelContext& context, bool none);
    void draw_residual(PanelContext& context, const DiagnosisRow& row);
    void draw_force(PanelContext& context);
    void draw_errors(PanelContext& context, const DiagnosisRow& row);
    void follow(const WorkbenchState& state);

    bool ranking_ = true;                   // in a narrow window: the ranking instead of what its row does
    bool errors_ = false;                   // the table of errors instead of the plot
    int axis_ = 0;
    LinkedAxis time_;
    PlotState plot_;
    HiddenSeries hidden_;
    std::shared_ptr<const Scene> scene_;    // whose plots are zoomed
    std::string followed_;                  // scene, row, trial, marker and axis that the zoom belongs to
    bool axis_chosen_ = false;              // by the person
};

}  // namespace myo
