#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "diagnosis/fit/joint_fit.hpp"
#include "planning/detection.hpp"

namespace myo::planning {

/// A set of effects that may explain an experiment, with the values of its fit.
struct Rival {
    std::vector<std::string> ids;  // empty: the declared model
    prediction::ParameterValues values;
    std::vector<prediction::ModelParameter> parameters;  // of the fit
    Eigen::MatrixXd slopes;  // of the residuals of the existing trials, rows x parameters: what they know of them
    std::vector<ErrorBlock> blocks;  // of these rows
};

/// Where the fit of a rival starts, or what it was.
struct RivalStart {
    std::vector<std::string> ids;
    std::vector<effect::EffectDeclaration> effects = {};  // as fitted, one per id; empty: they are to be fitted
    std::map<std::string, double> parameters = {};        // fitted values of the experiment's own parameters, by name
};

/// "a and b", or "the declared model".
std::string rival_words(const std::vector<std::string>& ids);

/// The rival of a fit.
/// @param fit   usable
/// @param data  to which it was fitted
Rival rival_of(const diagnosis::JointFit& fit, const diagnosis::FitData& data);

/// Rivals with the setup that holds the trials of their fits.
struct FittedRivals {
    setup::Setup setup;
    std::array<Rival, 2> rivals;
    std::array<double, 2> rms_m{};  // of the fits
    bool made_motion = false;       // no recording exists: the first that is no declared model was taken as the truth
};

/// Fits both rivals to the recordings of the setup, from the best score of each effect in the order of the set. A start
/// with fitted values is evaluated only.
///
/// Without recordings, the first rival with effects has typical amounts and the trials show what it predicts.
/// Errors: a trial or a rival cannot be run; cancelled.
Result<FittedRivals> fitted_rivals(const setup::Setup& setup, const std::array<RivalStart, 2>& starts,
                                   const Progress& progress);

}  // namespace myo::planning
