#include "panels/time_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "panels/check_marks.hpp"
#include "panels/preview_rows.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Fields as static tables: they are built once, not in each frame.
const std::vector<SettingField>& radius_fields() {
    static const std::vector<SettingField> fields{
        {{"ρ∞", "model/spectral_radius", commands::Dimension::ratio, "",
          "Spectral radius ρ∞ of a step at ω h → ∞, dimensionless: the share of a very fast vibration's amplitude that "
          "remains after a step. 0 removes it at once, as "
          "BDF2 does; 1 keeps it, as the trapezoidal rule does.",
          commands::spectral_radius_limits, 0.01, "spectral radius"},
         &commands::Settings::spectral_radius}};
    return fields;
}

/// The time step, in ms.
const SettingField& step_field() {
    static const SettingField field{{"Step h", "model/time_step", commands::Dimension::time, "ms",
                                     "Time step h [s]: states are computed at t = 0, h, 2 h and so on. The error of a "
                                     "run falls with h²; with implicit Euler only with h, which damps by ζ ≈ ω h / 2.",
                                     commands::time_step_limits, 0.01, "time step"},
                                    &commands::Settings::time_step_s};
    return field;
}

/// The velocity force Lambda.
const SettingField& velocity_force_field() {
    static const SettingField field{
        {"Velocity force \xce\x9b", "model/velocity_force", commands::Dimension::frequency, "1/s",
         "Velocity force f = \xce\x9b M v [N], \xce\x9b in 1/s. A positive \xce\x9b supplies "
         "the energy that a dissipative time "
         "scheme removes; 0 switches it off.",
         commands::velocity_force_limits, 0.01},
        &commands::Settings::velocity_force_1_s};
    return field;
}

/// The frequency at which damping and stability are shown. No part of the settings.
const NumberField& damping_frequency_field() {
    static const NumberField field{"Frequency",
                                   "model/damping_frequency",
                                   commands::Dimension::frequency,
                                   "Hz",
                                   "Frequency of the vibration [Hz] for which damping and stability are shown.",
                                   commands::damping_frequency_limits,
                                   0.01,
                                   "frequency"};
    return field;
}

/// Range of the slider for the velocity force: twice the critical value, so that the slider resolves what matters.
commands::Limits slider_range(const commands::WorkbenchState& state) {
    const double critical = state.critical_velocity_force_1_s.value_or(0.0);
    const double far = std::isfinite(critical) && critical > 0.0
                           ? std::clamp(2.0 * critical, 0.05, commands::velocity_force_limits.highest)
                           : commands::velocity_force_limits.highest;
    return {-far, far};
}

/// x of the middle of the grip of the last slider, for the given value [pixels]. ImGui does not provide it.
float grip_x(const commands::Limits& range, double value) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = 2.0f + 0.5f * style.GrabMinSize;
    const double part = std::clamp((value - range.lowest) / (range.highest - range.lowest), 0.0, 1.0);
    const float left = ImGui::GetItemRectMin().x + margin, right = ImGui::GetItemRectMax().x - margin;
    return left + static_cast<float>(part) * (right - left);
}

/// Row of a value that follows from the settings and cannot be edited.
void derived_row(PanelContext& context, const char* label, const char* item, const std::string& words,
                 const char* tip) {
    row_label(context.theme, label, tip);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.c_str());
    context.items.mark(item);
}

/// Row of the frequency error of the present step, with the state of its check.
void draw_frequency_error(PanelContext& context, const commands::StepQuality& quality) {
    const platform::Theme& theme = context.theme;
    row_label(theme, "Frequency error",
              "Share by which the step slows this vibration. The error of a modulus fitted to it is twice as large: "
              "see \"Is the time step short enough?\" in Checks.");
    ImGui::AlignTextToFramePadding();
    // The state uses the same limits as the check of the time step.
    const std::string share = plot::value_label(100.0 * quality.frequency_error, 2) + " %";
    check_text(theme, quality.state, share + ": " + commands::check_word(quality.state));
    context.items.mark("model/frequency_error");
}

/// A bar along the foot of the last item, the slider: green up to the critical value and orange beyond it.
void draw_stable_range(PanelContext& context, const commands::Limits& range, double critical) {
    const platform::Theme& theme = context.theme;
    const float from = grip_x(range, range.lowest), limit = grip_x(range, critical), to = grip_x(range, range.highest);
    const float top = ImGui::GetItemRectMin().y, bottom = ImGui::GetItemRectMax().y,
                strip = bottom - std::round(4.0f * theme.scale);
    ImDrawList& drawing = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemVisible()) {
        drawing.AddRectFilled({from, strip}, {limit, bottom}, platform::packed(theme.success));
        context.items.add("model/velocity_force/stable", {{from, top}, {limit, bottom}});
        // The slider may end before the critical value: everything it can reach is stable.
        if (limit < to) {
            drawing.AddRectFilled({limit, strip}, {to, bottom}, platform::packed(theme.warning));
            drawing.AddLine({limit, top}, {limit, bottom}, platform::packed(theme.text), std::max(1.0f, theme.scale));
            context.items.add("model/velocity_force/unstable", {{limit, top}, {to, bottom}});
        }
    }
}

/// Tooltip of the curve, and its item for tests.
void explain_measured_damping(PanelContext& context, const plot::PlotResult& drawn) {
    context.items.add("model/measured_damping", drawn.area.pixels);
    // Not while the line is dragged.
    if (drawn.hovered && !drawn.active)
        tooltip(context.theme,
                "Measured: damping ratio of the free vibration of " +
                    plot::value_label(context.state.scene->frequency_Hz, 3) +
                    " Hz, y = exp(−ζ ω t) cos(ω_d t) fitted to the largest trace.\n"
                    "Where the curves meet, the scheme alone damps as the body does. Drag the line to set h.");
}

}  // namespace

/// Time scheme and step, what the step means for the measured vibration, the damping that the scheme adds, and the
/// velocity force with its limit of stability.
void TimePanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    setting_choice(context, "Time scheme", "model/integrator", "Integration of the equations of motion in time.",
                   state.integrators, &commands::Settings::integrator);
    // From top to bottom: the scheme and its step, what the step means, then what damps and drives the motion.
    const commands::Choice* scheme = state.integrator();
    if (scheme && scheme->has_spectral_radius) setting_rows(context, radius_fields(), edit_);
    setting_rows(context, {step_field()}, edit_);
    draw_slider(context, step_field(), commands::time_step_limits, true);
    draw_step_choice(context);
    draw_step_state(context);
    draw_numerical_damping(context);
    setting_rows(context, {velocity_force_field()}, edit_);
    const commands::Limits range = slider_range(state);
    draw_slider(context, velocity_force_field(), range, false);
    if (state.critical_velocity_force_1_s) draw_stability(context, range);
    draw_preview_rows(context, preview_edit_);
}

void TimePanel::draw_slider(PanelContext& context, const SettingField& field, commands::Limits range,
                            bool logarithmic) {
    commands::Settings settings = context.state.settings;
    const double unit = commands::find_unit(field.field.dimension, field.field.unit)->si();
    double shown = settings.*field.value / unit;
    bool goes_on = false;
    if (!slider_row(context, field.field.name + "/slider", {range.lowest / unit, range.highest / unit}, logarithmic,
                    slide_, shown, goes_on))
        return;
    settings.*field.value = shown * unit;
    context.emit(commands::ChangeSettings{settings, field.field.name, goes_on});
}

/// Without an open scene there is no recording from which the program could choose.
void TimePanel::draw_step_choice(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (!state.scene) return;  // without a trial the program has nothing to choose by
    row_label(
        context.theme, "Automatic",
        "The program chooses the step: half the interval of the recording at first, and a shorter one after a run "
        "whose vibration requires it; calibration and diagnosis choose their own. A step that you set is kept.");
    bool automatic = !state.settings.own_step;
    // Switching to automatic restores the scene's step; the next run may shorten it.
    if (ImGui::Checkbox("##automatic", &automatic)) {
        commands::Settings settings = state.settings;
        settings.own_step = !automatic;
        if (automatic) settings.time_step_s = state.scene->settings.time_step_s;
        context.emit(commands::ChangeSettings{settings, "model/time_step"});
    }
    context.items.mark("model/automatic_step");
}

/// Compares the step with the recording and with the vibration. Left out for schemes without an estimate of their
/// frequency error.
void TimePanel::draw_step_state(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::Choice* const scheme = state.integrator();
    const commands::SceneTrial* const trial = state.scene_trial();
    if (!scheme || !scheme->step_quality || !trial) return;
    const double h = state.settings.time_step_s, interval = commands::sample_interval_s(*trial);
    if (interval > 0.0)
        derived_row(context, "Recorded every", "model/interval",
                    plot::value_label(1e3 * interval, 3) + " ms: " + plot::plain_label(interval / h, 3) + " steps",
                    "Interval between the samples of the shown trial, and how many steps it takes.");
    // The vibration of the shown trial's run, if there is one; otherwise the measured one.
    const commands::SimulatedTrial* const run = state.trial_of(state.run.get());
    const double frequency_Hz = run && run->vibration_Hz > 0.0 ? run->vibration_Hz : state.scene->frequency_Hz;
    // Without a vibration there is no period to resolve.
    const bool swings = frequency_Hz > 0.0;
    const std::string period = plot::value_label(1.0 / (frequency_Hz * h), 2) + " steps";
    derived_row(
        context, "Vibration", "model/vibration",
        swings ? plot::value_label(frequency_Hz, 3) + " Hz: " + period : "none",
        "The vibration that moves the markers most, and the number of steps in its period: from the run of the shown "
        "trial or, before a run, from the recordings.");
    if (!swings) return;
    const commands::StepQuality quality = scheme->step_quality(2.0 * std::numbers::pi * frequency_Hz, state.settings);
    draw_frequency_error(context, quality);
}

/// Drawn over the slider that was submitted last, so it has to be called right after it.
void TimePanel::draw_stability(PanelContext& context, commands::Limits range) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    // May be infinite: then the whole slider is green.
    const double critical = *state.critical_velocity_force_1_s;
    draw_stable_range(context, range, critical);
    tooltip(theme, "Green: a vibration of " + plot::value_label(state.damping_frequency_Hz, 3) +
                       " Hz decays. Orange: it grows without bound. The line is \xce\x9b_crit, where a step's largest "
                       "eigenvalue has size 1.\n\nFor implicit Euler \xce\x9b_crit = h \xcf\x89\xc2\xb2 + 2 \xce\xb6 "
                       "\xcf\x89 with the material's \xce\xb6 = \xcf\x84 \xcf\x89 / 2: "
                       "the longer the step, the more energy it removes, and the more can be supplied.");
    row_label(theme, "Critical \xce\x9b",
              "\xce\x9b_crit, the largest stable \xce\x9b of this scheme at this step and frequency.");
    ImGui::AlignTextToFramePadding();
    const std::string text = std::isfinite(critical)
                                 ? plot::value_label(critical, 3) + " 1/s" + (state.is_unstable() ? ": unstable" : "")
                                 : "stable for every \xce\x9b";
    ImGui::TextColored(state.is_unstable() ? theme.warning : theme.text, "%s", text.c_str());
    context.items.mark("model/critical_velocity_force");
}

/// The damping ratio at one frequency, which the user can change, and the curve over the step below it.
void TimePanel::draw_numerical_damping(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::Choice* const scheme = state.integrator();
    if (!scheme || !scheme->numerical_damping_ratio) return;
    const double frequency = state.damping_frequency_Hz;
    const double ratio = scheme->numerical_damping_ratio(2.0 * std::numbers::pi * frequency, state.settings);
    row_label(context.theme, "Damping ratio \xce\xb6(h)",
              "Damping ratio that the time scheme itself adds at this frequency and step.\n\nFor implicit Euler "
              "\xce\xb6 \xe2\x89\x88 \xcf\x89 h / 2: "
              "half the step, half the damping. Measured silicone has about 0.05.");
    ImGui::AlignTextToFramePadding();
    // Comparable to the damping of silicone: a calibration would attribute it to the material.
    const ImVec4 color = ratio > 0.02 ? context.theme.warning : context.theme.text;
    ImGui::TextColored(color, "%s at", plot::value_label(ratio, 3).c_str());
    context.items.mark("model/numerical_damping");
    ImGui::SameLine();
    // The frequency is edited in the rest of the row.
    ImGui::SetNextItemWidth(-1.0f);
    double shown = frequency;
    bool goes_on = false;
    if (number_field(context, damping_frequency_field(), edit_, shown, goes_on))
        context.emit(commands::SetDampingFrequency{shown});
    draw_damping_curve(context, *scheme);
}

void TimePanel::update_damping_curve(const CurveKey& key, commands::Settings settings, const commands::Choice& scheme) {
    curve_key_ = key;
    // Up to 20 ms, or to the limit of the step if the present one is longer.
    step_ms_ = Eigen::VectorXd::LinSpaced(41, 0.0, 1e3 * key.longest_s);
    // The schemes are not defined for a step of zero.
    step_ms_(0) = 1e3 * commands::time_step_limits.lowest;
    ratio_.resize(step_ms_.size());
    for (Eigen::Index i = 0; i < ratio_.size(); ++i) {
        settings.time_step_s = 1e-3 * step_ms_(i);
        ratio_(i) = scheme.numerical_damping_ratio(2.0 * std::numbers::pi * key.frequency_Hz, settings);
    }
    // Another curve: the zoom of the last one has no meaning for it.
    axis_ = {};
    plot_ = {};
}

plot::Plot TimePanel::damping_plot(const PanelContext& context, double measured) const {
    const platform::Theme& theme = context.theme;
    plot::Plot plot;
    plot.id = "damping";
    plot.x = {.label = "h", .unit = "ms"};
    // The range begins at zero and does not magnify a scheme without damping.
    plot.panel.y = {.label = "\xce\xb6 over h", .include = {0.0, 0.01}};
    plot.legend = true;
    plot.panel.series.push_back(plot::plot_series("scheme", step_ms_, ratio_, theme.simulated));
    if (std::isfinite(measured))
        plot.panel.series.push_back(plot::plot_series("measured " + plot::value_label(measured, 2), step_ms_,
                                                      Eigen::VectorXd::Constant(step_ms_.size(), measured),
                                                      theme.measured));
    plot.cursor = 1e3 * context.state.settings.time_step_s;
    return plot;
}

/// Where the curve of the scheme meets the measured damping, the scheme alone damps as much as the body.
void TimePanel::draw_damping_curve(PanelContext& context, const commands::Choice& scheme) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    constexpr double usual_longest_s = 0.02;
    // The curve takes one evaluation of the scheme per point, so it is kept until one of its inputs changes.
    const CurveKey key{
        scheme.id, state.settings.spectral_radius, state.damping_frequency_Hz,
        state.settings.time_step_s <= usual_longest_s ? usual_longest_s : commands::time_step_limits.highest};
    if (!(key == curve_key_)) update_damping_curve(key, state.settings, scheme);
    const double measured = state.scene ? state.scene->damping_ratio : std::numeric_limits<double>::quiet_NaN();
    const plot::Plot plot = damping_plot(context, measured);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 150.0f * theme.scale};
    const plot::PlotResult drawn = plot::draw_plot(plot, size, theme, context.items, axis_, plot_, hidden_);
    context.items.add("model/damping_curve", {corner, {corner.x + size.x, corner.y + size.y}});
    if (std::isfinite(measured)) explain_measured_damping(context, drawn);
    // Dragging the line sets the time step, rounded to hundredths of a millisecond.
    const bool goes_on = curve_edit_.goes_on("curve", drawn.cursor.has_value());
    if (!drawn.cursor) return;
    commands::Settings settings = state.settings;
    settings.time_step_s = std::clamp(1e-5 * std::round(1e2 * *drawn.cursor), 1e-5, key.longest_s);
    context.emit(commands::ChangeSettings{settings, "model/time_step", goes_on});
}

}  // namespace myo::ui::panels
