#include "base/text.hpp"
#include "report/length.hpp"
#include "reproduce/reproduction_cases.hpp"
#include "reproduce/signal_fit.hpp"

namespace myo::reproduce {
// Optimal muscle signals at 5 Hz for a recorded motion of the fish tail; the motion starts faster than the knots, which
// limits the accuracy.
namespace {

/// Models and configurations that are compared; run_fish() relies on their order.
std::vector<SignalVariant> fish_variants(bool coarse) {
    // Damping as in the arm, of the same silicone.
    const MuscleBodyOptions own{.edge_m = coarse ? 10e-3 : 5e-3, .damping_s = 0.0023},
        published{.published = true, .edge_m = coarse ? 9e-3 : 0.0};
    MuscleConfiguration tied = tied_muscles(), free = free_muscles();
    tied.upper = 3.0;  // the body buckles sideways above
    free.lower = 0.2;
    free.upper = 3.0;
    const int evaluations = coarse ? 8 : 40;
    return {{"two muscles as published", published, tied, 5.0, evaluations},
            {"two muscles, our model", own, tied, 5.0, evaluations},
            {"two signals, our model", own, free, 5.0, evaluations}};
}

/// Time at which the marker has covered half of its largest displacement [s].
double half_way_s(const SignalFit& fit) {
    const Eigen::RowVectorXd way = fit.measured_m.colwise().norm();
    Eigen::Index k = 0;
    while (way(k) < 0.5 * way.maxCoeff()) ++k;
    return fit.times_s(k);
}

/// Share of the squared error in x before the second knot.
double early_share(const SignalFit& fit) {
    const Eigen::ArrayXd squared = (fit.simulated_m - fit.measured_m).row(0).array().square();
    return (fit.times_s.array() <= 2.0 / fit.variant.frequency_Hz).select(squared, 0.0).sum() / squared.sum();
}

/// The case: signals of all variants for the one recording.
Result<Reproduction> run_fish(const ReproduceSettings& settings, const Progress& progress) {
    const Result<std::vector<RobotTrial>> trials = read_fish(settings);
    if (!trials) return trials.error();
    if (progress.cancelled()) return Error{"stopped", ""};
    Reproduction result;
    result.title = "Fish tail: muscle signals at 5 Hz that follow a recorded motion";
    if (trials->empty()) result.warnings.push_back(missing_data(settings, "fish"));
    if (!std::filesystem::exists(geometry_file(settings, paper_fish())))
        result.warnings.push_back(missing_geometry(settings, paper_fish()));
    // Without data or geometry there is nothing to fit; the warnings say what to fetch.
    if (!result.warnings.empty()) return result;
    const RobotTrial& trial = trials->front();
    const Result<std::vector<SignalFit>> fits = fit_all_signals(settings, paper_fish(), fish_variants(settings.coarse),
                                                                trial, progress);
    if (!fits) return fits.error();
    result.tables = {signal_table("The marker on the spine with the signals found, to the measured one", *fits)};
    result.figures = {{"",
                       {signal_figure("Marker on the spine of the tail", *fits),
                        "Below: activation of muscle 1, dashed of muscle 2."}}};
    const auto said = [&](const SignalFit& fit) {
        return report::in_mm(fit.rms_m(0)) + ", " + report::in_mm(fit.rms_m(1)) + ", " + report::in_mm(fit.rms_m(2)) +
               " mm rms in x, y, z";
    };
    // Order of fish_variants().
    const SignalFit &published = (*fits)[0], &tied = (*fits)[1], &both = (*fits)[2];
    result.findings = {"On a way of " + report::in_mm(tied.measured_m.colwise().norm().maxCoeff()) +
                           " mm the tied muscles follow with " + said(tied) + " in our model and " + said(published) +
                           " as published; a signal for each muscle with " + said(both) + ".",
                       "The signals are linear between knots 200 ms apart; where they change fastest the muscle's "
                       "whole range would take " +
                           format_number(1e3 * both.range / both.largest_rate_1_s, 3) +
                           " ms. The tail has half of its way behind it after " +
                           format_number(1e3 * half_way_s(both), 3) +
                           " ms: " + format_number(100.0 * early_share(both), 3) +
                           " % of the squared error in x lies within the first two knots."};
    result.values["fits"] = signal_json(*fits);
    result.values["recording"] = trial.name;
    return result;
}

}  // namespace

ReproductionCase reproduce_fish() {
    return {"fish", "muscle signals at 5 Hz with which the fish tail follows a recorded motion", run_fish};
}

}  // namespace myo::reproduce
