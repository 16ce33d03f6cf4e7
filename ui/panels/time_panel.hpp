#pragma once

#include "panels/setting_rows.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Task Run: edits time scheme and time step, and shows the numerical damping and the stability that follow from them.
///
/// Emits ChangeSettings, SetDampingFrequency and ChangePreview. Everything shown follows from the settings, so it
/// changes with each edit, before any run. Item names begin with "model/".
class TimePanel : public Panel {
public:
    std::string name() const override { return "time"; }
    std::string title() const override { return "Time step"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::run; }
    void draw(PanelContext& context) override;

private:
    /// Slider below the row of a number, for the same number.
    void draw_slider(PanelContext& context, const SettingField& field, commands::Limits range, bool logarithmic);
    /// Sample interval, vibration and frequency error for the present step.
    void draw_step_state(PanelContext& context);
    /// Switch between the program's step and the user's.
    void draw_step_choice(PanelContext& context);
    /// Stable and unstable range along the foot of the slider of the velocity force, and the critical value below it.
    void draw_stability(PanelContext& context, commands::Limits range);
    /// Damping ratio that the scheme adds at a frequency of the user's choice.
    void draw_numerical_damping(PanelContext& context);
    /// Numerical damping over the time step, with the measured damping for comparison.
    void draw_damping_curve(PanelContext& context, const commands::Choice& scheme);

    struct CurveKey;
    /// Computes the curve for another key, and resets its zoom.
    void update_damping_curve(const CurveKey& key, commands::Settings settings, const commands::Choice& scheme);
    /// @param measured  damping ratio of the measured vibration at its own frequency; NaN: none
    /// Plot of the damping ratio over the step [ms], with a line at the present step.
    ///
    plot::Plot damping_plot(const PanelContext& context, double measured) const;

    // Drags in progress: number fields, sliders, the line in the curve, and the preview length.
    NumberEdits edit_;
    OpenEdit slide_;
    OpenEdit curve_edit_;
    NumberEdits preview_edit_;

    // Inputs of the damping curve; the curve is computed again if one of them changes.
    struct CurveKey {
        std::string integrator;  // id of the time scheme
        double spectral_radius = 0.0;
        double frequency_Hz = 0.0;
        double longest_s = 0.0;  // greatest step of the curve
        bool operator==(const CurveKey&) const = default;
    };
    CurveKey curve_key_;               // inputs of the present curve
    Eigen::VectorXd step_ms_, ratio_;  // the damping curve: steps and damping ratios
    plot::LinkedAxis axis_;            // zoom of the curve
    plot::PlotState plot_;             // zoom of the value axis
    plot::HiddenSeries hidden_;        // curves switched off in the legend
};

}  // namespace myo::ui::panels
