#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "check/recorded_swing.hpp"
#include "setup/first_vibration.hpp"

namespace myo::check {
namespace {

struct TimeUnitPolicy {
    /// Between the frequency of a body left to itself and that of its first vibration. It swings no slower than that,
    /// and faster than its sixth bending vibration (90 times the first, of a cantilever) without the first being seen
    /// it does not. 30 leaves room for a modulus a thousand times off, which says what else is wrong.
    double doubtful_ratio = 30.0;
    double wrong_ratio = 300.0;       // a modulus 1e5 times off
    double most_samples_per_s = 1e5;  // high-speed cameras at a tenth of their picture
    double same = 3.0;                // ratios within this factor are taken for that of a unit
};
constexpr TimeUnitPolicy time_unit_policy;

struct Slip {
    double ratio;  // of the first vibration's frequency over that in the recording
    const char* words;
};
constexpr std::array slips{Slip{1e3, "milliseconds"}, Slip{1e6, "microseconds"}, Slip{1.0 / 60.0, "minutes"}};

/// What the times look like: "; they look like milliseconds", or nothing.
std::string guess(double interval_s, double ratio) {
    if (std::abs(interval_s - 1.0) < 1e-9 && ratio > 1.0) return "; they look like the numbers of frames";
    for (const Slip& slip : slips)
        if (std::abs(std::log(ratio / slip.ratio)) < std::log(time_unit_policy.same))
            return std::string("; they look like ") + slip.words;
    return {};
}

std::string hertz(double frequency) { return format_number(frequency, 3) + " Hz"; }

Finding of_swing(const setup::PreparedTrial& trial, double swing_Hz, double first_Hz) {
    const double ratio = first_Hz / swing_Hz, off = std::max(ratio, 1.0 / ratio);
    const std::string swings = "trial " + trial.name + ": left to itself the body swings at " + hertz(swing_Hz) +
                               " in the recording";
    Finding finding = fine_finding(trial.name, swings + ", and the first vibration is " + hertz(first_Hz));
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

/// A body whose muscles are declared without any signal moves by those that are sought.
bool signals_are_known(const setup::PreparedTrial& trial) {
    const auto changes = [](const fibre::Signal& signal) {
        return std::any_of(signal.values.begin(), signal.values.end(),
                           [&](double value) { return value != signal.values.front(); });
    };
    const std::vector<fibre::Signal>& signals = trial.model.activation;
    return signals.empty() || !trial.free_levels.empty() || std::any_of(signals.begin(), signals.end(), changes);
}

Finding of_rate(const setup::PreparedTrial& trial, double rate_Hz) {
    const std::string sentence = "trial " + trial.name + ": " + format_number(rate_Hz, 3) + " samples per second";
    Finding finding = fine_finding(trial.name, sentence + ", and nothing in the motion contradicts its times");
    finding.figure = rate_Hz;
    finding.threshold = time_unit_policy.most_samples_per_s;
    finding.unit = "Hz";
    if (rate_Hz <= finding.threshold) return finding;
    finding.level = CheckLevel::doubtful;
    finding.sentence = sentence + ", more than the " + format_number(finding.threshold) + " that cameras take";
    finding.way_out = "give the times of the recording in seconds";
    return finding;
}

}  // namespace

/// Slow recordings are no slip: of a body that creeps, or whose loads and signals change, any time may be true. So may
/// that of a motion whose signals are still to be found.
std::vector<Finding> check_time_unit(const CheckedJob& job) {
    const setup::Setup& setup = job.setup;
    std::vector<Finding> findings;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const setup::PreparedTrial& trial = setup.trials[t];
        if (trial.measured.sample_count() < 2) continue;
        const double rate_Hz = 1.0 / setup::sampling_interval_s(trial);
        const RecordedSwing swing = recorded_swing(trial, last_change_s(trial.model), setup::mean_noise(setup));
        if (rate_Hz <= time_unit_policy.most_samples_per_s && swing.frequency_Hz > 0.0 && signals_are_known(trial)) {
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
