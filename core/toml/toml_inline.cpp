#include "toml/toml_inline.hpp"

#include <algorithm>
#include <cassert>

#include "toml/toml_text.hpp"

namespace myo::toml {
namespace {

// The entries of a value that a path names.
struct InlinePlace {
    const ValuePlace* container = nullptr;  // innermost array or table on the path, without the value itself
    TomlPath rest;                          // steps from there
    std::vector<std::size_t> entries;       // at or below that place; several for a table of dotted keys

    bool is_one_value() const {
        return entries.size() == 1 && (container->kind == ValuePlace::Kind::array ||
                                       container->entries[entries.front()].keys.size() == rest.size());
    }
};

// Number of steps that the keys of an entry, or its index, follow the path.
std::size_t followed_steps(const ValuePlace& container, std::size_t entry, const TomlPath& steps) {
    if (container.kind == ValuePlace::Kind::array) return steps.front() == TomlStep(entry) ? 1 : 0;
    TomlPath names;
    for (const KeyPlace& key : container.entries[entry].keys) names.emplace_back(key.name);
    return common_steps(names, steps);
}

std::size_t step_count(const ValuePlace& entry) { return std::max<std::size_t>(entry.keys.size(), 1); }

// Entry that a path passes on its way to a place within; null if there is none.
const ValuePlace* passed_entry(const ValuePlace& container, const TomlPath& steps) {
    for (std::size_t i = 0; i < container.entries.size(); ++i) {
        const std::size_t count = step_count(container.entries[i]);
        if (count < steps.size() && followed_steps(container, i, steps) == count) return &container.entries[i];
    }
    return nullptr;
}

InlinePlace inline_place(const Statement& assignment, const TomlPath& path) {
    assert(path.size() > assignment.path.size() && starts_with(path, assignment.path));
    const auto without_first = [](const TomlPath& steps, std::size_t count) {
        return TomlPath(steps.begin() + static_cast<std::ptrdiff_t>(count), steps.end());
    };
    InlinePlace place{&assignment.value, without_first(path, assignment.path.size()), {}};
    while (const ValuePlace* const entry = passed_entry(*place.container, place.rest)) {
        place.container = entry;
        place.rest = without_first(place.rest, step_count(*entry));
    }
    for (std::size_t i = 0; i < place.container->entries.size(); ++i)
        if (followed_steps(*place.container, i, place.rest) == place.rest.size()) place.entries.push_back(i);
    return place;
}

bool has_line_end(const std::string& text, std::size_t begin, std::size_t end) {
    return std::find(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end),
                     '\n') != text.begin() + static_cast<std::ptrdiff_t>(end);
}

// Position of the comma behind an entry; npos if there is none. Comments may stand before it.
std::size_t comma_behind(const std::string& text, const ValuePlace& entry) {
    std::size_t at = entry.range.end;
    while ((at = text.find_first_not_of(" \t\r\n", at)) != std::string::npos && text[at] == '#')
        at = next_line(text, at);
    return at != std::string::npos && text[at] == ',' ? at : std::string::npos;
}

std::string nested_value(const TomlPath& steps, std::size_t first, const std::string& value);

// Entry of an inline table that holds a value at the steps from `first` on: "a.b = [value]".
std::string nested_entry(const TomlPath& steps, std::size_t first, const std::string& value) {
    std::string keys;
    std::size_t at = first;
    for (; at < steps.size() && std::holds_alternative<std::string>(steps[at]); ++at)
        keys += (at == first ? "" : ".") + toml_key(std::get<std::string>(steps[at]));
    return keys + " = " + nested_value(steps, at, value);
}

// Value that holds another at the steps from `first` on, as the only one.
std::string nested_value(const TomlPath& steps, std::size_t first, const std::string& value) {
    if (first == steps.size()) return value;
    if (std::holds_alternative<std::string>(steps[first])) return "{ " + nested_entry(steps, first, value) + " }";
    return "[" + nested_value(steps, first + 1, value) + "]";
}

// Inserts an entry behind the last one.
Replacement appended_entry(const std::string& text, const ValuePlace& container, const std::string& entry) {
    if (container.entries.empty()) {
        const bool table = container.kind == ValuePlace::Kind::table;
        if (has_line_end(text, container.range.begin, container.range.end))
            return {{container.range.begin + 1, container.range.begin + 1}, entry};
        return {{container.range.begin + 1, container.range.end - 1}, table ? " " + entry + " " : entry};
    }
    const ValuePlace& last = container.entries.back();
    const std::size_t above = container.entries.size() > 1 ? container.entries.end()[-2].range.end
                                                           : container.range.begin;
    const std::size_t behind = last.range.end;
    if (!has_line_end(text, above, last.begin())) return {{behind, behind}, ", " + entry};
    const std::string new_line = line_end_of(text) + indentation(text, last.begin()) + entry;
    const std::size_t comma = comma_behind(text, last);
    const std::size_t line_end = text.find_last_not_of("\r\n", next_line(text, behind) - 1) + 1;
    // The bracket stands on the same line.
    if (line_end >= container.range.end) return {{behind, behind}, "," + new_line};
    // The comment behind the last entry stays on its line.
    if (comma == std::string::npos)
        return {{behind, line_end}, "," + text.substr(behind, line_end - behind) + new_line};
    return {{std::max(line_end, comma + 1), std::max(line_end, comma + 1)}, new_line + ","};
}

// An entry with its comma, and with its lines and comment if it stands on lines of its own.
TextRange removal(const std::string& text, const ValuePlace& container, std::size_t index) {
    const ValuePlace& entry = container.entries[index];
    const bool first = index == 0;
    const std::size_t above = first ? container.range.begin + 1 : container.entries[index - 1].range.end;
    const std::size_t comma = comma_behind(text, entry);
    const std::size_t own_end = comma == std::string::npos ? entry.range.end : comma + 1;
    const bool new_line = has_line_end(text, above, entry.begin());
    // Behind the entry: the end of the line, or a comment.
    const std::size_t behind = std::min(text.find_first_not_of(" \t\r", own_end), text.size());
    const bool ends_line = behind < container.range.end && (text[behind] == '\n' || text[behind] == '#');
    if (new_line && ends_line) return {line_begin(text, entry.begin()), next_line(text, own_end)};
    if (index + 1 < container.entries.size() || new_line)
        return {entry.begin(), std::min(text.find_first_not_of(" \t", own_end), text.size())};
    if (!first) return {above, entry.range.end};
    return {above, container.range.end - 1};
}

}  // namespace

Result<Replacement> set_inline(const std::string& text, const Statement& assignment, const TomlPath& path,
                               const std::string& value) {
    const InlinePlace place = inline_place(assignment, path);
    if (place.is_one_value()) return Replacement{place.container->entries[place.entries.front()].range, value};
    if (!place.entries.empty()) return Error{"is a table with dotted keys, which no value replaces", path_text(path)};
    const bool array = place.container->kind == ValuePlace::Kind::array;
    return appended_entry(text, *place.container,
                          array ? nested_value(place.rest, 1, value) : nested_entry(place.rest, 0, value));
}

std::vector<TextRange> inline_removals(const std::string& text, const Statement& assignment, const TomlPath& path) {
    const InlinePlace place = inline_place(assignment, path);
    std::vector<TextRange> ranges;
    for (const std::size_t entry : place.entries) ranges.push_back(removal(text, *place.container, entry));
    return ranges;
}

std::vector<KeyPlace> inline_keys(const Statement& assignment, const TomlPath& path) {
    const InlinePlace place = inline_place(assignment, path);
    std::vector<KeyPlace> found;
    for (const std::size_t entry : place.entries)
        if (place.container->kind == ValuePlace::Kind::table)
            found.push_back(place.container->entries[entry].keys[place.rest.size() - 1]);
    return found;
}

}  // namespace myo::toml
