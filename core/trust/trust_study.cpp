#include "trust/trust_study.hpp"

#include <atomic>
#include <mutex>
#include <set>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "loop/diagnosis_json.hpp"
#include "project/read_experiment.hpp"
#include "trust/record_file.hpp"

namespace myo {
namespace {

const char* const records_name = "cases.jsonl";
const char* const choice_name = "choice.json";
const char* const cancelled_words = "cancelled";

Json choice_json(const CaseChoice& choice) {
    Json json{{"seed", choice.seed}, {"families", Json::array()}, {"effects", choice.effects}};
    for (const BodyFamily family : choice.families) json["families"].push_back(to_string(family));
    return json;
}

/// Sees that the folder is this study's.
Result<void> claim_folder(const CaseChoice& choice, const std::filesystem::path& out) {
    const std::filesystem::path file = out / choice_name;
    const Json mine = choice_json(choice);
    if (!std::filesystem::exists(file)) return write_json(file, mine);
    const Result<Json> there = read_json(file);
    if (!there) return there.error();
    if (*there == mine) return {};
    return Error{"holds cases of another choice (seed " + json_line((*there)["seed"]) + "); choose another folder or the same seed, geometry and effects", out.string()};
}

Json truth_json(const MadeExperiment& made) {
    const SyntheticCase& c = made.truth;
    Json json{{"kind", to_string(c.kind)}, {"family", to_string(c.body.family)}, {"effects", Json::array()}};
    if (c.effect) json["effects"].push_back({{"id", c.effect->id}, {"parameters", effect_parameters_json(c.effect->parameters)}});
    json["level_over_noise"] = json_number(made.level);
    json["youngs_modulus_Pa"] = json_number(c.material.youngs_modulus_Pa);
    json["damping_s"] = json_number(c.material.damping_s);
    json["noise_m"] = json_number(c.noise_m);
    json["translation_m"] = json_array(Eigen::VectorXd(c.translation_m));
    json["rotation_rad"] = json_array(Eigen::VectorXd(c.rotation_rad));
    json["integrator"] = to_string(c.truth.scheme.integrator);
    json["steps_per_sample"] = c.truth.steps_per_sample;
    json["dofs"] = made.truth_dofs;
    return json;
}

}  // namespace

CaseRecord run_case(const TrustStudyOptions& options, int number, const std::filesystem::path& folder, const Progress& progress) {
    const Progress silent = progress.with_sink({});
    const Result<MadeExperiment> made = make_experiment(options.choice, number, folder, silent);
    if (!made) return failed_case(drawn_case(options.choice, number), progress.cancelled() ? cancelled_words : made.error().text());
    const SyntheticCase& c = made->truth;
    if (const Result<void> file = write_json(folder / "truth.json", truth_json(*made)); !file) return failed_case(c, file.error().text());
    // From here on the case is a folder like any other.
    const Result<Experiment> experiment = read_experiment(folder);
    if (!experiment) return failed_case(c, experiment.error().text());
    const Result<Study> study = prepare_study(*experiment, {}, silent);
    if (!study) return failed_case(c, study.error().text());
    DiagnoseSettings settings = options.diagnose;
    settings.fits = folder / "fits.json";   // a case that was stopped goes on
    if (c.kind == CaseKind::deleted) settings.without.push_back(c.effect->id);
    const Diagnosis diagnosis = diagnose(*study, settings, silent);
    if (progress.cancelled()) return failed_case(c, cancelled_words);
    if (diagnosis.complete())
        if (const Result<void> file = write_json(folder / "report.json", diagnosis_json(*study, diagnosis, c.name())); !file) return failed_case(c, file.error().text());
    return judged_case(*made, *study, diagnosis);
}

Result<void> run_trust_study(const TrustStudyOptions& options, const std::filesystem::path& out, const Progress& progress,
                             const std::function<void(const CaseRecord&)>& done) {
    if (const Result<void> fine = check_choice(options.choice); !fine) return fine;
    if (const Result<void> mine = claim_folder(options.choice, out); !mine) return mine;
    RecordFile file(out / records_name);
    const Result<std::vector<CaseRecord>> there = file.read();
    if (!there) return there.error();
    std::set<int> finished;
    for (const CaseRecord& record : *there) finished.insert(record.number);
    std::vector<int> numbers;
    for (int number = options.first; number < options.first + options.cases; ++number)
        if (number % options.shares == options.share && finished.count(number) == 0) numbers.push_back(number);

    std::mutex mutex;
    int count = 0;
    Result<void> trouble;
    const auto total = static_cast<double>(numbers.size());
    progress.report({"study", 0.0, total, "cases", {}});
    parallel_tasks(static_cast<int>(numbers.size()), options.threads, [&](int task) {
        if (progress.cancelled()) return;
        const int number = numbers[static_cast<std::size_t>(task)];
        const CaseRecord record = run_case(options, number, out / "cases" / drawn_case(options.choice, number).name(), progress);
        if (record.failure == cancelled_words) return;
        const std::lock_guard<std::mutex> lock(mutex);
        if (const Result<void> kept = file.add(record); !kept) trouble = kept;
        progress.report({"study", static_cast<double>(++count), total, "cases", record.truth});
        if (done) done(record);
    });
    return trouble;
}

Result<std::vector<CaseRecord>> trust_records(const std::filesystem::path& out) { return RecordFile(out / records_name).read(); }

}  // namespace myo
