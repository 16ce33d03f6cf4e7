#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "report/length.hpp"
#include "reproduce/reproduction_cases.hpp"
#include "reproduce/signal_fit.hpp"

namespace myo::reproduce {
// Optimal muscle signals at 20 Hz for one recorded motion of the arm: how closely each muscle configuration can follow
// it, as published and with our model.
namespace {

constexpr double wanted_mbar = 275.0;  // middle of the sweep: a recording with ringing and a large motion

/// Limits beyond which the body buckles sideways.
MuscleConfiguration playable(MuscleConfiguration configuration) {
    configuration.lower = std::max(configuration.lower, 0.4);
    configuration.upper = std::min(configuration.upper, 2.0);
    return configuration;
}

/// Models and configurations that are compared; run_arm_dynamic() relies on their order.
std::vector<SignalVariant> arm_signal_variants(bool coarse) {
    // Damping of the same silicone in the beam: 2.7 1/s at 7.7 Hz.
    const MuscleBodyOptions own{.edge_m = coarse ? 11e-3 : 6e-3, .damping_s = 0.0023},
        published{.published = true, .edge_m = coarse ? 7e-3 : 0.0};
    MuscleBodyOptions own_single = own;
    own_single.muscles = 1;
    const int evaluations = coarse ? 8 : 40;
    return {{"AC2 as published", published, playable(tied_muscles()), 20.0, evaluations},
            {"AC1, our model", own_single, playable(one_muscle()), 20.0, evaluations},
            {"AC2, our model", own, playable(tied_muscles()), 20.0, evaluations},
            {"two signals, our model", own, playable(free_muscles()), 20.0, evaluations}};
}

/// The recording with the pressure closest to the wanted one, from the sweep if available; an empty list without
/// recordings.
Result<std::vector<RobotTrial>> recording(const ReproduceSettings& settings) {
    Result<std::vector<RobotTrial>> trials = read_arm_sweep(settings);
    if (trials && trials->empty()) trials = read_arm_steps(settings);
    if (!trials || trials->empty()) return trials;
    return std::vector<RobotTrial>{
        *std::min_element(trials->begin(), trials->end(), [](const RobotTrial& a, const RobotTrial& b) {
            return std::abs(a.pressure_mbar - wanted_mbar) < std::abs(b.pressure_mbar - wanted_mbar);
        })};
}

/// The case: signals of all variants for one recording.
Result<Reproduction> run_arm_dynamic(const ReproduceSettings& settings, const Progress& progress) {
    const Result<std::vector<RobotTrial>> trials = recording(settings);
    if (!trials) return trials.error();
    if (progress.cancelled()) return Error{"stopped", ""};
    Reproduction result;
    result.title = "Pneumatic arm: a muscle signal at 20 Hz that follows a recorded motion";
    if (trials->empty()) result.warnings.push_back(missing_data(settings, "arm_pressure_sweep"));
    if (!std::filesystem::exists(geometry_file(settings, paper_arm())))
        result.warnings.push_back(missing_geometry(settings, paper_arm()));
    // Without data or geometry there is nothing to fit; the warnings say what to fetch.
    if (!result.warnings.empty()) return result;
    const RobotTrial& trial = trials->front();
    // All variants follow the same recording in parallel.
    const Result<std::vector<SignalFit>> fits = fit_all_signals(settings, paper_arm(),
                                                                arm_signal_variants(settings.coarse), trial, progress);
    if (!fits) return fits.error();
    result.tables = {signal_table("Recording " + trial.name + ", " + format_number(trial.time_s.tail(1)(0), 3) +
                                      " s: tip centre with the signals found, to the measured one",
                                  *fits)};
    result.figures = {
        {"",
         {signal_figure("Tip centre, " + trial.name, *fits), "Below: activation of muscle 1, dashed of muscle 2."}}};
    const auto said = [&](const SignalFit& fit) {
        return report::in_mm(fit.rms_m(0)) + ", " + report::in_mm(fit.rms_m(1)) + ", " + report::in_mm(fit.rms_m(2)) +
               " mm rms in x, y, z";
    };
    const auto whole_range = [](const SignalFit& fit) {
        return format_number(1e3 * fit.range / fit.largest_rate_1_s, 3) + " ms";
    };
    // Order of arm_signal_variants().
    const SignalFit &published = (*fits)[0], &single = (*fits)[1], &tied = (*fits)[2], &both = (*fits)[3];
    result.findings = {
        "AC2 in our model follows the tip centre with " + said(tied) + ", AC1 with " + said(single) +
            ", a signal for each muscle with " + said(both) + ".",
        "As published AC2 leaves " + said(published) + ": only x and z were asked for.",
        "The signals are linear from knot to knot; where they change fastest the muscle's whole range would take " +
            whole_range(single) + " (AC1), " + whole_range(tied) + " (AC2) and " + whole_range(both) +
            " (two signals). As published the signal is held for 50 ms and then jumps, by up to " +
            format_number(100.0 * published.largest_jump / published.range, 2) + " % of its range."};
    result.values["fits"] = signal_json(*fits);
    result.values["recording"] = trial.name;
    return result;
}

}  // namespace

ReproductionCase reproduce_arm_dynamic() {
    return {"arm-dynamic", "muscle signals at 20 Hz with which the pneumatic arm follows a recorded motion (AC1, AC2)",
            run_arm_dynamic};
}

}  // namespace myo::reproduce
