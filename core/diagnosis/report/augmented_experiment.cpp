#include "diagnosis/report/augmented_experiment.hpp"

#include <cstdio>
#include <regex>

#include "base/files.hpp"
#include "experiment/effect_toml.hpp"

namespace myo::diagnosis {
namespace {

/// Number with the digits that a fit determines at most, for a file that people read.
std::string short_number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.8g", value);
    // TOML distinguishes integers: 3 is not 3.0.
    return std::string(text).find_first_of(".e") == std::string::npos ? std::string(text) + ".0" : std::string(text);
}

/// Path relative to `folder` of a file that is given relative to `home`.
std::string seen_from(const std::filesystem::path& file, const std::filesystem::path& home,
                      const std::filesystem::path& folder) {
    if (file.is_absolute()) return file.string();
    std::error_code error;
    const std::filesystem::path there = std::filesystem::weakly_canonical(home / file, error),
                                from = std::filesystem::weakly_canonical(folder, error);
    const std::filesystem::path relative = there.lexically_relative(from);
    return relative.empty() ? there.string() : relative.string();
}

}  // namespace

std::string effect_tables(const std::vector<effect::EffectDeclaration>& effects, bool calibrate) {
    std::string text;
    for (const effect::EffectDeclaration& effect : effects) {
        text += "\n[[effect]]\nid = " + toml::toml_text(effect.id) + "\n";
        for (const auto& [name, value] : effect.parameters)
            text += name + " = " + experiment::effect_toml(value, short_number) + "\n";
        if (calibrate) text += "calibrate = true\n";
    }
    return text;
}

/// Whether a key before `place` names a file: `signal` does in a table [[muscle]], not in an [[effect]].
static bool names_a_file(const std::string& key, const std::string& text, std::size_t place) {
    if (key != "signal") return true;
    const std::size_t header = text.rfind("\n[", place);
    const std::string_view line = std::string_view(text).substr(header == std::string::npos ? 0 : header + 1);
    return !line.starts_with("[[effect]]");
}

Result<std::string> augmented_experiment(const std::filesystem::path& written,
                                         const std::vector<effect::EffectDeclaration>& effects,
                                         const std::filesystem::path& folder) {
    const Result<std::string> text = read_file(written);
    if (!text) return text.error();
    static const std::regex named(
        R"(\b(file|trace|actuation|mask|signal|sensors|path)(\s*=\s*)(\"[^\"\n]*\"|'[^'\n]*'))");
    std::string result;
    auto from = text->cbegin();
    for (std::sregex_iterator match(text->begin(), text->end(), named), end; match != end; ++match) {
        if (!names_a_file((*match)[1].str(), *text, static_cast<std::size_t>(match->position()))) continue;
        result.append(from, (*match)[0].first);
        const std::string name = (*match)[3].str();
        result += (*match)[1].str() + (*match)[2].str() +
                  toml::toml_text(seen_from(name.substr(1, name.size() - 2), written.parent_path(), folder));
        from = (*match)[0].second;
    }
    result.append(from, text->cend());
    if (!result.empty() && result.back() != '\n') result += '\n';
    if (!effects.empty())
        result +=
            "\n# Found by `myoloop diagnose`. Modulus and damping stay as declared: `myoloop calibrate` fits them "
            "together with what follows.";
    return result + effect_tables(effects, true);
}

}  // namespace myo::diagnosis
