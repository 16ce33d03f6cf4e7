#pragma once

#include "panels/setting_rows.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// How the motion is stepped in time, with the damping that this brings.
class TimePanel : public Panel {
public:
    std::string name() const override { return "time"; }
    std::string title() const override { return "Time step"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::run; }
    void draw(PanelContext& context) override;

private:
    /// A slider below a number's row, for the same number.
    void draw_slider(PanelContext& context, const SettingField& field, commands::Limits range, bool logarithmic);
    void draw_step_state(PanelContext& context);
    void draw_step_choice(PanelContext& context);
    void draw_stability(PanelContext& context, commands::Limits range);
    void draw_numerical_damping(PanelContext& context);
    void draw_damping_curve(PanelContext& context, const commands::Choice& scheme);

    OpenEdit edit_;
    OpenEdit slide_;
    OpenEdit curve_edit_;
    OpenEdit preview_edit_;

    // The scheme's damping over the step, and what it was found for.
    struct CurveKey {
        std::string integrator;
        double spectral_radius = 0.0;
        double frequency_Hz = 0.0;
        double longest_s = 0.0;
        bool operator==(const CurveKey&) const = default;
    };
    CurveKey curve_key_;
    Eigen::VectorXd step_ms_, ratio_;
    plot::LinkedAxis axis_;
    plot::PlotState plot_;
    plot::HiddenSeries hidden_;
};

}  // namespace myo::ui::panels
