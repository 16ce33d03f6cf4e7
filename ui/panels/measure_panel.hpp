#pragma once

#include "panels/panel.hpp"

namespace myo {

/// The measured trials, and how far each marker of the shown one is from what was simulated.
class MeasurePanel : public Panel {
public:
    std::string name() const override { return "measure"; }
    std::string title() const override { return "Measurement"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<Step> step() const override { return Step::measure; }
    void draw(PanelContext& context) override;

private:
    bool bias_ = false;   // the table shows the mean difference instead of rms per axis
};

/// Trials with their roles and the rms error of the shown run; a click shows the trial.
/// @param item  of the rows, before the trial's name
void draw_trial_errors(PanelContext& context, const std::string& item);

}  // namespace myo
