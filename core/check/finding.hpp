#pragma once

#include <limits>
#include <string>

namespace myo::check {

/// Green, amber and red.
enum class CheckLevel { fine, doubtful, wrong };

std::string to_string(CheckLevel level);

/// What one check found of one subject.
struct Finding {
    std::string check;  // id in the catalogue of checks
    CheckLevel level = CheckLevel::fine;
    std::string subject;  // trial or parameter; empty: the whole experiment
    double figure = std::numeric_limits<double>::quiet_NaN();
    double threshold = std::numeric_limits<double>::quiet_NaN();  // of the figure, beyond which it is doubtful
    std::string unit;                                             // of both
    std::string source;                                           // of the threshold
    std::string sentence;                                         // what was found, with the figure
    std::string way_out;                                          // what helps; empty where all is well
    bool told = false;                                            // a warning says so already, with file and line
};

/// A finding that all is well.
Finding fine_finding(const std::string& subject, const std::string& sentence);

}  // namespace myo::check
