#include "trust/synthetic_experiment.hpp"

#include "base/stopwatch.hpp"
#include "project/predict_trials.hpp"
#include "project/read_experiment.hpp"
#include "trust/effect_level.hpp"
#include "trust/synthetic_folder.hpp"
#include "trust/truth_model.hpp"

namespace myo {
namespace {

constexpr int most_attempts = 12;

/// A case that can be seen: the first draw whose effect can be made to.
Result<MadeExperiment> visible_case(const CaseChoice& choice, int number, const std::filesystem::path& folder, const Progress& progress) {
    MadeExperiment made;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        if (progress.cancelled()) return Error{"cancelled", ""};
        made.truth = drawn_case(choice, number, attempt);
        made.attempts = attempt + 1;
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
        if (const Result<void> written = write_still_experiment(made.truth, folder); !written) return written.error();
        const Result<Experiment> experiment = read_experiment(folder);
        if (!experiment) return experiment.error();
        if (!made.truth.effect) return made;
        Result<Study> study = prepare_study(*experiment, {}, progress.with_sink({}));
        if (!study) return study.error();
        const EffectLevel levels(made.truth, std::move(*study), progress);
        if (!levels.ready()) continue;
        const std::optional<EffectDeclaration> effect = visible_effect(made.truth, levels, made.level);
        if (!effect) continue;
        made.truth.effect = *effect;
        return made;
    }
    const std::string id = made.truth.effect ? made.truth.effect->id : "none";
    return Error{"no experiment in " + std::to_string(most_attempts) + " draws shows " + id + " well enough", made.truth.name()};
}

}  // namespace

Result<MadeExperiment> make_experiment(const CaseChoice& choice, int number, const std::filesystem::path& folder, const Progress& progress) {
    const Stopwatch watch;
    Result<MadeExperiment> made = visible_case(choice, number, folder, progress);
    if (!made) return made;
    const SyntheticCase& c = made->truth;
    const Result<Experiment> experiment = read_experiment(folder);
    if (!experiment) return experiment.error();
    const Result<Study> study = truth_study(c, *experiment, progress.with_sink({}));
    if (!study) return study.error();
    made->truth_dofs = study->body->dofs();
    const StudyValues values = true_values(c, *study);
    std::vector<std::vector<Eigen::Matrix3Xd>> positions_m;
    for (std::size_t t = 0; t < study->trials.size(); ++t) {
        const TrialPrediction prediction = predict_trial(*study, t, values, {}, progress.with_sink({}));
        if (progress.cancelled()) return Error{"cancelled", ""};
        if (!prediction.ok()) return Error{"the truth of trial " + study->trials[t].name + " does not run: " + prediction.message, c.name()};
        positions_m.push_back(prediction.positions_m);
    }
    if (const Result<void> files = write_traces(c, positions_m, folder); !files) return files.error();
    made->seconds = watch.seconds();
    return made;
}

}  // namespace myo
