#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "check/declared_steps.hpp"
#include "check/recorded_swing.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "setup/first_vibration.hpp"

namespace myo::check {
namespace {

/// Ratios and rates at which the times of a recording are taken to be in another unit.
struct TimeUnitPolicy {
    /// First natural frequency over the recorded frequency of free motion, or its inverse. A free body does not
    /// oscillate slower than its first mode, nor faster than its sixth bending mode (90 times the first, of a
    /// cantilever) without the first being visible. 30 leaves room for a modulus off by a factor of a thousand, which
    /// other checks report.
    double doubtful_ratio = 30.0;
    double wrong_ratio = 300.0;      // a modulus off by 1e5
    double max_samples_per_s = 1e5;  // high-speed cameras at a tenth of their image size
    double same = 3.0;               // a ratio within this factor of a unit's is attributed to that unit
    /// Sampling rate below which a swing that is certainly too slow is refused: nobody films swings at fewer pictures,
    /// and at more of them a wrong modulus is as likely as a wrong unit of time.
    double least_rate_Hz = 5.0;
};
constexpr TimeUnitPolicy time_unit_policy;

/// A wrong unit of time and the frequency ratio that it causes.
struct Slip {
    double ratio;  // first natural frequency over that in the recording
    const char* words;
    const char* unit;  // value of the key `time_unit`
};
constexpr std::array slips{Slip{1e3, "milliseconds", "ms"}, Slip{1e6, "microseconds", "us"},
                           Slip{1.0 / 60.0, "minutes", "min"}};

/// The slip with about this ratio, or null.
const Slip* likely_slip(double ratio) {
    const auto found = std::find_if(slips.begin(), slips.end(), [&](const Slip& slip) {
        return std::abs(std::log(ratio / slip.ratio)) < std::log(time_unit_policy.same);
    });
    return found != slips.end() ? &*found : nullptr;
}

/// Likely unit of the times, "; they look like milliseconds (time_unit = "ms")", or empty.
std::string guess(double interval_s, double ratio) {
    // An interval of exactly 1 is a count.
    if (std::abs(interval_s - 1.0) < 1e-9 && ratio > 1.0) return "; they look like the numbers of frames";
    const Slip* const slip = likely_slip(ratio);
    if (!slip) return {};
    return std::string("; they look like ") + slip->words + " (time_unit = \"" + slip->unit + "\")";
}

/// Frequency in words.
std::string hertz(double frequency) { return format_number(frequency, 3) + " Hz"; }

/// Finding from the ratio of the recorded frequency and the first natural frequency.
Finding of_swing(const setup::PreparedTrial& trial, double swing_Hz, double first_Hz) {
    // A wrong unit is a factor, so ratios are compared, in both directions.
    const double ratio = first_Hz / swing_Hz, off = std::max(ratio, 1.0 / ratio);
    const std::string swings = "trial " + trial.name + ": left to itself the body swings at " + hertz(swing_Hz) +
                               " in the recording";
    Finding finding = passed_finding(trial.name, swings + ", and the first vibration is " + hertz(first_Hz));
    finding.figure = swing_Hz;
    const double most = time_unit_policy.doubtful_ratio;
    finding.threshold = ratio > 1.0 ? first_Hz / most : first_Hz * most;
    finding.unit = "Hz";
    if (off <= most) return finding;
    finding.level = off > time_unit_policy.wrong_ratio ? CheckLevel::wrong : CheckLevel::doubtful;
    finding.sentence = swings + ", " + format_number(off, 3) + " times " + (ratio > 1.0 ? "slower" : "faster") +
                       " than its first vibration of " + hertz(first_Hz);
    finding.way_out = "give the times of the recording in seconds" + guess(setup::sampling_interval_s(trial), ratio) +
                      ". If they are seconds, " +
                      (ratio > 1.0 ? "the camera is too slow for the vibration, what moves the body is not declared, "
                                     "or "
                                   : "") +
                      "modulus, density or size are not in Pa, kg/m3 and m";
    return finding;
}

/// False if actuators are declared without any changing signal: then the motion is driven by signals yet to be found.
bool signals_are_known(const setup::PreparedTrial& trial) {
    const auto changes = [](const fibre::Signal& signal) {
        return std::any_of(signal.values.begin(), signal.values.end(),
                           [&](double value) { return value != signal.values.front(); });
    };
    std::vector<fibre::Signal> signals = trial.model.activation;
    signals.insert(signals.end(), trial.recorded_commands.begin(), trial.recorded_commands.end());
    // A free level is a step at t = 0, after which the body moves freely.
    return signals.empty() || !trial.free_levels.empty() || std::any_of(signals.begin(), signals.end(), changes);
}

/// Finding from the sampling rate alone, if no free oscillation is available.
Finding of_rate(const setup::PreparedTrial& trial, double rate_Hz) {
    const std::string sentence = "trial " + trial.name + ": " + format_number(rate_Hz, 3) + " samples per second";
    Finding finding = passed_finding(trial.name, sentence + ", and nothing in the motion contradicts its times");
    finding.figure = rate_Hz;
    finding.threshold = time_unit_policy.max_samples_per_s;
    finding.unit = "Hz";
    if (rate_Hz <= finding.threshold) return finding;
    finding.level = CheckLevel::doubtful;
    finding.sentence = sentence + ", more than the " + format_number(finding.threshold) + " that cameras take";
    finding.way_out = "give the times of the recording in seconds";
    return finding;
}

/// First natural frequency over the recorded one, of a finding that is not passed.
double ratio_of(const Finding& finding) {
    const double most = time_unit_policy.doubtful_ratio;
    // of_swing() sets the threshold to the first frequency over or times `most`, on the side on which the figure lies.
    return finding.figure < finding.threshold ? most * finding.threshold / finding.figure
                                              : finding.threshold / (most * finding.figure);
}

}  // namespace

Result<void> require_time_unit(const setup::Setup& setup, const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
        if (finding.check != "time_unit" || finding.level != CheckLevel::wrong || !(ratio_of(finding) > 1.0)) continue;
        for (std::size_t t = 0; t < setup.trials.size(); ++t) {
            // Only if no person has stated the unit, the file has times at all, and the rate is one that nobody films
            // with.
            const experiment::TrialDeclaration& trial = setup.experiment.trials[t];
            if (trial.name != finding.subject || trial.seconds_per_unit ||
                !measurement::find_trace_reader(trial.format)->has_times ||
                1.0 / setup::sampling_interval_s(setup.trials[t]) > time_unit_policy.least_rate_Hz)
                continue;
            const Slip* const slip = likely_slip(ratio_of(finding));
            return experiment::declaration_error(
                setup.experiment, experiment::trial_key(setup.experiment, trial) + ".time_unit",
                finding.sentence + "; " +
                    (slip ? std::string("its times look like ") + slip->words + ": state time_unit = \"" + slip->unit +
                                "\", or \"s\" if they are seconds"
                          : "state time_unit, \"s\" if its times are seconds"));
        }
    }
    return {};
}

/// Only free oscillation reveals the unit of time. Slow recordings are accepted: a creeping body, or one with changing
/// loads or unknown signals, can move at any rate.
std::vector<Finding> check_time_unit(const CheckedJob& job) {
    const setup::Setup& setup = job.setup;
    std::vector<Finding> findings;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const setup::PreparedTrial& trial = setup.trials[t];
        if (trial.measured.sample_count() < 2) continue;
        const double rate_Hz = 1.0 / setup::sampling_interval_s(trial);
        // Up to the last change of loads and signals the motion is driven, at a rate of its own.
        const RecordedSwing swing = recorded_swing(trial, last_change_s(trial.model), setup::mean_noise(setup));
        // A rate that no camera has is reported by itself, whatever the swing says.
        if (rate_Hz <= time_unit_policy.max_samples_per_s && swing.frequency_Hz > 0.0 && signals_are_known(trial)) {
            const double omega = setup::first_vibration_rad_s(
                prediction::affected_trial(setup, t, prediction::declared_values(setup)).model);
            if (omega > 0.0) {
                findings.push_back(of_swing(trial, swing.frequency_Hz, omega / (2.0 * std::numbers::pi)));
                continue;
            }
        }
        findings.push_back(of_rate(trial, rate_Hz));
    }
    return findings;
}

}  // namespace myo::check
