#include "diagnosis/screening/probe_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "inverse/bounded_step.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Amount of a probe of one column, in the unit of its parameter.
double amount_of(const effect::EffectProbe& probe) { return effect::number(probe.columns.front(), probe.amount); }

/// Parameters of a single-column probe with `multiple` times the effect. Returns false if the amount would be zero, not
/// finite, or of a sign that its bounds exclude.
bool scaled(const effect::Effect& effect, const effect::EffectProbe& probe, double multiple,
            effect::EffectParameters& result) {
    const effect::EffectParameterEntry& entry = *effect.parameter(probe.amount);
    result = probe.columns.front();
    // A reciprocal amount (a stiffness that is infinite without the effect) has its effect in 1 / amount.
    const double value = probe.reciprocal ? amount_of(probe) / multiple : amount_of(probe) * multiple;
    if (!std::isfinite(value) || value == 0.0) return false;
    // A negative multiple of an amount that cannot be negative: the probe explains nothing.
    if (entry.lowest >= 0.0 && value <= 0.0) return false;
    result[probe.amount] = std::clamp(value, entry.lowest, entry.highest);
    return true;
}

/// Range of the multiple of a probe that keeps its amount within bounds. Negative multiples are admitted only for
/// joined columns and for amounts that may be negative.
struct Range {
    double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
};
Range multiples_of(const effect::Effect& effect, const effect::EffectProbe& probe) {
    if (probe.amount.empty()) return {};
    const effect::EffectParameterEntry& entry = *effect.parameter(probe.amount);
    const double amount = amount_of(probe);
    if (probe.joined) return {-entry.highest / std::abs(amount), entry.highest / std::abs(amount)};
    // With a negative amount the upper bound limits the negative multiples.
    if (entry.lowest < 0.0)
        return amount > 0.0 ? Range{entry.lowest / amount, entry.highest / amount}
                            : Range{entry.highest / amount, entry.lowest / amount};
    return {0.0, probe.reciprocal ? amount / entry.lowest : entry.highest / amount};
}

/// Starts of a nonlinear probe: the amount that changes the residual by its own norm and, if distinct, the amount of
/// the probe, each with the step of the fit's parameters that best compensates it.
std::vector<EffectScore::Start> nonlinear_starts_of(const effect::Effect& effect, const effect::EffectProbe& probe,
                                                    const VectorXd& S, const Range& range,
                                                    const ScoreReference& reference, const ScreeningPolicy& policy) {
    const JointFit& fit = reference.fit;
    // Linear extrapolation: the multiple that changes the residual by its own norm.
    const double modest = std::clamp(fit.residual.norm() / std::max(S.norm(), std::numeric_limits<double>::min()),
                                     range.lowest, range.highest);
    std::vector<EffectScore::Start> starts;
    for (const double multiple : {modest, 1.0}) {
        if (!starts.empty() && modest < policy.distinct_start && modest > 1.0 / policy.distinct_start) break;
        EffectScore::Start start;
        if (!scaled(effect, probe, multiple, start.effect)) continue;
        start.step = inverse::bounded_step(fit.jacobian, VectorXd(multiple * S), reference.lower, reference.upper);
        starts.push_back(std::move(start));
    }
    return starts;
}

/// A with one damping row for each of its last columns, those of a probe of several: a direction that is hardly
/// observable (along a thin plate) must not dominate the result.
MatrixXd with_damped_columns(const MatrixXd& A, const MatrixXd& S, double negligible_column) {
    if (S.cols() < 2) return A;
    MatrixXd damped = MatrixXd::Zero(A.rows() + S.cols(), A.cols());
    damped.topRows(A.rows()) = A;
    damped.bottomRightCorner(S.cols(), S.cols())
        .diagonal()
        .setConstant(negligible_column * S.colwise().norm().maxCoeff());
    return damped;
}

/// Bounds of the multiples of a probe's columns: those of its amount, and what the norm of the residual allows.
Range bounds_of(const VectorXd& column, const Range& range, const ScoreReference& reference,
                const ScreeningPolicy& policy) {
    const double tiny = std::numeric_limits<double>::min();
    const double most = reference.fit.residual.norm() *
                        std::min(policy.max_over_residual / std::max(column.norm(), tiny),
                                 policy.max_outside / std::max(reference.nuisance.outside(column).norm(), tiny));
    return {std::max(range.lowest, -most), std::min(range.highest, most)};
}

/// Best step of the fit's parameters and of the multiples of the columns together, within their bounds.
VectorXd best_step(const MatrixXd& A, const MatrixXd& S, const Range& range, const ScoreReference& reference,
                   const ScreeningPolicy& policy) {
    const Index own = reference.lower.size();
    const MatrixXd damped = with_damped_columns(A, S, policy.negligible_column);
    VectorXd lower(A.cols()), upper(A.cols());
    lower.head(own) = reference.lower;
    upper.head(own) = reference.upper;
    for (Index c = 0; c < S.cols(); ++c) {
        const Range bounds = bounds_of(S.col(c), range, reference, policy);
        lower(own + c) = bounds.lowest;
        upper(own + c) = bounds.highest;
    }
    VectorXd residual = VectorXd::Zero(damped.rows());
    residual.head(A.rows()) = reference.fit.residual;
    return inverse::bounded_step(damped, residual, lower, upper);
}

}  // namespace

ScoreReference score_reference(const JointFit& fit, const statistics::ResidualLayout& layout) {
    ScoreReference reference{fit, layout, statistics::NuisanceSpace(fit.jacobian), {}, {}, {}};
    reference.outside = reference.nuisance.outside(fit.residual);
    reference.lower.resize(fit.jacobian.cols());
    reference.upper.resize(fit.jacobian.cols());
    for (Index i = 0; i < fit.jacobian.cols(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[static_cast<std::size_t>(i)];
        const double value = prediction::value_of(p, fit.values);
        // A value outside its bounds by rounding must not force a step.
        reference.lower(i) = std::min(0.0, p.parameter.lower - value);
        reference.upper(i) = std::max(0.0, p.parameter.upper - value);
    }
    reference.squares = (fit.residual + fit.jacobian * inverse::bounded_step(fit.jacobian, fit.residual,
                                                                             reference.lower, reference.upper))
                            .squaredNorm();
    return reference;
}

EffectScore score_probe(const effect::Effect& effect, const effect::EffectProbe& probe, const MatrixXd& S,
                        const ScoreReference& reference, const ScreeningPolicy& policy) {
    const JointFit& fit = reference.fit;
    EffectScore score;
    score.id = effect.id;
    // The test is unbounded (its p-value has a known distribution); shares and starts below respect the bounds.
    score.candidate = statistics::project_candidate(reference.nuisance, S);
    score.test = statistics::score_test(score.candidate, reference.outside, reference.layout);
    if (score.candidate.rank() == 0) return score;
    if (!probe.joined) score.probed = probe.columns.front();
    MatrixXd A(S.rows(), fit.jacobian.cols() + S.cols());
    A << fit.jacobian, S;
    const Range range = multiples_of(effect, probe);
    const VectorXd step = best_step(A, S, range, reference, policy), multiples = step.tail(S.cols());
    score.best.step = step.head(reference.lower.size());
    const double squares = (fit.residual + A * step).squaredNorm();
    // Several columns are joined into one declaration by the effect itself, a single one is scaled.
    const bool possible = probe.joined ? multiples.allFinite() : scaled(effect, probe, multiples(0), score.best.effect);
    if (possible && probe.joined) score.best.effect = probe.joined(probe.columns, multiples);
    score.test.explained = possible && reference.squares > 0.0 ? std::max(0.0, 1.0 - squares / reference.squares) : 0.0;
    score.left = (1.0 - score.test.explained) * reference.squares;
    if (!probe.joined && S.col(0).norm() > policy.nonlinear_ratio * fit.residual.norm())
        score.nonlinear = nonlinear_starts_of(effect, probe, S.col(0), range, reference, policy);
    score.predicted = score.candidate.basis * (score.candidate.basis.transpose() * reference.outside);
    return score;
}

}  // namespace myo::diagnosis
