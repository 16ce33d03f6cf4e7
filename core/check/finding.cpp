#include "check/finding.hpp"

namespace myo::check {

std::string to_string(CheckLevel level) {
    switch (level) {
        case CheckLevel::fine: return "green";
        case CheckLevel::doubtful: return "amber";
        default: return "red";
    }
}

Finding fine_finding(const std::string& subject, const std::string& sentence) {
    Finding finding;
    finding.subject = subject;
    finding.sentence = sentence;
    return finding;
}

}  // namespace myo::check
