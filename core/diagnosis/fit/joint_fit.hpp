#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "diagnosis/fit/fit_data.hpp"
#include "inverse/least_squares.hpp"

namespace myo::diagnosis {

/// A fit of declared parameters and of effects together, with what is needed to judge it.
struct JointFit {
    std::vector<effect::EffectDeclaration>
        effects;  // those tried, with the values found; declared ones are in values alone
    std::vector<prediction::ModelParameter> parameters;
    prediction::ParameterValues values;  // with the least cost
    inverse::LeastSquaresReport report;
    Eigen::VectorXd residual;  // flat, there
    Eigen::MatrixXd jacobian;
    std::vector<prediction::TrialPrediction> predictions;  // of data.trials, without tangents and shift

    double seconds = 0.0;

    bool usable() const { return residual.size() > 0; }
    /// Approximate number of model runs: parameters that do not act in a trial need none there.
    int runs(int trials) const {
        return trials * (report.evaluations + report.jacobians * static_cast<int>(parameters.size()));
    }
    double squares() const { return residual.squaredNorm(); }
    /// Squares beyond those that noise alone gives.
    double excess() const { return std::max(0.0, squares() - static_cast<double>(residual.size())); }
};

/// What is known near where a fit starts: derivatives of the flat residual by numbers, and motions.
struct Neighbourhood {
    std::vector<std::string> names;                                 // of the numbers
    Eigen::MatrixXd columns;                                        // N x names
    std::vector<std::shared_ptr<const dynamics::StagePath>> paths;  // of data.trials; null: none
};
Neighbourhood neighbourhood_of(const JointFit& fit);

/// Rms by which predictions differ between two fits of the same numbers, to first order, in units of the noise.
double change_between(const JointFit& a, const JointFit& b);

/// What a fit moves of the effects it tries: the first parameter of each says how much there is of it, others where and
/// how.
enum class EffectFreedom { amount, all };

/// Levenberg-Marquardt on the data from `start`, whose effects beyond those of the experiment are fitted, too.
///
/// setup.settings.threads trials side by side. Effects' vectors are held near their start by a weak prior of ten times
/// their scale: the data see a place on a surface in two directions only. What is known there saves runs and
/// iterations.
JointFit joint_fit(const setup::Setup& setup, const FitData& data, const prediction::ParameterValues& start,
                   EffectFreedom freedom, const inverse::LeastSquaresOptions& options, const Neighbourhood& known,
                   const Progress& progress);

/// The declared parameters' and the tried effects' ones.
std::vector<prediction::ModelParameter> joint_parameters(const setup::Setup& setup,
                                                         const prediction::ParameterValues& start,
                                                         EffectFreedom freedom = EffectFreedom::all);

}  // namespace myo::diagnosis
