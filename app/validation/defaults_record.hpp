#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/json.hpp"

namespace myo::validation {

/// A fitted value with its true value.
struct FittedNumber {
    std::string name;
    double truth = 0.0, value = 0.0;                              // SI
    double deviation = std::numeric_limits<double>::quiet_NaN();  // standard deviation; NaN: not determined

    /// Relative error.
    double error() const { return value / truth - 1.0; }
    /// Error in units of the standard deviation.
    double normalised() const { return (value - truth) / deviation; }
};

/// A check that did not pass.
struct Remark {
    // Id of the check, what it is about (trial, marker, parameter), and what it says.
    std::string check, subject, sentence;
    bool wrong = false;  // red, otherwise amber
};

/// Result of `myoloop calibrate` with default options on an experiment with known truth.
struct DefaultsRecord {
    int number = 0;
    std::string shape, slip;  // empty slip: correct declaration
    std::string facts;        // readable summary of size, material, camera and start
    double length_m = 0.0, modulus_Pa = 0.0, poissons_ratio = 0.0, frequency_Hz = 0.0, rate_Hz = 0.0;  // true values
    int dofs = 0, truth_dofs = 0;       // degrees of freedom of the fit and of the truth
    std::string failure;                // the case could not be made, or the fit failed
    std::string refusal;                // message with which the experiment was rejected
    std::vector<FittedNumber> numbers;  // Young's modulus and damping
    std::vector<Remark> remarks;        // of all checks
    double residual_over_noise = 0.0;   // rms of the fit trials over noise
    double make_s = 0.0, fit_s = 0.0;   // wall-clock times
    /// Numbers of a fit with half a sampling interval as time step, the former default; empty if it failed.
    std::vector<FittedNumber> with_half_interval;
    double with_half_interval_s = 0.0;
};

/// JSON form of a record, a line of cases.jsonl.
report::Json record_json(const DefaultsRecord& record);
/// Inverse of record_json(). Errors: a key is missing or of another type.
Result<DefaultsRecord> defaults_record_from_json(const report::Json& json);

/// Tolerances of a right answer: relative error plus a multiple of the stated standard deviation.
struct DefaultsJudgement {
    double relative = 0.02;   // of the true value
    double deviations = 3.0;  // stated standard deviations
    /// Largest informative standard deviation, relative to the value.
    double max_deviation = 0.1;
};
inline constexpr DefaultsJudgement defaults_judgement;

/// Whether a value lies within the tolerances of defaults_judgement.
bool is_right(const FittedNumber& number);

/// Class of a record.
enum class DefaultsAnswer {
    right,          // all numbers are right, or those undetermined are reported
    cause_named,    // a number is wrong, or nothing was fitted, and the true cause is named
    other_warning,  // a number is wrong, and only something else is named
    silent,         // a number is wrong without any remark
    failed,         // no answer
};
/// Readable name, also the key in files.
std::string to_string(DefaultsAnswer answer);
/// Class of a record.
///
/// The causes that count are the checks of its declaration error (Slip::checks); a rejected experiment counts as
/// cause_named if the message contains Slip::refusal.
DefaultsAnswer judged(const DefaultsRecord& record);

/// Whether a correct experiment with right numbers has an unjustified remark, or was rejected.
bool is_false_alarm(const DefaultsRecord& record);

}  // namespace myo::validation
