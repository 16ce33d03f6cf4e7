#include "experiment/experiment_text.hpp"

#include <optional>
#include <regex>
#include <string>
#include <string_view>

#include "base/files.hpp"
#include "toml/toml_text.hpp"
#include "toml/toml_value.hpp"

namespace myo::experiment {
namespace {

/// Pattern of a TOML string of one line, in which a backslash escapes a quote.
const std::string quoted_pattern = R"re("[^"\\\n]*(?:\\.[^"\\\n]*)*"|'[^'\n]*')re";

/// What a quoted TOML string holds; empty if it is none, as may stand in a comment.
std::optional<std::string> unquoted(const std::string& quoted) {
    const Result<toml::TomlValue> line = toml::parse_toml("name = " + quoted, "");
    if (!line) return std::nullopt;
    return line->find("name")->text;
}

/// Path relative to `folder` of a file that is given relative to `home`.
std::string seen_from(const std::filesystem::path& file, const std::filesystem::path& home,
                      const std::filesystem::path& folder) {
    // An absolute name is valid from any folder.
    if (file.is_absolute()) return file.string();
    std::error_code error;
    const std::filesystem::path there = std::filesystem::weakly_canonical(home / file, error),
                                from = std::filesystem::weakly_canonical(folder, error);
    const std::filesystem::path relative = there.lexically_relative(from);
    // Without a relative path, as between two drives, the absolute name is the only valid one.
    // Keys of the document itself stand before its first table; `laws` in a table would be another key.
    return relative.empty() ? there.string() : relative.string();
}

/// Whether a key before `place` names a file: `signal` does in a table [[muscle]], not in an [[effect]].
bool names_a_file(const std::string& key, const std::string& text, std::size_t place) {
    if (key != "signal") return true;
    const std::size_t header = text.rfind("\n[", place);
    const std::string_view line = std::string_view(text).substr(header == std::string::npos ? 0 : header + 1);
    return !line.starts_with("[[effect]]");
}

/// The text with the names in the list `laws` at its top made relative to `folder`.
std::string with_laws_seen_from(const std::string& text, const std::filesystem::path& home,
                                const std::filesystem::path& folder) {
    static const std::regex list(R"((^|\n)(\s*laws\s*=\s*\[)([^\]]*)(\]))"), quoted(quoted_pattern);
    std::smatch found;
    const std::string top = text.substr(0, text.find("\n["));
    if (!std::regex_search(top, found, list)) return text;
    const std::string names = found[3].str();
    std::string moved;
    auto from = names.cbegin();
    for (std::sregex_iterator match(names.begin(), names.end(), quoted), end; match != end; ++match) {
        const std::optional<std::string> name = unquoted((*match)[0].str());
        if (!name) continue;
        moved.append(from, (*match)[0].first);
        moved += toml::toml_text(seen_from(*name, home, folder));
        from = (*match)[0].second;
    }
    moved.append(from, names.cend());
    const auto place = static_cast<std::size_t>(found.position(3));
    return text.substr(0, place) + moved + text.substr(place + names.size());
}

}  // namespace

Result<std::string> experiment_text_for(const std::filesystem::path& folder, const std::filesystem::path& written) {
    const Result<std::string> text = read_file(written);
    if (!text) return text.error();
    return experiment_text_for(folder, *text, written.parent_path());
}

std::string experiment_text_for(const std::filesystem::path& folder, const std::string& text,
                                const std::filesystem::path& home) {
    // The text is edited in place rather than parsed and written: comments, order and layout of the author remain.
    static const std::regex named(R"(\b(file|trace|actuation|mask|signal|sensors|path)(\s*=\s*)()" + quoted_pattern +
                                  ")");
    std::string result;
    auto from = text.cbegin();
    for (std::sregex_iterator match(text.begin(), text.end(), named), end; match != end; ++match) {
        if (!names_a_file((*match)[1].str(), text, static_cast<std::size_t>(match->position()))) continue;
        const std::optional<std::string> name = unquoted((*match)[3].str());
        if (!name) continue;
        result.append(from, (*match)[0].first);
        result += (*match)[1].str() + (*match)[2].str() + toml::toml_text(seen_from(*name, home, folder));
        from = (*match)[0].second;
    }
    result.append(from, text.cend());
    result = with_laws_seen_from(result, home, folder);
    if (!result.empty() && result.back() != '\n') result += '\n';
    return result;
}

}  // namespace myo::experiment
