#include "check/finding.hpp"

namespace myo::check {

std::string to_string(CheckLevel level) {
    switch (level) {
        case CheckLevel::passed: return "green";
        case CheckLevel::doubtful: return "amber";
        default: return "red";
    }
}

Finding passed_finding(const std::string& subject, const std::string& sentence) {
    Finding finding;
    finding.subject = subject;
    finding.sentence = sentence;
    return finding;
}

}  // namespace myo::check
