#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/run_result.hpp"
#include "commands/settings.hpp"

// What comes out of a search for parameters or signals, and what is known of it while it runs.

namespace myo::ui::commands {

/// A number that was looked for, in the unit it is shown in.
struct ParameterRow {
    std::string name;  // "Young's modulus E"
    std::string unit;  // "kPa"
    double start = 0.0;
    double value = 0.0;
    double deviation = 0.0;  // one standard deviation; NaN = unknown
};

/// One evaluation. NaN where the model could not be run.
struct SearchPoint {
    double loss = std::numeric_limits<double>::quiet_NaN();
    double rms_m = std::numeric_limits<double>::quiet_NaN();
    double gradient_norm = std::numeric_limits<double>::quiet_NaN();
};

/// A search as far as it has come.
struct SearchView {
    std::string loss_unit;                  // "mm²"; empty: none
    std::vector<SearchPoint> log;           // every evaluation, in order
    std::vector<ParameterRow> parameters;   // of the best evaluation, deviations unknown
    Settings settings;                      // with the best values
    std::shared_ptr<const RunResult> best;  // run with them; null before there is one
};

struct SearchResult {
    std::string title;  // "Calibrated"
    std::vector<ParameterRow> parameters;
    std::vector<std::string> notes;  // of signals, in words
    double rms_before_m = 0.0;
    double rms_after_m = 0.0;
    int evaluations = 0;
    Settings settings;     // with the values that were found
    RunResult run;         // with them
    bool stopped = false;  // by the user: these are the best values up to then
    std::string problem;
    std::vector<std::string> warnings;  // what a person should know before trusting the values
    std::shared_ptr<const void> page;   // about it, for the report: the backend's own; may be null
};

/// How muscle signals are looked for that make the markers of a trial follow their traces.
struct OptimizeRequest {
    std::string trial;
    double frequency_Hz = 10.0;          // of the signals' knots
    double lowest = 0.6, highest = 1.6;  // of every muscle's target stretch
    int max_evaluations = 60;

    bool operator==(const OptimizeRequest&) const = default;
};

}  // namespace myo::ui::commands
