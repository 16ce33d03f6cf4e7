#include "toml/toml_key.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.hpp"

namespace myo::toml {
namespace {

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

// Index of the element with the given `name` or `id`. Collects the names it passes, for the error message.
std::optional<std::size_t> element_by_name(const TomlValue& array, const std::string& name,
                                           std::vector<std::string>& names) {
    for (std::size_t i = 0; i < array.items.size(); ++i) {
        for (const char* identifier : {"name", "id"}) {
            const TomlValue* value = array.items[i].find(identifier);
            if (value == nullptr || value->kind != TomlValue::Kind::text) continue;
            if (value->text == name) return i;
            names.push_back(value->text);
        }
    }
    return std::nullopt;
}

/// The step of a name below `at`, which is null for what the document lacks.
Result<TomlStep> named_step(const TomlValue* at, const std::string& name, const std::string& path) {
    if (at == nullptr || at->kind == TomlValue::Kind::table) return TomlStep(name);
    if (at->kind != TomlValue::Kind::array)
        return Error{path + " is " + kind_name(at->kind) + ", so it has no " + name, ""};
    // After an array without index, the next part of the key is the name of an element.
    std::vector<std::string> names;
    if (const std::optional<std::size_t> index = element_by_name(*at, name, names)) return TomlStep(*index);
    const std::string near = closest_word(name, names);
    return Error{
        "no " + path + " is called \"" + name + "\"" + (near.empty() ? "" : "; the closest name is \"" + near + "\""),
        ""};
}

const TomlValue* below(const TomlValue* at, const TomlStep& step) {
    return at == nullptr ? nullptr : find_at(*at, {step});
}

}  // namespace

Result<TomlPath> path_of_key(const TomlValue& document, const std::string& key) {
    const std::optional<std::vector<KeyPart>> parts = split_key(key);
    if (!parts) return Error{"is not a key such as material.density_kg_m3 or trial[0].start_s", ""};
    TomlPath steps;
    const TomlValue* at = &document;
    std::string path;
    for (const KeyPart& part : *parts) {
        const Result<TomlStep> step = named_step(at, part.name, path);
        if (!step) return step.error();
        steps.push_back(*step);
        at = below(at, *step);
        path += (path.empty() ? "" : ".") + part.name;
        for (const std::size_t index : part.indices) {
            const bool list = at == nullptr || at->kind == TomlValue::Kind::array;
            const std::size_t count = at == nullptr ? 0 : at->items.size();
            if (!list || index > count)
                return Error{path + " has " + (list ? std::to_string(count) : "no") + " elements", ""};
            steps.emplace_back(index);
            at = below(at, steps.back());
            path += "[" + std::to_string(index) + "]";
        }
    }
    return steps;
}

}  // namespace myo::toml
