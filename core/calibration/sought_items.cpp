#include "calibration/sought_items.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>

#include "experiment/actuators.hpp"

namespace myo::calibration {
namespace {

/// Word of a kind on the command line and in files.
struct KindWord {
    SoughtKind kind;
    std::string_view word;
};
constexpr std::array kind_words{KindWord{SoughtKind::signals, "signals"}, KindWord{SoughtKind::direction, "direction"},
                                KindWord{SoughtKind::weights, "weights"}, KindWord{SoughtKind::modulus, "modulus"}};

/// Why a quantity with a known word is not one of the experiment's.
std::string reason(const experiment::Experiment& experiment, const SoughtItem& item) {
    if (item.kind == SoughtKind::signals && item.of.empty()) return "the experiment has no muscle, chamber or tendon";
    if (item.kind == SoughtKind::signals)
        return "no muscle that follows none, no chamber and no tendon is called \"" + item.of + "\"";
    if (item.kind == SoughtKind::modulus) return "no part is called \"" + item.of + "\"";
    const auto muscle = std::find_if(experiment.muscles.begin(), experiment.muscles.end(),
                                     [&](const auto& each) { return each.name == item.of; });
    if (muscle == experiment.muscles.end()) return "no muscle is called \"" + item.of + "\"";
    if (item.kind == SoughtKind::weights)
        return "muscle \"" + item.of + "\" is not painted: only the weights of a mask can be sought";
    return "the fibres of muscle \"" + item.of +
           "\" run along its line; declare a mask or a box to seek their direction";
}

}  // namespace

std::string to_string(const SoughtItem& item) {
    const auto word = std::find_if(kind_words.begin(), kind_words.end(),
                                   [&](const KindWord& each) { return each.kind == item.kind; });
    return std::string(word->word) + (item.of.empty() ? "" : ":" + item.of);
}

std::string readable(const SoughtItem& item) {
    switch (item.kind) {
        case SoughtKind::direction: return "fibre direction of " + item.of;
        case SoughtKind::weights: return "painted weights of " + item.of;
        case SoughtKind::modulus: return "Young's modulus of " + (item.of.empty() ? "the body" : item.of);
        case SoughtKind::signals: break;
    }
    return item.of.empty() ? "signals" : "signal of " + item.of;
}

std::vector<SoughtItem> seekable_items(const experiment::Experiment& experiment) {
    std::vector<SoughtItem> items;
    const std::vector<experiment::Actuator> actuators = experiment::actuators(experiment);
    if (!actuators.empty()) items.push_back({SoughtKind::signals});
    for (const experiment::Actuator& actuator : actuators)
        if (actuator.kind != experiment::ActuatorKind::muscle || !experiment.muscles[actuator.index].follows)
            items.push_back({SoughtKind::signals, actuator.name});
    for (const experiment::MuscleDeclaration& muscle : experiment.muscles) {
        const bool painted = std::holds_alternative<experiment::MuscleMask>(muscle.part);
        if (painted || std::holds_alternative<experiment::MuscleBox>(muscle.part))
            items.push_back({SoughtKind::direction, muscle.name});
        if (painted) items.push_back({SoughtKind::weights, muscle.name});
    }
    // The body's material always exists.
    items.push_back({SoughtKind::modulus});
    for (const experiment::PartDeclaration& part : experiment.parts) items.push_back({SoughtKind::modulus, part.name});
    return items;
}

Result<std::vector<SoughtItem>> sought_items(const std::vector<std::string>& words,
                                             const experiment::Experiment& experiment) {
    const std::vector<SoughtItem> possible = seekable_items(experiment);
    std::vector<SoughtItem> items;
    for (const std::string& word : words) {
        const std::size_t colon = word.find(':');
        const std::string first = word.substr(0, colon);
        const auto kind = std::find_if(kind_words.begin(), kind_words.end(),
                                       [&](const KindWord& each) { return each.word == first; });
        if (kind == kind_words.end())
            return Error{
                "\"" + word +
                    "\" is none of signals, signals:ACTUATOR, direction:MUSCLE, weights:MUSCLE, modulus, modulus:PART",
                ""};
        SoughtItem item{kind->kind, colon == std::string::npos ? "" : word.substr(colon + 1)};
        if (std::find(possible.begin(), possible.end(), item) == possible.end())
            return Error{"\"" + word + "\" cannot be sought: " + reason(experiment, item), ""};
        if (std::find(items.begin(), items.end(), item) == items.end()) items.push_back(std::move(item));
    }
    return items;
}

}  // namespace myo::calibration
