#pragma once

#include <optional>

#include "diagnosis/nuisance_space.hpp"
#include "loop/joint_fit.hpp"
#include "trust/synthetic_case.hpp"

namespace myo {

/// How much of an effect a fit of the declared parameters leaves: for making it so large that it can be seen.
class EffectLevel {
public:
    /// Runs the fit trials as they truly are but without the effect, with derivatives by all that is fitted. ready() is false where that fails.
    EffectLevel(const SyntheticCase& c, Study study, const Progress& progress = {});

    bool ready() const { return recalibrated_.has_value(); }

    /// What recalibration of the declared parameters leaves of the markers' motion with an effect, without noise.
    struct Level {
        double first_order = 0.0;            // rms [noise levels]
        std::vector<TrialPrediction> with;   // the fit trials with the effect
    };
    /// None where a trial with the effect does not run.
    std::optional<Level> of(const EffectDeclaration& effect) const;

    /// The same rms left by a fit, which a phase that drifts needs; 0 where none can be made.
    double fitted(const Level& level) const;

private:
    Study study_;
    Progress progress_;
    StudyValues without_;
    FitData data_;
    Neighbourhood near_;   // of the fit trials without the effect
    std::optional<NuisanceSpace> recalibrated_;
    Eigen::VectorXd without_effect_;   // their residual
};

/// The case's effect with an amount that has about its wanted level, within the amounts that are plausible; none where there is none.
/// @param level  set to what it has
std::optional<EffectDeclaration> visible_effect(const SyntheticCase& c, const EffectLevel& levels, double& level);

}  // namespace myo
