#include "validation/synthetic_experiment.hpp"

#include <algorithm>
#include <limits>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "prediction/predict_trials.hpp"
#include "validation/effect_level.hpp"
#include "validation/synthetic_folder.hpp"
#include "validation/truth_model.hpp"

namespace myo::validation {
namespace {

constexpr int max_attempts = 12;

/// Scales the effects until each is visible alone, and all of them beside the others.
///
/// @return  level of the smallest; empty if one cannot be made visible
std::optional<double> scale_effects(SyntheticCase& c, const EffectLevel& levels) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < c.effects.size(); ++i) {
        double level = 0.0;
        std::optional<effect::EffectDeclaration> effect = visible_effect(c, i, levels, level);
        if (!effect) return {};
        c.effects[i] = std::move(*effect);
        least = std::min(least, level);
    }
    if (c.effects.size() < 2) return least;
    // Twins, or effects that others make up for together, could not be found by anyone.
    const std::optional<double> beside_others = levels.least_of_set(c.effects);
    return beside_others && *beside_others > min_fitted ? std::optional(least) : std::nullopt;
}

/// First draw with visible effects; the folder then holds its declaration with traces that do not move.
Result<MadeExperiment> visible_case(const CaseChoice& choice, int number, const std::filesystem::path& folder,
                                    const Progress& progress) {
    MadeExperiment made;
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        if (progress.cancelled()) return Error{"cancelled", ""};
        made.truth = drawn_case(choice, number, attempt);
        made.attempts = attempt + 1;
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
        // Level and truth are computed from the declaration on disk, as a user would read it.
        if (const Result<void> written = write_still_experiment(made.truth, folder); !written) return written.error();
        const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
        if (!experiment) return experiment.error();
        // A case without an effect has nothing to be visible.
        if (made.truth.effects.empty()) return made;
        Result<setup::Setup> setup = setup::prepare_setup(*experiment, {}, progress.with_sink({}));
        if (!setup) return setup.error();
        const EffectLevel levels(made.truth, std::move(*setup), progress);
        // Either the trials do not run without the effect, or no plausible amount is visible: another draw.
        if (!levels.ready()) continue;
        const std::optional<double> level = scale_effects(made.truth, levels);
        if (!level) continue;
        made.level = *level;
        return made;
    }
    std::vector<std::string> ids;
    for (const effect::EffectDeclaration& effect : made.truth.effects) ids.push_back(effect.id);
    return Error{
        "no experiment in " + std::to_string(max_attempts) + " draws shows " + join(ids, " and ") + " well enough",
        made.truth.name()};
}

}  // namespace

Result<MadeExperiment> make_experiment(const CaseChoice& choice, int number, const std::filesystem::path& folder,
                                       const Progress& progress) {
    const Stopwatch watch;
    Result<MadeExperiment> made = visible_case(choice, number, folder, progress);
    if (!made) return made;
    const SyntheticCase& c = made->truth;
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
    if (!experiment) return experiment.error();
    // The truth is simulated with its own cells, step and scheme.
    const Result<setup::Setup> setup = truth_setup(c, *experiment, progress.with_sink({}));
    if (!setup) return setup.error();
    made->truth_dofs = setup->body->dofs();
    const prediction::ParameterValues values = true_values(c, *setup);
    std::vector<std::vector<Eigen::Matrix3Xd>> positions_m;
    for (std::size_t t = 0; t < setup->trials.size(); ++t) {
        const prediction::TrialPrediction prediction = prediction::predict_trial(*setup, t, values, {},
                                                                                 progress.with_sink({}));
        if (progress.cancelled()) return Error{"cancelled", ""};
        if (!prediction.ok())
            return Error{"the truth of trial " + setup->trials[t].name + " does not run: " + prediction.message,
                         c.name()};
        positions_m.push_back(prediction.positions_m);
    }
    if (const Result<void> files = write_traces(c, positions_m, folder); !files) return files.error();
    made->seconds = watch.seconds();
    return made;
}

}  // namespace myo::validation
