#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/json.hpp"

namespace myo::validation {

/// A fitted number beside its truth.
struct FittedNumber {
    std::string name;
    double truth = 0.0, value = 0.0;
    double deviation = std::numeric_limits<double>::quiet_NaN();  // NaN: not determined

    double error() const { return value / truth - 1.0; }
    /// The error in units of the deviation.
    double normalised() const { return (value - truth) / deviation; }
};

/// What a check said that was not fine.
struct Remark {
    std::string check, subject, sentence;
    bool wrong = false;  // red; else amber
};

/// What `myoloop calibrate` with nothing but its defaults made of an experiment whose truth is known.
struct DefaultsRecord {
    int number = 0;
    std::string shape, slip;  // slip empty: what is declared is true
    std::string facts;        // size, material, camera and start, for a person
    double length_m = 0.0, modulus_Pa = 0.0, poissons_ratio = 0.0, frequency_Hz = 0.0, rate_Hz = 0.0;
    int dofs = 0, truth_dofs = 0;
    std::string failure;                // the case could not be made, or the fit failed
    std::string refusal;                // the experiment was refused with this message
    std::vector<FittedNumber> numbers;  // Young's modulus and damping
    std::vector<Remark> remarks;
    double residual_over_noise = 0.0;
    double make_s = 0.0, fit_s = 0.0;
    /// The same with half a sampling interval as step, which was the default before steps were chosen.
    std::vector<FittedNumber> with_half_interval;
    double with_half_interval_s = 0.0;
};

report::Json record_json(const DefaultsRecord& record);
/// Error: a key is missing or of another type.
Result<DefaultsRecord> defaults_record_from_json(const report::Json& json);

/// When an answer counts as right.
struct DefaultsJudgement {
    double relative = 0.02;   // and ...
    double deviations = 3.0;  // so many stated ones
    /// Largest deviation, as a share of the number, of an answer that says something.
    double most_deviation = 0.1;
};
inline constexpr DefaultsJudgement defaults_judgement;

bool is_right(const FittedNumber& number);

/// How a record is judged.
enum class DefaultsAnswer {
    right,          // all numbers are, or what is not determined is named
    cause_named,    // a number is not, or nothing was fitted, and the true cause was named
    other_warning,  // a number is not, and only something else was named
    silent,         // a number is not, and nothing was said
    failed,         // no answer
};
std::string to_string(DefaultsAnswer answer);
DefaultsAnswer judged(const DefaultsRecord& record);

/// A remark on an experiment in which nothing is amiss and whose answer is right.
bool is_false_alarm(const DefaultsRecord& record);

}  // namespace myo::validation
