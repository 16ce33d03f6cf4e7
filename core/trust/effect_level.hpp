#pragma once

#include <functional>
#include <optional>

#include "loop/joint_fit.hpp"
#include "trust/synthetic_case.hpp"

namespace myo {

/// How much of an effect a fit of the declared parameters leaves: for making it so large that it can be seen.
class EffectLevel {
public:
    /// Runs the fit trials as they truly are but without the effect, with derivatives by all that is fitted. ready() is false where that fails.
    EffectLevel(const SyntheticCase& c, Study study, const Progress& progress = {});

    bool ready() const { return near_.columns.size() > 0; }

    /// rms of what recalibration of the declared parameters leaves of the markers' motion with the effect, without noise [noise levels]: to
    /// first order, and by a fit, which a phase that drifts needs. None where a trial with the effect does not run.
    struct Level {
        double first_order = 0.0;
        std::function<std::optional<double>()> fitted;   // while the levels live
    };
    std::optional<Level> of(const EffectDeclaration& effect) const;

private:
    std::optional<double> fitted(const std::vector<TrialPrediction>& with) const;

    Study study_;
    Progress progress_;
    StudyValues without_;
    FitData data_;
    Neighbourhood near_;   // of the fit trials without the effect
    Eigen::VectorXd without_effect_;   // their residual
};

/// The case's effect with an amount that has about its wanted level, within the amounts that are plausible; none where there is none.
/// @param level  set to what it has
std::optional<EffectDeclaration> visible_effect(const SyntheticCase& c, const EffectLevel& levels, double& level);

}  // namespace myo
