#include "commands/recording_import.hpp"

#include <algorithm>
#include <cctype>

namespace myo::ui::commands {

std::string marker_name(const std::string& label) {
    // Names become columns of CSV files and keys in TOML, so other characters are replaced.
    std::string name = label;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_'; }, '_');
    // "Tip - 1" reads as Tip-1.
    for (const char* gap : {"_-", "-_"})
        for (std::size_t at = name.find(gap); at != std::string::npos; at = name.find(gap)) name.replace(at, 2, "-");
    return name;
}

void assign_marker(ImportChoices& choices, std::size_t label, const std::string& declared) {
    // A marker belongs to one label: take it away from the label that had it.
    for (ImportedMarker& other : choices.markers)
        if (other.name == declared) other = {};
    choices.markers[label] = {declared, std::nullopt};
}

}  // namespace myo::ui::commands
