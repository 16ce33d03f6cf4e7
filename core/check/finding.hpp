#pragma once

#include <limits>
#include <string>

namespace myo::check {

/// Passed, doubtful, violated; shown as green, amber and red. Doubtful: results may be off, or a number may be in
/// another unit; wrong: they mean nothing without the remedy.
enum class CheckLevel { passed, doubtful, wrong };

/// "green", "amber" or "red".
std::string to_string(CheckLevel level);

/// Result of one check for one subject.
struct Finding {
    std::string check;  // id in the catalogue of checks
    CheckLevel level = CheckLevel::passed;
    std::string subject;                                          // trial or parameter; empty: the whole experiment
    double figure = std::numeric_limits<double>::quiet_NaN();     // measured value
    double threshold = std::numeric_limits<double>::quiet_NaN();  // value beyond which the figure is doubtful
    std::string unit;                                             // of figure and threshold
    std::string source;                                           // of the threshold
    std::string sentence;                                         // the result with its figure
    std::string way_out;                                          // remedy; empty if passed
    bool warned = false;                                          // a warning with file and line states the same
};

/// Passed finding with a subject and a sentence; callers raise the level and add figures.
Finding passed_finding(const std::string& subject, const std::string& sentence);

}  // namespace myo::check
