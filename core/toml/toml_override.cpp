#include "toml/toml_override.hpp"

#include "toml/toml_key.hpp"

namespace myo::toml {
namespace {

const std::string command_line = "--set";

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

}  // namespace

Result<void> override_toml(TomlValue& document, const std::string& key, const std::string& value) {
    using Kind = TomlValue::Kind;
    const auto fail = [&](const Error& error) { return Error{key + ": " + error.what, command_line}; };
    const Result<TomlPath> path = path_of_key(document, key);
    if (!path) return fail(path.error());
    Result<TomlValue> parsed = parse_toml_value(value, command_line);
    if (!parsed) return fail(parsed.error());

    TomlValue* at = &document;
    for (std::size_t i = 0; i < path->size(); ++i) {
        // The next step says what a new value has to be; the last one is created as a table, which its value replaces.
        const bool list = i + 1 < path->size() && std::holds_alternative<std::size_t>((*path)[i + 1]);
        if (const std::string* name = std::get_if<std::string>(&(*path)[i])) {
            at = &entry(*at, *name, list ? Kind::array : Kind::table);
            continue;
        }
        const std::size_t index = std::get<std::size_t>((*path)[i]);
        if (index == at->items.size()) at->items.push_back(empty(list ? Kind::array : Kind::table));
        at = &at->items[index];
    }
    *at = *parsed;
    return {};
}

}  // namespace myo::toml
