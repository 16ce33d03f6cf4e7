#include "validation/validation.hpp"

#include "base/text.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "experiment/read_experiment.hpp"

namespace myo::validation {
namespace {

/// Choice of a folder, compared by ValidationFolder::claim().
report::Json choice_json(const CaseChoice& choice) {
    report::Json json{{"seed", choice.seed}, {"families", report::Json::array()}, {"effects", choice.effects}};
    for (const BodyFamily family : choice.families) json["families"].push_back(to_string(family));
    // Folders from before sets of effects are continued.
    if (choice.together > 1) json["together"] = choice.together;
    return json;
}

/// Content of truth.json: what the diagnosis should find, SI units.
report::Json truth_json(const MadeExperiment& made) {
    const SyntheticCase& c = made.truth;
    report::Json json{
        {"kind", to_string(c.kind)}, {"family", to_string(c.body.family)}, {"effects", report::Json::array()}};
    for (const effect::EffectDeclaration& effect : c.effects)
        json["effects"].push_back(
            {{"id", effect.id}, {"parameters", diagnosis::effect_parameters_json(effect.parameters)}});
    json["level_over_noise"] = report::json_number(made.level);
    json["youngs_modulus_Pa"] = report::json_number(c.material.youngs_modulus_Pa);
    json["damping_s"] = report::json_number(c.material.damping_s);
    json["noise_m"] = report::json_number(c.noise_m);
    json["translation_m"] = report::json_array(Eigen::VectorXd(c.translation_m));
    json["rotation_rad"] = report::json_array(Eigen::VectorXd(c.rotation_rad));
    json["integrator"] = to_string(c.truth.scheme.integrator);
    json["steps_per_sample"] = c.truth.steps_per_sample;
    json["dofs"] = made.truth_dofs;
    return json;
}

}  // namespace

CaseRecord run_case(const ValidationOptions& options, int number, const std::filesystem::path& folder,
                    const Progress& progress) {
    const Progress silent = progress.with_sink({});
    const Result<MadeExperiment> made = make_experiment(options.choice, number, folder, silent);
    if (!made)
        return failed_case(drawn_case(options.choice, number),
                           progress.cancelled() ? cases::cancelled_words : made.error().text());
    const SyntheticCase& c = made->truth;
    if (const Result<void> file = report::write_json(folder / "truth.json", truth_json(*made)); !file)
        return failed_case(c, file.error().text());
    // From here on only the files of the folder are used, as for any experiment.
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
    if (!experiment) return failed_case(c, experiment.error().text());
    const Result<setup::Setup> setup = setup::prepare_setup(*experiment, {}, silent);
    if (!setup) return failed_case(c, setup.error().text());
    diagnosis::DiagnoseSettings settings = options.diagnose;
    settings.fits = folder / "fits.json";  // lets an interrupted case continue
    // A deleted effect is withheld from the diagnosis; the right answer is then "unknown".
    if (c.kind == CaseKind::deleted) settings.without.push_back(c.effects.front().id);
    const diagnosis::Diagnosis diagnosis = diagnosis::diagnose(*setup, settings, silent);
    if (progress.cancelled()) return failed_case(c, cases::cancelled_words);
    if (diagnosis.complete())
        if (const Result<void> file = report::write_json(folder / "report.json",
                                                         diagnosis::diagnosis_json(*setup, diagnosis, c.name()));
            !file)
            return failed_case(c, file.error().text());
    return judged_case(*made, *setup, diagnosis);
}

Result<void> run_validation(const ValidationOptions& options, const std::filesystem::path& out,
                            const Progress& progress, const std::function<void(const CaseRecord&)>& done) {
    if (const Result<void> fine = check_choice(options.choice); !fine) return fine;
    ValidationFolder folder(out);
    if (const Result<void> mine = folder.claim(choice_json(options.choice)); !mine) return mine;
    const auto run = [&](int number) {
        const CaseRecord record = run_case(options, number, folder.case_folder(number), progress);
        // Null: a cancelled case has no record and is run again by the next call.
        return record.failure == cases::cancelled_words ? report::Json() : record_json(record);
    };
    const auto tell = [&](const report::Json& json) {
        if (done) done(*record_from_json(json));
    };
    return folder.run(options.range, run, progress, tell);
}

Result<std::vector<CaseRecord>> validation_records(const std::filesystem::path& out) {
    const Result<std::vector<report::Json>> lines = ValidationFolder(out).records();
    if (!lines) return lines.error();
    std::vector<CaseRecord> records;
    for (const report::Json& line : *lines) {
        Result<CaseRecord> record = record_from_json(line);
        if (!record)
            return Error{"case " + report::json_line(line.at("case")) + ": " + record.error().what, out.string()};
        records.push_back(std::move(*record));
    }
    return records;
}

}  // namespace myo::validation
