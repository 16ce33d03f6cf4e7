#include "toml/toml_value.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/files.hpp"

namespace myo::toml {
namespace {

struct TomlValuePolicy {
    std::size_t largest_document = 16u << 20;
};
constexpr TomlValuePolicy toml_value_policy;

// "experiment.toml:12", or "line 12" in a text without name.
std::string line_of(const std::string& name, std::size_t line) {
    return (name.empty() ? "line " : name + ":") + std::to_string(line);
}

// Converts the library's nodes. A value from the command line has the same location as all its elements.
struct Converter {
    std::string name;
    std::optional<std::string> fixed_where;

    std::string where(const ::toml::source_region& region) const {
        return fixed_where ? *fixed_where : line_of(name, region.begin.line);
    }

    TomlValue table(const ::toml::table& source) const {
        // The library sorts by key; sorting by position restores the file order.
        std::vector<std::pair<const ::toml::key*, const ::toml::node*>> entries;
        for (auto&& [key, node] : source) entries.emplace_back(&key, &node);
        const auto position = [](const auto& entry) {
            const auto& begin = entry.first->source().begin;
            return std::pair{begin.line, begin.column};
        };
        std::stable_sort(entries.begin(), entries.end(),
                         [&](const auto& a, const auto& b) { return position(a) < position(b); });
        TomlValue result;
        for (const auto& [key, node] : entries) {
            result.keys.emplace_back(key->str());
            result.items.push_back(value(*node));
        }
        return result;
    }

    TomlValue value(const ::toml::node& node) const {
        TomlValue result;
        if (const auto* as_table = node.as_table()) {
            result = table(*as_table);
        } else if (const auto* as_array = node.as_array()) {
            result.kind = TomlValue::Kind::array;
            for (const ::toml::node& element : *as_array) result.items.push_back(value(element));
        } else if (const auto* as_text = node.as_string()) {
            result.kind = TomlValue::Kind::text;
            result.text = as_text->get();
        } else if (const auto* as_integer = node.as_integer()) {
            result.kind = TomlValue::Kind::number;
            result.number = static_cast<double>(as_integer->get());
        } else if (const auto* as_real = node.as_floating_point()) {
            result.kind = TomlValue::Kind::number;
            result.number = as_real->get();
        } else if (const auto* as_boolean = node.as_boolean()) {
            result.kind = TomlValue::Kind::boolean;
            result.truth = as_boolean->get();
        } else {
            result.kind = TomlValue::Kind::date;
        }
        result.where = where(node.source());
        return result;
    }
};

/// Letters, digits and characters of file names only, with at least one letter: "1e5x" is a word, "1e5" is a number.
bool is_bare_word(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto allowed = [&](char c) {
        return letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '/' || c == '-' ||
               static_cast<unsigned char>(c) > 127;
    };
    return std::all_of(text.begin(), text.end(), allowed) && std::any_of(text.begin(), text.end(), letter);
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

TomlValue* TomlValue::find(std::string_view key) { return const_cast<TomlValue*>(std::as_const(*this).find(key)); }

bool same_values(const TomlValue& a, const TomlValue& b) {
    if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
    switch (a.kind) {
        case TomlValue::Kind::text: return a.text == b.text;
        case TomlValue::Kind::number: return a.number == b.number || (std::isnan(a.number) && std::isnan(b.number));
        case TomlValue::Kind::boolean: return a.truth == b.truth;
        case TomlValue::Kind::date: return true;
        case TomlValue::Kind::array: return std::equal(a.items.begin(), a.items.end(), b.items.begin(), same_values);
        case TomlValue::Kind::table:
            for (std::size_t i = 0; i < a.items.size(); ++i) {
                const TomlValue* const other = b.find(a.keys[i]);
                if (other == nullptr || !same_values(a.items[i], *other)) return false;
            }
            return true;
    }
    return false;
}

std::string kind_name(TomlValue::Kind kind) {
    switch (kind) {
        case TomlValue::Kind::text: return "a string";
        case TomlValue::Kind::number: return "a number";
        case TomlValue::Kind::boolean: return "true or false";
        case TomlValue::Kind::date: return "a date or time";
        case TomlValue::Kind::array: return "an array";
        case TomlValue::Kind::table: return "a table";
    }
    return "a value";
}

Result<TomlValue> read_toml(const std::filesystem::path& path) {
    std::error_code code;
    // Size check first: reading a device or pipe would not end.
    if (std::filesystem::exists(path, code) && !std::filesystem::is_directory(path, code)) {
        if (!std::filesystem::is_regular_file(path, code)) return Error{"is not a regular file", path.string()};
        if (std::filesystem::file_size(path, code) > toml_value_policy.largest_document)
            return Error{"is larger than 16 MB, so it is no experiment description", path.string()};
    }
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    return parse_toml(*content, path.string());
}

Result<TomlValue> parse_toml(std::string_view text, const std::string& name) {
    try {
        const ::toml::table document = ::toml::parse(text);
        TomlValue result = Converter{name, {}}.table(document);
        result.where = line_of(name, 1);
        return result;
    } catch (const ::toml::parse_error& failure) {
        return Error{"this is not valid TOML: " + std::string(failure.description()),
                     line_of(name, failure.source().begin.line)};
    }
}

Result<TomlValue> parse_toml_value(std::string_view text, const std::string& where) {
    try {
        const ::toml::table document = ::toml::parse("value = " + std::string(text));
        // A line break in the text could add further keys.
        if (document.size() == 1) return Converter{{}, where}.value(*document.get("value"));
    } catch (const ::toml::parse_error&) {
        if (is_bare_word(text)) {
            TomlValue word;
            word.kind = TomlValue::Kind::text;
            word.text = text;
            word.where = where;
            return word;
        }
    }
    return Error{"\"" + std::string(text) + "\" is not one value in TOML syntax", where};
}

}  // namespace myo::toml
