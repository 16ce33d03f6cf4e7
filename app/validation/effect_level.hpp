#pragma once

#include <optional>

#include "diagnosis/fit/joint_fit.hpp"
#include "statistics/nuisance_space.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// How much of an effect a fit of the declared parameters leaves: for making it so large that it can be seen.
class EffectLevel {
public:
    /// Runs the fit trials as they truly are but without the effect, with derivatives by all that is fitted. ready() is
    /// false where that fails.
    EffectLevel(const SyntheticCase& c, setup::Setup setup, const Progress& progress = {});

    bool ready() const { return recalibrated_.has_value(); }

    /// What recalibration of the declared parameters leaves of the markers' motion with an effect, without noise.
    struct Level {
        double first_order = 0.0;                       // rms [noise levels]
        std::vector<prediction::TrialPrediction> with;  // the fit trials with the effect
    };
    /// None where a trial with the effect does not run.
    std::optional<Level> of(const effect::EffectDeclaration& effect) const;

    /// The same rms left by a fit, which a phase that drifts needs; 0 where none can be made.
    double fitted(const Level& level) const;

private:
    setup::Setup setup_;
    Progress progress_;
    prediction::ParameterValues without_;
    diagnosis::FitData data_;
    diagnosis::Neighbourhood near_;  // of the fit trials without the effect
    std::optional<statistics::NuisanceSpace> recalibrated_;
    Eigen::VectorXd without_effect_;  // their residual
};

/// The case's effect with an amount that has about its wanted level, within the amounts that are plausible; none where
/// there is none.
/// @param level  set to what it has
std::optional<effect::EffectDeclaration> visible_effect(const SyntheticCase& c, const EffectLevel& levels,
                                                        double& level);

}  // namespace myo::validation
