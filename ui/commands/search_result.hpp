#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/run_result.hpp"
#include "commands/settings.hpp"

// Results of a search for parameters or signals, and its intermediate results.

namespace myo::ui::commands {

/// A parameter of a search, in the unit in which it is shown.
struct ParameterRow {
    std::string name;        // "Young's modulus E"
    std::string unit;        // "kPa"
    double start = 0.0;      // value at the start of the search
    double value = 0.0;      // best value
    double deviation = 0.0;  // one standard deviation; NaN = unknown
};

/// One evaluation of the model. NaN if the model could not be simulated.
struct SearchPoint {
    double loss = std::numeric_limits<double>::quiet_NaN();           // in SearchView::loss_unit
    double rms_m = std::numeric_limits<double>::quiet_NaN();          // error of the markers
    double gradient_norm = std::numeric_limits<double>::quiet_NaN();  // length of the loss's gradient
};

/// State of a search while it runs, and its history afterwards.
struct SearchView {
    std::string loss_unit;                  // "mm²"; empty: without unit
    std::string target = {};                // what the markers follow: "goals of trial reach"; empty: all trials to fit
    std::vector<SearchPoint> log;           // all evaluations in order
    std::vector<ParameterRow> parameters;   // of the best evaluation; deviations are unknown
    Settings settings;                      // with the best values
    std::shared_ptr<const RunResult> best;  // run with the best values; null: none yet
};

/// Result of a calibration or of an optimisation of signals.
struct SearchResult {
    std::string title;                     // "Calibrated"
    std::vector<ParameterRow> parameters;  // with standard deviations, if they are known
    std::vector<std::string> notes;        // findings about signals, as sentences
    double rms_before_m = 0.0;             // error of the markers with the start values
    double rms_after_m = 0.0;              // error with the values found
    int evaluations = 0;                   // runs of the model
    Settings settings;                     // with the values found
    RunResult run;                         // with the values found
    bool stopped = false;                  // cancelled by the user: the best values up to then
    std::string problem;                   // what went wrong; empty: nothing
    std::vector<std::string> warnings;     // what the user should know before relying on the values
    std::shared_ptr<const void> page;      // page for the report, owned by the backend; may be null
};

/// How to search for signals, and values of the body, with which the markers of a trial follow their measured paths.
struct OptimizeRequest {
    std::string trial;                   // name of the trial
    bool signals = true;                 // seek the signals of all actuators
    std::vector<std::string> seek = {};  // further quantities, see SeekChoice::word
    double frequency_Hz = 10.0;          // knots per second of each signal
    double lowest = 0.6, highest = 1.6;  // limits of the target stretch a of every muscle
    int max_evaluations = 60;            // maximum number of evaluations

    bool operator==(const OptimizeRequest&) const = default;
};

}  // namespace myo::ui::commands
