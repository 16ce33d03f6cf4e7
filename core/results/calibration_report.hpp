#pragma once

#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::results {

/// The page about a calibration: what came out, how well it fits and predicts each trial, and what the model was.
/// Of a trial that did not complete it says why. Asserts that the calibration is usable.
report::HtmlReport calibration_report(const setup::Setup& setup, const calibration::Calibration& calibration,
                                      const RunFacts& facts);

/// "283.1 ± 0.4" as its two parts, with as many digits as the deviation has meaning (two of its own), five at most;
/// four significant digits and no deviation when it is not known.
struct ReadableEstimate {
    std::string value;
    std::string deviation;  // empty when unknown
};
ReadableEstimate readable_estimate(double value, double deviation);

}  // namespace myo::results
