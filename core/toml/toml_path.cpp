#include "toml/toml_path.hpp"

#include <algorithm>
#include <utility>

namespace myo::toml {
namespace {

// Child of a value; null if absent.
TomlValue* child(TomlValue& parent, const TomlStep& step) {
    if (const std::string* key = std::get_if<std::string>(&step))
        return parent.kind == TomlValue::Kind::table ? parent.find(*key) : nullptr;
    const std::size_t index = std::get<std::size_t>(step);
    return parent.kind == TomlValue::Kind::array && index < parent.items.size() ? &parent.items[index] : nullptr;
}

// Why a value cannot have a new child at that step; empty if it can.
std::string obstacle(const TomlValue& parent, const std::string& name, const TomlStep& step) {
    if (const std::string* key = std::get_if<std::string>(&step))
        return parent.kind == TomlValue::Kind::table
                   ? ""
                   : name + " is " + kind_name(parent.kind) + ", so it has no " + *key;
    if (parent.kind != TomlValue::Kind::array)
        return name + " is " + kind_name(parent.kind) + ", so it has no numbered elements";
    if (std::get<std::size_t>(step) > parent.items.size())
        return name + " has " + std::to_string(parent.items.size()) + " elements";
    return {};
}

}  // namespace

std::string path_text(const TomlPath& path) {
    std::string text;
    for (const TomlStep& step : path) {
        if (const std::string* key = std::get_if<std::string>(&step))
            text += (text.empty() ? "" : ".") + *key;
        else
            text += "[" + std::to_string(std::get<std::size_t>(step)) + "]";
    }
    return text;
}

std::string element_text(const std::string& array, std::size_t index) { return path_text({array, index}); }

std::size_t common_steps(const TomlPath& a, const TomlPath& b) {
    return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

bool starts_with(const TomlPath& path, const TomlPath& prefix) { return common_steps(path, prefix) == prefix.size(); }

TomlPath first_steps(const TomlPath& path, std::size_t count) {
    return {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count)};
}

TomlValue* find_at(TomlValue& document, const TomlPath& path) {
    TomlValue* at = &document;
    for (const TomlStep& step : path)
        if (at != nullptr) at = child(*at, step);
    return at;
}

const TomlValue* find_at(const TomlValue& document, const TomlPath& path) {
    return find_at(const_cast<TomlValue&>(document), path);
}

Result<void> set_at(TomlValue& document, const TomlPath& path, const TomlValue& value) {
    TomlValue* at = &document;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (TomlValue* found = child(*at, path[i])) {
            at = found;
            continue;
        }
        const std::string reason = obstacle(*at, i == 0 ? "the file" : path_text(first_steps(path, i)), path[i]);
        if (!reason.empty()) return Error{reason, path_text(path)};
        if (const std::string* key = std::get_if<std::string>(&path[i])) at->keys.push_back(*key);
        at->items.emplace_back();
        at = &at->items.back();
        // The next step says what the new value has to be.
        if (i + 1 < path.size() && std::holds_alternative<std::size_t>(path[i + 1])) at->kind = TomlValue::Kind::array;
    }
    *at = value;
    return {};
}

void remove_at(TomlValue& document, const TomlPath& path) {
    TomlValue* const parent = path.empty() ? nullptr : find_at(document, first_steps(path, path.size() - 1));
    TomlValue* const removed = parent == nullptr ? nullptr : child(*parent, path.back());
    if (removed == nullptr) return;
    const std::ptrdiff_t place = removed - parent->items.data();
    parent->items.erase(parent->items.begin() + place);
    if (parent->kind == TomlValue::Kind::table) parent->keys.erase(parent->keys.begin() + place);
}

}  // namespace myo::toml
