#include "validation/synthetic_experiment.hpp"

#include "base/stopwatch.hpp"
#include "experiment/read_experiment.hpp"
#include "prediction/predict_trials.hpp"
#include "validation/effect_level.hpp"
#include "validation/synthetic_folder.hpp"
#include "validation/truth_model.hpp"

namespace myo::validation {
namespace {

constexpr int max_attempts = 12;

/// First draw with a visible effect; the folder then holds its declaration with traces that do not move.
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
        if (!made.truth.effect) return made;
        Result<setup::Setup> setup = setup::prepare_setup(*experiment, {}, progress.with_sink({}));
        if (!setup) return setup.error();
        const EffectLevel levels(made.truth, std::move(*setup), progress);
        // Either the trials do not run without the effect, or no plausible amount is visible: another draw.
        if (!levels.ready()) continue;
        const std::optional<effect::EffectDeclaration> effect = visible_effect(made.truth, levels, made.level);
        if (!effect) continue;
        made.truth.effect = *effect;
        return made;
    }
    const std::string id = made.truth.effect ? made.truth.effect->id : "none";
    return Error{"no experiment in " + std::to_string(max_attempts) + " draws shows " + id + " well enough",
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
