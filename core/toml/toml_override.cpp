#include "toml/toml_override.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "base/text.hpp"

namespace myo::toml {
namespace {

const std::string command_line = "--set";

struct KeyPart {
    std::string name;
    std::vector<std::size_t> indices;  // name[1][2]
};

// Parts of a key "a.b[2].\"c.d\""; empty if malformed.
std::optional<std::vector<KeyPart>> split_key(const std::string& key) {
    std::vector<KeyPart> parts;
    std::size_t at = 0;
    while (true) {
        KeyPart part;
        if (at < key.size() && key[at] == '"') {
            const std::size_t end = key.find('"', at + 1);
            if (end == std::string::npos) return std::nullopt;
            part.name = key.substr(at + 1, end - at - 1);
            at = end + 1;
        } else {
            const std::size_t end = std::min(key.find_first_of(".[", at), key.size());
            part.name = key.substr(at, end - at);
            at = end;
        }
        if (part.name.empty()) return std::nullopt;
        // Any number of indices may follow a name.
        while (at < key.size() && key[at] == '[') {
            std::size_t index = 0;
            const char* const last = key.data() + key.size();
            const auto [end, code] = std::from_chars(key.data() + at + 1, last, index);
            if (code != std::errc{} || end == last || *end != ']') return std::nullopt;
            part.indices.push_back(index);
            at = static_cast<std::size_t>(end - key.data()) + 1;
        }
        parts.push_back(part);
        if (at == key.size()) return parts;
        if (key[at] != '.') return std::nullopt;
        ++at;
    }
}

/// New value with the location "--set".
TomlValue empty(TomlValue::Kind kind) {
    TomlValue value;
    value.kind = kind;
    value.where = command_line;
    return value;
}

/// Entry of a table; created with the given type if absent.
TomlValue& entry(TomlValue& table, const std::string& key, TomlValue::Kind kind_when_new) {
    if (TomlValue* found = table.find(key)) return *found;
    table.keys.push_back(key);
    table.items.push_back(empty(kind_when_new));
    return table.items.back();
}

// Element of an array of tables with the given `name` or `id`. Collects the names it passes, for the error message.
TomlValue* element_by_name(TomlValue& array, const std::string& name, std::vector<std::string>& names) {
    for (TomlValue& item : array.items) {
        for (const char* identifier : {"name", "id"}) {
            const TomlValue* value = item.find(identifier);
            if (value == nullptr || value->kind != TomlValue::Kind::text) continue;
            if (value->text == name) return &item;
            names.push_back(value->text);
        }
    }
    return nullptr;
}

}  // namespace

Result<void> override_toml(TomlValue& document, const std::string& key, const std::string& value) {
    using Kind = TomlValue::Kind;
    const auto fail = [&](const std::string& sentence) { return Error{key + ": " + sentence, command_line}; };
    const auto parts = split_key(key);
    if (!parts) return fail("is not a key such as material.density_kg_m3 or trial[0].start_s");
    Result<TomlValue> parsed = parse_toml_value(value, command_line);
    if (!parsed) return fail(parsed.error().what);

    TomlValue* at = &document;
    std::string path;
    for (const KeyPart& part : *parts) {
        // After an array without index, the next part of the key is the name of an element.
        if (at->kind == Kind::array) {
            std::vector<std::string> names;
            TomlValue* element = element_by_name(*at, part.name, names);
            if (element == nullptr) {
                const std::string near = closest_word(part.name, names);
                return fail("no " + path + " is called \"" + part.name + "\"" +
                            (near.empty() ? "" : "; the closest name is \"" + near + "\""));
            }
            at = element;
        } else if (at->kind == Kind::table) {
            // The last part is created as a table too; its value replaces it below.
            at = &entry(*at, part.name, part.indices.empty() ? Kind::table : Kind::array);
        } else {
            return fail(path + " is " + kind_name(at->kind) + ", so it has no " + part.name);
        }
        path += (path.empty() ? "" : ".") + part.name;
        for (const std::size_t index : part.indices) {
            if (at->kind != Kind::array || index > at->items.size())
                return fail(path + " has " + (at->kind == Kind::array ? std::to_string(at->items.size()) : "no") +
                            " elements");
            if (index == at->items.size()) at->items.push_back(empty(Kind::table));
            at = &at->items[index];
            path += "[" + std::to_string(index) + "]";
        }
    }
    *at = *parsed;
    return {};
}

}  // namespace myo::toml
