#pragma once

#include <optional>

#include "diagnosis/fit/joint_fit.hpp"
#include "statistics/nuisance_space.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// Size of an effect that remains after a fit of the declared parameters, for choosing a visible amount.
class EffectLevel {
public:
    /// Simulates the true fit trials without the effect, with derivatives with respect to all fitted parameters.
    /// ready() is false if that fails.
    EffectLevel(const SyntheticCase& c, setup::Setup setup, const Progress& progress = {});

    bool ready() const { return recalibrated_.has_value(); }

    /// What a recalibration of the declared parameters leaves of an effect in the marker motion, without noise.
    struct Level {
        double first_order = 0.0;  // rms after linear recalibration [noise levels]
        // In the order of the fit trials.
        std::vector<prediction::TrialPrediction> with;  // fit trials with the effect
    };
    /// Level of an effect; empty if a trial with it does not run.
    std::optional<Level> of(const effect::EffectDeclaration& effect) const;

    /// Level after a nonlinear fit [noise levels], needed if the phase drifts; 0 if the fit fails.
    double fitted(const Level& level) const;

    /// Smallest first-order level of an effect that all others of a set do not absorb either [noise levels]; empty if a
    /// trial with one of them does not run.
    std::optional<double> least_of_set(const std::vector<effect::EffectDeclaration>& effects) const;

private:
    /// Change of the residual by one more effect; empty if a trial with it does not run.
    std::optional<Eigen::VectorXd> change_by(const effect::EffectDeclaration& effect,
                                             std::vector<prediction::TrialPrediction>& with) const;

    setup::Setup setup_;
    Progress progress_;
    prediction::ParameterValues without_;
    diagnosis::FitData data_;
    diagnosis::WarmStart warm_start_;  // of the fit trials without the effect
    std::optional<statistics::NuisanceSpace> recalibrated_;
    Eigen::VectorXd without_effect_;  // residual of the fit trials without the effect
};

/// An effect of a case with an amount whose level is close to the wanted one; empty if no plausible amount has one.
///
/// @param which  index of the effect
/// @param level  receives the level reached [noise levels]
std::optional<effect::EffectDeclaration> visible_effect(const SyntheticCase& c, std::size_t which,
                                                        const EffectLevel& levels, double& level);

}  // namespace myo::validation
