#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fit: starts searches, that is the calibration of parameters, and the optimisation of muscle signals with which
/// the markers follow a trial. Shows the values found.
///
/// Emits Calibrate, ChangeOptimize and Optimize. SearchPanel shows the search while it runs. Item names begin with
/// "fit/".
class FitPanel : public Panel {
public:
    std::string name() const override { return "fit"; }
    std::string title() const override { return "Fit"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fit; }
    void draw(PanelContext& context) override;

private:
    /// Calibration: the unknown parameters and the button that starts it.
    void draw_calibrate(PanelContext& context);
    /// Optimisation of signals: its settings and the button that starts it.
    void draw_optimize(PanelContext& context);
    /// Result of the last search, while its run is shown.
    void draw_found(PanelContext& context);

    NumberEdits edit_;  // edit in progress in one of the number fields
};

}  // namespace myo::ui::panels
