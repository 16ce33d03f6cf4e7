#include "measurement/marker_labels.hpp"

#include <algorithm>
#include <set>

namespace myo::measurement {

std::string_view without_subject(std::string_view label) {
    const std::size_t colon = label.rfind(':');
    return colon == std::string_view::npos ? label : label.substr(colon + 1);
}

std::vector<std::size_t> find_labels(const std::vector<std::string>& labels, std::string_view name) {
    const auto exact = std::find(labels.begin(), labels.end(), name);
    if (exact != labels.end()) return {static_cast<std::size_t>(exact - labels.begin())};
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (without_subject(labels[i]) == name) found.push_back(i);
    return found;
}

void make_unique(std::vector<std::string>& labels) {
    std::set<std::string> taken;
    for (std::string& label : labels) {
        const std::string base = label;
        for (int k = 2; !taken.insert(label).second; ++k) label = base + " (" + std::to_string(k) + ")";
    }
}

}  // namespace myo::measurement
