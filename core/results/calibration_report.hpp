#pragma once

#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::results {

/// HTML report of a calibration: fitted parameters, fit and prediction of each trial, the model, the checks.
/// For people; scripts read calibrate.json.
///
/// A trial that did not complete has a section with the reason. calibrate.json is embedded.
/// Errors: none. Asserts that the calibration is usable.
report::HtmlReport calibration_report(const setup::Setup& setup, const calibration::Calibration& calibration,
                                      const RunFacts& facts);

/// "283.1 ± 0.4" as two strings. The decimals follow from two significant digits of the deviation, with at most five
/// significant digits of the value; without a deviation, four significant digits.
struct ReadableEstimate {
    std::string value;
    std::string deviation;  // empty if unknown
};
/// Formats a value and its standard deviation, both in the unit that is shown.
/// @param deviation  NaN or 0: unknown
ReadableEstimate readable_estimate(double value, double deviation);

}  // namespace myo::results
