#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "chart/svg.hpp"
#include "dynamics/numerical_damping.hpp"
#include "reproduce/real_beam.hpp"
#include "reproduce/reproduction_cases.hpp"
#include "reproduce/ringing_beam.hpp"

namespace myo::reproduce {
// Numerical damping of implicit Euler, simulated and from the paper's formula, compared with the damping of the real
// beam; TR-BDF2 at the same steps as reference.
namespace {

/// Frequency [Hz] of an angular frequency [rad/s].
double hertz(double omega) { return omega / (2.0 * std::numbers::pi); }

/// Releases of one beam with one integrator, at every time step. Not a setup::Setup.
struct Setup {
    RingingBeam beam;
    dynamics::TimeScheme scheme;
    std::vector<Result<RungBeam>> runs;

    // Damping ratios at time step i of paper_steps_s, simulated and by the formula.
    double ratio(std::size_t i) const { return runs[i]->vibration.damping_ratio(); }
    double formula(std::size_t i) const {
        return dynamics::implicit_euler_numerical_damping(beam.mode.omega_rad_s, paper_steps_s[i]);
    }
};

/// Releases of our beam and the published one with implicit Euler, and of our beam with TR-BDF2.
Result<std::vector<Setup>> simulate_all(const ReproduceSettings& settings, const Progress& progress) {
    PaperBeam own;
    if (settings.coarse) own.cells = {7, 2, 2};
    // Equilibrium and mode are found once per beam, before the runs in parallel.
    const Result<RingingBeam> honest = ringing_beam(own),
                              published = ringing_beam(published_hex_beam(settings.coarse ? 6 : 23));
    if (!honest) return honest.error();
    if (!published) return published.error();
    // No damping in the material: what decays is numerical.
    std::vector<Setup> studies{{*honest, dynamics::Integrator::implicit_euler, {}},
                               {*published, dynamics::Integrator::implicit_euler, {}},
                               {*honest, dynamics::Integrator::tr_bdf2, {}}};
    for (Setup& setup : studies) setup.runs.assign(paper_step_count, Error{"not run", ""});
    const int count = static_cast<int>(studies.size() * paper_step_count);
    std::atomic<int> done{0};
    parallel_tasks(count, settings.threads, [&](int task) {
        Setup& setup = studies[static_cast<std::size_t>(task) / paper_step_count];
        const std::size_t i = static_cast<std::size_t>(task) % paper_step_count;
        if (!progress.cancelled())
            setup.runs[i] = ring(setup.beam, {.scheme = setup.scheme, .h_s = paper_steps_s[i]}, progress);
        progress.report({"releases", static_cast<double>(++done), static_cast<double>(count), "runs", ""});
    });
    for (const Setup& setup : studies)
        for (const Result<RungBeam>& run : setup.runs)
            if (!run) return run.error();
    return studies;
}

/// Damping ratios per time step, simulated and by the formula.
report::Table ratio_table(const std::vector<Setup>& studies) {
    report::Table table{"Damping ratio of the first vibration over the time step, nothing in the model damps",
                        {{"h", "ms", 3},
                         {"formula, our beam", "", 4},
                         {"implicit Euler, our beam", "", 4},
                         {"off by", "%", 2},
                         {"formula, as published", "", 4},
                         {"implicit Euler, as published", "", 4},
                         {"off by", "%", 2},
                         {"TR-BDF2, our beam", "", 4}},
                        {}};
    for (std::size_t i = 0; i < paper_step_count; ++i) {
        const auto off = [&](const Setup& setup) { return 100.0 * (setup.ratio(i) / setup.formula(i) - 1.0); };
        table.rows.push_back({1e3 * paper_steps_s[i], studies[0].formula(i), studies[0].ratio(i), off(studies[0]),
                              studies[1].formula(i), studies[1].ratio(i), off(studies[1]), studies[2].ratio(i)});
    }
    return table;
}

/// Damping ratio over the time step as SVG: formula as curves, simulations as dots.
///
/// @param measured  of the real beam; NaN: unknown, no line
std::string ratio_figure(const std::vector<Setup>& studies, double measured) {
    chart::Series formula{.name = "the paper's formula, our beam"},
        published_formula{.name = "the same, as published", .style = chart::SeriesStyle::dashed},
        measured_line{.name = "real beam",
                      .x = {0.0, 21.0},
                      .y = {measured, measured},
                      .style = chart::SeriesStyle::dashed,
                      .colour = chart::ink_colour};
    // Steps from 0 to 21 ms in quarters of a millisecond.
    for (int k = 0; k <= 84; ++k) {
        formula.x.push_back(0.25 * k);
        published_formula.x.push_back(0.25 * k);
        formula.y.push_back(dynamics::implicit_euler_numerical_damping(studies[0].beam.mode.omega_rad_s, 0.25e-3 * k));
        published_formula.y.push_back(
            dynamics::implicit_euler_numerical_damping(studies[1].beam.mode.omega_rad_s, 0.25e-3 * k));
    }
    chart::Panel panel{.y = {.label = "damping ratio", .include_zero = true},
                       .series = {formula, published_formula},
                       .height_px = 300.0};
    const char* const names[] = {"implicit Euler, our beam", "implicit Euler, as published", "TR-BDF2, our beam"};
    for (std::size_t s = 0; s < studies.size(); ++s) {
        chart::Series dots{.name = names[s], .style = chart::SeriesStyle::dots};
        for (std::size_t i = 0; i < paper_step_count; ++i) {
            dots.x.push_back(1e3 * paper_steps_s[i]);
            dots.y.push_back(studies[s].ratio(i));
        }
        panel.series.push_back(dots);
    }
    if (std::isfinite(measured)) panel.series.push_back(measured_line);
    return chart::svg(chart::Chart{.title = "Numerical damping over the time step",
                                   .x = {.label = "time step", .unit = "ms", .lowest = 0.0},
                                   .panels = {panel}});
}

/// First second of the Left marker after the release, as a series; t [s], dz [m].
chart::Series left_series(const std::string& name, const Eigen::VectorXd& t, const Eigen::VectorXd& dz) {
    chart::Series series{.name = name};
    for (Eigen::Index k = 0; k < t.size(); ++k)
        if (t(k) >= 0.0 && t(k) <= 1.0) {
            series.x.push_back(t(k));
            series.y.push_back(dz(k));
        }
    return series;
}

/// The paper's figure of case A-1, and below it the same steps with a second-order method.
std::string trace_figure(const std::vector<Setup>& studies, const std::vector<BeamTrial>& trials) {
    chart::Chart chart{.title = "Left tip point after the release", .x = {.label = "time", .unit = "s"}, .panels = {}};
    for (const std::size_t s : {std::size_t{0}, std::size_t{2}}) {
        chart::Panel panel{.y = {.label = s == 0 ? "dz, implicit Euler" : "dz, TR-BDF2", .unit = "m"}, .series = {}};
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{7}}) {
            const RungBeam& run = *studies[s].runs[i];
            panel.series.push_back(
                left_series("h = " + format_number(1e3 * paper_steps_s[i], 3) + " ms", run.times_s, run.left_dz_m));
        }
        if (!trials.empty()) {
            panel.series.push_back(
                left_series("real beam", trials[0].time_s, trials[0].displacement_m[left_marker].row(2).transpose()));
            panel.series.back().colour = chart::ink_colour;
        }
        chart.panels.push_back(panel);
    }
    return chart::svg(chart);
}

/// Time step [s] at which implicit Euler by itself damps with this ratio, by bisection up to 0.1 s; the ratio grows
/// with the step.
double step_of_ratio(double omega, double ratio) {
    double low = 0.0, high = 0.1;
    while (high - low > 1e-7) {
        const double middle = 0.5 * (low + high);
        (dynamics::implicit_euler_numerical_damping(omega, middle) < ratio ? low : high) = middle;
    }
    return low;
}

/// Largest relative error of the formula over all steps.
double largest_error(const Setup& setup) {
    double largest = 0.0;
    for (std::size_t i = 0; i < paper_step_count; ++i)
        largest = std::max(largest, std::abs(setup.ratio(i) / setup.formula(i) - 1.0));
    return largest;
}

/// Vibrations fitted to the real beam, and the mean of their damping ratios.
struct MeasuredDamping {
    report::Table table{
        "The real beam without a weight: a damped vibration fitted to its Left marker, from 0.065 s to 1.5 s after the "
        "release",
        {{"recording"},
         {"frequency", "Hz", 4},
         {"decay", "1/s", 4},
         {"damping ratio", "", 3},
         {"left over, rms", "mm", 2}},
        {}};
    double ratio = 0.0;  // NaN without recordings
};

/// Fits every recording; the ratio is the mean, NaN without recordings.
MeasuredDamping measured_damping(const std::vector<BeamTrial>& trials) {
    MeasuredDamping measured;
    for (const BeamTrial& trial : trials) {
        const inverse::DampedCosine vibration = measured_vibration(trial);
        measured.ratio += vibration.damping_ratio() / static_cast<double>(trials.size());
        measured.table.rows.push_back({trial.name, hertz(vibration.omega_rad_s), vibration.rate_1_s,
                                       vibration.damping_ratio(), 1e3 * vibration.rms});
    }
    if (trials.empty()) measured.ratio = std::nan("");
    return measured;
}

/// The results in sentences.
///
/// @param measured  damping ratio of the real beam; NaN: unknown
std::vector<std::string> damping_findings(const std::vector<Setup>& studies, double measured) {
    const double omega = studies[0].beam.mode.omega_rad_s;
    // Largest damping of TR-BDF2, in magnitude: rounding may make it negative.
    double second_order = 0.0;
    for (std::size_t i = 0; i < paper_step_count; ++i)
        second_order = std::max(second_order, std::abs(studies[2].ratio(i)));
    std::vector<std::string> findings{
        "The simulated damping of implicit Euler follows the paper's formula within " +
            format_number(100.0 * largest_error(studies[0]), 2) + " % on our beam (" + format_number(hertz(omega), 4) +
            " Hz) and within " + format_number(100.0 * largest_error(studies[1]), 2) + " % on the beam as published (" +
            format_number(hertz(studies[1].beam.mode.omega_rad_s), 4) + " Hz).",
        "TR-BDF2 adds at 10 ms a damping ratio of " + format_number(studies[2].ratio(3), 2) + ", " +
            std::to_string(std::lround(studies[0].ratio(3) / studies[2].ratio(3))) +
            " times less than implicit Euler's " + format_number(studies[0].ratio(3), 3) +
            "; the most at any of these steps is " + format_number(second_order, 2) + "."};
    if (std::isfinite(measured))
        findings.push_back("The real beam swings with a damping ratio of " + format_number(measured, 3) +
                           ": implicit Euler damps by itself as much at h = " +
                           format_number(1e3 * step_of_ratio(omega, measured), 3) +
                           " ms, and more at all longer steps, whatever the material.");
    return findings;
}

/// The case: releases at all steps, the formula, and the real beam without a weight.
Result<Reproduction> run_numerical_damping(const ReproduceSettings& settings, const Progress& progress) {
    const Result<std::vector<BeamTrial>> all = read_beam_trials(settings);
    if (!all) return all.error();
    std::vector<BeamTrial> trials;
    std::copy_if(all->begin(), all->end(), std::back_inserter(trials),
                 [](const BeamTrial& trial) { return trial.tip_force_N == 0.0; });
    const Result<std::vector<Setup>> simulated = simulate_all(settings, progress);
    if (!simulated) return simulated.error();
    // Order of simulate_all(): our beam, the published one, our beam with TR-BDF2.
    const std::vector<Setup>& studies = *simulated;

    Reproduction result;
    result.title = "Numerical damping of implicit Euler";
    if (trials.empty()) result.warnings.push_back(missing_data(settings, "beam"));
    const auto [real, measured] = measured_damping(trials);
    result.tables = {ratio_table(studies)};
    if (!trials.empty()) result.tables.push_back(real);
    result.findings = damping_findings(studies, measured);
    result.figures.push_back({"",
                              {ratio_figure(studies, measured),
                               "Damping ratio over time step: the paper's formula at the frequency of each beam, "
                               "simulated releases, and the real beam."}});
    result.figures.push_back(
        {"trace",
         {trace_figure(studies, trials),
          "The paper's case A-1 for a selection of time steps, and the same with a method of second order."}});
    result.values = {{"measured_damping_ratio", report::json_number(measured)},
                     {"our_frequency_Hz", hertz(studies[0].beam.mode.omega_rad_s)},
                     {"published_frequency_Hz", hertz(studies[1].beam.mode.omega_rad_s)},
                     {"largest_error_our_beam", largest_error(studies[0])},
                     {"largest_error_as_published", largest_error(studies[1])},
                     {"tr_bdf2_ratio_at_10_ms", studies[2].ratio(3)},
                     {"our_dofs", studies[0].beam.model.body->dofs()},
                     {"published_dofs", studies[1].beam.model.body->dofs()}};
    return result;
}

}  // namespace

ReproductionCase reproduce_numerical_damping() {
    return {"numerical-damping",
            "damping ratio of implicit Euler over the time step: simulated, by the paper's formula, and measured",
            run_numerical_damping};
}

}  // namespace myo::reproduce
