#include "loop/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/autocorrelation.hpp"
#include "diagnosis/evidence.hpp"
#include "diagnosis/linear_cross_validation.hpp"

namespace myo {
namespace {

/// Systematic residuals below this share of the noise are nobody's concern: two simulators of one model differ by as much.
constexpr double least_systematic = 0.3;
/// Up to here they may, on thin bodies, and are put down to it where nothing takes them away.
constexpr double faint = 0.5;
/// Where little is left of the mesh's error after extrapolation, it may really be twice as much, up to this [noise levels].
constexpr double rough = 2.0, most_rough = 0.8;
/// A mesh whose error is larger excuses nothing: it has to be refined.
constexpr double most_allowed = 1.0;
/// What a fit leaves may be so many times what is left of the mesh's error: that was extrapolated.
constexpr double generous = 1.5;
/// Of a faint residual an effect has to take away half: what two simulators of one model differ by is mimicked by many.
constexpr double most_of_what_is_faint = 0.5;
/// What an effect leaves, over what was there: another program's form of the same effect differs by as much.
constexpr double share_of_form = 0.05;
/// Criteria of dynamic fits exaggerate, as their residuals share errors of the model's form; see evidence_weights().
constexpr double temperature = 8.0;
/// Longest memory of a residual that a guard between blocks of time has to bridge [s].
constexpr double guard_s = 0.05;

std::vector<JudgedFit*> single_fits(Diagnosis& d) {
    std::vector<JudgedFit*> fits{&d.declared};
    for (Candidate& candidate : d.candidates)
        if (candidate.judged) fits.push_back(&*candidate.judged);
    return fits;
}

double mean_noise_m(const FitData& data) { return std::sqrt(data.noise_m.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, data.noise_m.size()))); }

/// What the program's own errors may be after they were taken off [noise levels].
double numerical_doubt(const FitData& data, const NumericalError& numerics) { return std::min(most_allowed, numerics.left_rms_m / mean_noise_m(data)); }

bool at_bound(const StudyParameter& p, const StudyValues& values) {
    const double value = value_of(p, values), little = 1e-6 * std::abs(value);
    return value <= p.parameter.lower + little || value >= p.parameter.upper - little;
}

}  // namespace

JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings) {
    JudgedFit result;
    if (fit.usable()) {
        ResidualTestOptions options;
        options.alpha = settings.alpha;
        result.rms_m = flat_rms_m(data, fit.residual);
        result.tests = test_residuals(fit.residual, data.layout, static_cast<int>(fit.parameters.size()), options);
        FoldOptions folds;
        folds.guard_s = guard_s;
        const LinearCrossValidation of_trials = linear_cross_validation(fit.residual, fit.jacobian, make_folds(data.layout, folds));
        result.held_out_rms = std::sqrt(of_trials.mean_square());
        result.told_by_one = of_trials.undetermined();
        result.held_out_in_time_rms = std::sqrt(linear_cross_validation(fit.residual, fit.jacobian, time_folds(data.layout, folds)).mean_square());
    }
    result.fit = std::move(fit);
    return result;
}

void weigh(const FitData& data, const std::vector<JudgedFit*>& fits) {
    const JudgedFit* best = nullptr;
    for (const JudgedFit* fit : fits)
        if (fit->usable() && (!best || fit->fit.squares() < best->fit.squares())) best = fit;
    if (!best) return;
    const auto samples = static_cast<double>(data.layout.size());
    const double effective = effective_samples(best->fit.residual, data.layout);
    const auto compare = [&](double JudgedFit::*held_out) {
        for (JudgedFit* fit : fits) {
            fit->criterion = std::numeric_limits<double>::infinity();
            if (fit->usable())
                fit->criterion = 0.5 * (information_criterion(fit->fit.squares(), samples, effective, static_cast<int>(fit->fit.parameters.size())) +
                                        information_criterion(samples * std::pow(fit->*held_out, 2), samples, effective, 0));
        }
    };
    const auto order = [](const JudgedFit* a, const JudgedFit* b) { return a->criterion < b->criterion; };
    compare(&JudgedFit::held_out_rms);
    // What one trial alone tells of is not tested by holding that out: a fit that is best by it is compared by blocks of time.
    int least_told = std::numeric_limits<int>::max();
    for (const JudgedFit* fit : fits)
        if (fit->usable()) least_told = std::min(least_told, fit->told_by_one);
    if ((*std::min_element(fits.begin(), fits.end(), order))->told_by_one > least_told)
        compare(&JudgedFit::held_out_in_time_rms);
    std::vector<double> criteria;
    for (const JudgedFit* fit : fits) criteria.push_back(fit->criterion);
    const std::vector<double> weights = evidence_weights(criteria, temperature);
    for (std::size_t i = 0; i < fits.size(); ++i) fits[i]->weight = weights[i];
}

void order_candidates(Diagnosis& d) {
    weigh(d.data, single_fits(d));
    std::stable_sort(d.candidates.begin(), d.candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.judged.has_value() != b.judged.has_value()) return a.judged.has_value();
        if (a.judged) return a.judged->criterion < b.judged->criterion;
        return a.score.share() > b.score.share();
    });
}

void order_pairs(Diagnosis& d) {
    std::vector<JudgedFit*> all = single_fits(d);
    for (JudgedFit& pair : d.pairs) all.push_back(&pair);
    weigh(d.data, all);
    std::stable_sort(d.pairs.begin(), d.pairs.end(), [](const JudgedFit& a, const JudgedFit& b) { return a.criterion < b.criterion; });
}

double numerical_allowance(const FitData& data, const NumericalError& numerics) {
    const double doubt = numerical_doubt(data, numerics);
    return std::max({least_systematic, doubt, std::min(most_rough, rough * doubt)});
}

bool modulus_at_bound(const JointFit& fit) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(),
                       [&](const StudyParameter& p) { return p.kind == StudyParameter::Kind::youngs_modulus && at_bound(p, fit.values); });
}

bool effect_at_bound(const JointFit& fit) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(),
                       [&](const StudyParameter& p) { return p.kind == StudyParameter::Kind::effect && p.component < 0 && at_bound(p, fit.values); });
}

bool needs_explanation(const JudgedFit& fit, const FitData& data, const NumericalError& numerics) {
    return fit.tests.significant() && fit.tests.systematic.rms > numerical_allowance(data, numerics);
}

bool is_faint(const JudgedFit& fit) { return fit.tests.systematic.rms <= faint; }

bool explains(const JudgedFit& fit, const JudgedFit& before, const FitData& data, const NumericalError& numerics, MeshDoubt mesh) {
    if (!fit.usable() || modulus_at_bound(fit.fit)) return false;
    const double doubt = numerical_doubt(data, fit.numerics ? *fit.numerics : numerics);
    // An effect that went as far as it may and leaves something would have gone on: the rest is neither a matter of its form nor of a doubtful mesh.
    const bool excused = !effect_at_bound(fit.fit);
    const double of_mesh = doubt * (mesh == MeshDoubt::generous && excused ? generous : 1.0), of_form = excused ? share_of_form * before.tests.systematic.rms : 0.0;
    const double allowed = std::max({least_systematic, of_mesh, of_form});
    if (fit.tests.systematic.rms > (is_faint(before) ? most_of_what_is_faint : most_of_what_was) * before.tests.systematic.rms) return false;
    return !fit.tests.significant() || fit.tests.systematic.rms <= allowed;
}

}  // namespace myo
