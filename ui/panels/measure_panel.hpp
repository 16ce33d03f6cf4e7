#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The measured trials, and how far each marker of the shown one is from what was simulated.
class MeasurePanel : public Panel {
public:
    std::string name() const override { return "measure"; }
    std::string title() const override { return "Measurement"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::measure; }
    bool offered(const commands::WorkbenchState& state) const override { return !state.import; }
    void draw(PanelContext& context) override;

private:
    enum class Shown { whole, rms, largest, bias };  // of the markers, all but the first per axis
    Shown shown_ = Shown::whole;
};

/// Trials with their roles and their rms error in a run, which may be null; a click shows the trial.
/// @param item  of the rows, before the trial's name
void draw_trial_errors(PanelContext& context, const std::string& item, const commands::RunResult* run);

}  // namespace myo::ui::panels
