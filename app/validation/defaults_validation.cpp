#include "validation/defaults_validation.hpp"

#include <cmath>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "calibration/calibrate.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "experiment/read_experiment.hpp"
#include "validation/converged_truth.hpp"
#include "validation/defaults_case.hpp"
#include "validation/synthetic_folder.hpp"

namespace myo::validation {
namespace {

/// One line that characterises the true experiment, for tables.
std::string facts_of(const DefaultsCase& d) {
    const SyntheticCase& c = d.truth;
    const Eigen::Vector3d size_mm = 1e3 * c.body.bounds.size();
    const SyntheticTrial& trial = c.trials.front();
    std::string start = trial.start == experiment::StartState::straight ? "let go straight" : "at rest";
    if (!trial.loads.empty())
        start += trial.loads.front().until_s == 0.0          ? ", pulled, let go at once"
                 : std::isfinite(trial.loads.front().from_s) ? ", then pushed"
                                                             : ", held, then let go";
    return format_number(size_mm(0), 3) + " x " + format_number(size_mm(1), 3) + " x " + format_number(size_mm(2), 3) +
           " mm, E " + format_number(c.material.youngs_modulus_Pa, 3) + " Pa, nu " +
           format_number(c.material.poissons_ratio, 4) + ", " + format_number(d.frequency_Hz, 3) + " Hz filmed at " +
           format_number(c.rate_Hz, 3) + " Hz for " + format_number(trial.end_s, 3) + " s, " + start +
           (c.muscles.empty() ? "" : ", muscles");
}

/// Record with what is known before anything is simulated.
DefaultsRecord begun_record(const DefaultsCase& d) {
    DefaultsRecord r;
    r.number = d.truth.number;
    r.shape = d.shape;
    r.slip = d.slip != nullptr ? d.slip->id : "";
    r.facts = facts_of(d);
    r.length_m = d.truth.body.length_m();
    r.modulus_Pa = d.truth.material.youngs_modulus_Pa;
    r.poissons_ratio = d.truth.material.poissons_ratio;
    r.frequency_Hz = d.frequency_Hz;
    r.rate_Hz = d.truth.rate_Hz;
    return r;
}

/// Writes the folder as the laboratory declares it, with the true motions.
///
/// The truth is simulated from the true declaration, which is then overwritten by the declared one.
Result<ConvergedTruth> write_case(const DefaultsCase& d, const std::filesystem::path& folder,
                                  const Progress& progress) {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    if (const Result<void> written = write_still_experiment(d.truth, folder); !written) return written.error();
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
    if (!experiment) return experiment.error();
    Result<ConvergedTruth> truth = converged_truth(d.truth, *experiment, progress);
    if (!truth) return truth;
    // The declared experiment replaces the true one; the motions stay true.
    if (const Result<void> written = write_still_experiment(d.declared, folder); !written) return written.error();
    if (const Result<void> written = write_traces(d.declared, truth->positions_m, folder); !written)
        return written.error();
    const report::Json json{
        {"slip", d.slip != nullptr ? d.slip->id : ""}, {"youngs_modulus_Pa", d.truth.material.youngs_modulus_Pa},
        {"damping_s", d.truth.material.damping_s},     {"dofs", truth->dofs},
        {"frequency_Hz", truth->frequency_Hz},         {"frequency_change", truth->frequency_change},
        {"modulus_factor", truth->modulus_factor},     {"path_change", truth->path_change}};
    if (const Result<void> file = report::write_json(folder / "truth.json", json); !file) return file.error();
    return truth;
}

// Modulus and damping only: the other unknowns have no counterpart in the truth.
std::vector<FittedNumber> fitted_numbers(const DefaultsCase& d, const calibration::Calibration& calibration) {
    std::vector<FittedNumber> numbers;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const prediction::ModelParameter& parameter = calibration.parameters[i];
        const bool modulus = parameter.kind == prediction::ModelParameter::Kind::youngs_modulus;
        if (!modulus && parameter.kind != prediction::ModelParameter::Kind::damping) continue;
        const auto row = static_cast<Eigen::Index>(i);
        numbers.push_back({parameter.parameter.name,
                           modulus ? d.truth.material.youngs_modulus_Pa : d.truth.material.damping_s,
                           calibration.fit.values(row), calibration.deviation(i)});
    }
    return numbers;
}

/// Appends the findings that did not pass.
void add_remarks(const std::vector<check::Finding>& findings, DefaultsRecord& r) {
    for (const check::Finding& finding : findings)
        if (finding.level != check::CheckLevel::passed)
            r.remarks.push_back(
                {finding.check, finding.subject, finding.sentence, finding.level == check::CheckLevel::wrong});
}

/// Fits with default options, by the calls that `myoloop calibrate` makes; the record receives refusal, failure,
/// numbers and remarks.
void fit_with_defaults(const DefaultsCase& d, const experiment::Experiment& experiment, const Progress& progress,
                       DefaultsRecord& r) {
    const Stopwatch watch;
    Result<setup::Setup> setup = setup::prepare_setup(experiment, {}, progress);
    if (!setup) {
        r.refusal = setup.error().text();
        return;
    }
    r.dofs = setup->body->dofs();
    check::choose_declared_steps(*setup, check::findings_on_units(*setup), progress);
    // The sequence of `myoloop calibrate`: units, steps, checks, fit, checks.
    const std::vector<check::Finding> before = check::check_before(*setup);
    const calibration::Calibration calibration = calibration::calibrate_with_chosen_steps(*setup, {}, progress);
    r.fit_s = watch.seconds();
    if (!calibration.usable()) {
        r.failure = calibration.fit.message;
        add_remarks(before, r);
        return;
    }
    r.numbers = fitted_numbers(d, calibration);
    r.residual_over_noise = calibration.after.fit_rms_m / setup::mean_noise(*setup);
    add_remarks(check::check_after({*setup, &calibration.after, &calibration}, before), r);
    if (!calibration.fit.converged()) r.failure = calibration.fit.message;
}

/// Fit with the former default, fixed steps of half a sampling interval, for comparison. A failure leaves no numbers.
void fit_with_half_interval(const DefaultsCase& d, const experiment::Experiment& experiment, const Progress& progress,
                            DefaultsRecord& r) {
    const Stopwatch watch;
    const Result<setup::Setup> setup = setup::prepare_setup(experiment, {}, progress);
    if (!setup) return;
    const calibration::Calibration calibration = calibration::calibrate(*setup, {}, progress);
    if (calibration.usable()) r.with_half_interval = fitted_numbers(d, calibration);
    r.with_half_interval_s = watch.seconds();
}

/// Removes the folder from messages, so that records do not depend on where they were made.
std::string without_folder(std::string text, const std::filesystem::path& folder) {
    const std::string prefix = folder.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
        text.erase(at, prefix.size());
    return text;
}

}  // namespace

DefaultsRecord run_defaults_case(std::uint64_t seed, int number, const std::filesystem::path& folder,
                                 const Progress& progress) {
    const Progress silent = progress.with_sink({});
    const DefaultsCase d = drawn_defaults_case(seed, number);
    DefaultsRecord r = begun_record(d);
    const Stopwatch watch;
    const Result<ConvergedTruth> truth = write_case(d, folder, silent);
    r.make_s = watch.seconds();
    if (!truth) {
        r.failure = truth.error().text();
    } else {
        r.truth_dofs = truth->dofs;
        // From here on only the files of the folder are used, as for any experiment.
        const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
        if (!experiment)
            r.refusal = experiment.error().text();
        else {
            fit_with_defaults(d, *experiment, silent, r);
            if (r.refusal.empty()) fit_with_half_interval(d, *experiment, silent, r);
        }
    }
    // A cancelled case is not recorded, see run_defaults_validation(): its numbers may be those of an unfinished fit.
    if (progress.cancelled()) r.failure = cases::cancelled_words;
    r.failure = without_folder(r.failure, folder);
    r.refusal = without_folder(r.refusal, folder);
    for (Remark& remark : r.remarks) remark.sentence = without_folder(remark.sentence, folder);
    return r;
}

Result<void> run_defaults_validation(const DefaultsValidationOptions& options, const std::filesystem::path& out,
                                     const Progress& progress, const std::function<void(const DefaultsRecord&)>& done) {
    ValidationFolder folder(out);
    if (const Result<void> mine = folder.claim({{"study", "defaults"}, {"seed", options.seed}}); !mine) return mine;
    const auto run = [&](int number) {
        const DefaultsRecord record = run_defaults_case(options.seed, number, folder.case_folder(number), progress);
        return record.failure == cases::cancelled_words ? report::Json() : record_json(record);
    };
    const auto tell = [&](const report::Json& json) {
        if (done) done(*defaults_record_from_json(json));
    };
    return folder.run(options.range, run, progress, tell);
}

Result<std::vector<DefaultsRecord>> defaults_records(const std::filesystem::path& out) {
    const Result<std::vector<report::Json>> lines = ValidationFolder(out).records();
    if (!lines) return lines.error();
    std::vector<DefaultsRecord> records;
    for (const report::Json& line : *lines) {
        Result<DefaultsRecord> record = defaults_record_from_json(line);
        if (!record)
            return Error{"case " + report::json_line(line.at("case")) + ": " + record.error().what, out.string()};
        records.push_back(std::move(*record));
    }
    return records;
}

}  // namespace myo::validation
