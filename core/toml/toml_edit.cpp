#include "toml/toml_edit.hpp"

#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "toml/toml_edit_document.hpp"
#include "toml/toml_inline.hpp"
#include "toml/toml_text.hpp"

namespace myo::toml {
namespace {

// One value without anything around it.
Result<TomlValue> single_value(const std::string& value, const TomlPath& path) {
    const std::string assignment = "value = ";
    const std::string text = assignment + value;
    const Result<TomlValue> parsed = parse_toml(text, {});
    if (parsed && parsed->items.size() == 1) {
        const TomlLayout layout = layout_of(text);
        const TextRange range = layout.statements.front().value.range;
        if (range.begin == assignment.size() && range.end == text.size()) return parsed->items.front();
    }
    return Error{"\"" + value + "\" is not one value in TOML syntax", path_text(path)};
}

// Names of the steps behind the first `count`, as a dotted key; empty if one of them is an index.
std::optional<std::string> dotted_key(const TomlPath& path, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = count; i < path.size(); ++i) {
        const std::string* name = std::get_if<std::string>(&path[i]);
        if (name == nullptr) return std::nullopt;
        names.push_back(toml_key(*name));
    }
    return join(names, ".");
}

// Adds a key behind a statement of its section, indented as that one.
Replacement added_behind(const std::string& text, const Statement& statement, const std::string& line) {
    return inserted_lines(text, statement.lines.end, indentation(text, statement.keys.front().range.begin) + line);
}

// Adds a key above all headers.
Replacement added_at_top(const EditedDocument& document, const std::string& line) {
    const auto& [text, values, layout] = document;
    if (layout.statements.empty()) return inserted_lines(text, text.size(), line);
    if (!layout.statements.front().is_header())
        return added_behind(text, layout.statements[last_of_section(layout, 0)], line);
    return inserted_lines(text, begin_with_comments(text, layout, 0), line + "\n");
}

// The assignment that shares the longest beginning of a dotted key with a path, if it reaches further than headers do.
const Statement* dotted_neighbour(const TomlLayout& layout, const TomlPath& path) {
    std::size_t most = steps_in_headers(layout, first_steps(path, path.size() - 1));
    const Statement* nearest = nullptr;
    for (const Statement& statement : layout.statements) {
        if (statement.is_header()) continue;
        const std::size_t common = common_steps(statement.path, path);
        if (common <= statement.section().size() || common < most || (common == most && nearest == nullptr)) continue;
        most = common;
        nearest = &statement;
    }
    return nearest;
}

// Adds a table that has no header yet, with its first key.
Result<Replacement> added_table(const EditedDocument& document, const TomlPath& path, const std::string& line) {
    const auto& [text, values, layout] = document;
    const TomlPath table = first_steps(path, path.size() - 1);
    const std::size_t known = steps_in_headers(layout, table);
    if (known == table.size()) {
        // Only its subtables have headers.
        const std::size_t at = begin_with_comments(text, layout, *first_statement_of(layout, table));
        return inserted_lines(text, at, header_text(table) + "\n" + line);
    }
    for (std::size_t i = known; i + 1 < table.size(); ++i)
        if (std::holds_alternative<std::size_t>(table[i]))
            return Error{path_text(first_steps(table, i + 1)) + " does not exist", path_text(path)};
    return inserted_table(document, table, line);
}

// Adds a key that is not part of a value.
Result<Replacement> added_key(const EditedDocument& document, const TomlPath& path, const std::string& value) {
    const auto& [text, values, layout] = document;
    const std::optional<std::string> key = dotted_key(path, path.size() - 1);
    if (!key) return Error{"is an element of an array of tables, which no value replaces", path_text(path)};
    const std::string line = *key + " = " + value + "\n";
    const TomlPath table = first_steps(path, path.size() - 1);
    if (table.empty()) return added_at_top(document, line);
    for (std::size_t i = 0; i < layout.statements.size(); ++i)
        if (layout.statements[i].is_header() && layout.statements[i].path == table)
            return added_behind(text, layout.statements[last_of_section(layout, i)], line);
    if (const Statement* neighbour = dotted_neighbour(layout, path))
        if (const auto dotted = dotted_key(path, neighbour->section().size()))
            return added_behind(text, *neighbour, *dotted + " = " + value + "\n");
    return added_table(document, path, line);
}

Result<Replacement> set_value(const EditedDocument& document, const TomlPath& path, const std::string& value) {
    const Statement* const assignment = assignment_of(document.layout, path);
    if (assignment != nullptr && assignment->path == path) return Replacement{assignment->value.range, value};
    if (assignment != nullptr) return set_inline(document.text, *assignment, path, value);
    if (first_statement_of(document.layout, path))
        return Error{"is a table with lines of its own, which no value replaces", path_text(path)};
    // The first element of a new array of values.
    const TomlPath parent = first_steps(path, path.size() - 1);
    if (std::holds_alternative<std::size_t>(path.back()) && !first_statement_of(document.layout, parent))
        return set_value(document, parent, "[" + value + "]");
    return added_key(document, path, value);
}

}  // namespace

Result<std::string> with_value(const std::string& document, const TomlPath& path, const std::string& value) {
    Result<EditedDocument> opened = open_document(document);
    if (!opened) return opened.error();
    const std::string new_text = with_line_ends(value, line_end_of(document));
    const Result<TomlValue> new_value = single_value(new_text, path);
    if (!new_value) return new_value.error();
    if (path.empty()) return Error{"the whole file is no value to be set", {}};
    if (const Result<void> set = set_at(opened->values, path, *new_value); !set) return set.error();
    const Result<Replacement> replacement = set_value(*opened, path, new_text);
    if (!replacement) return replacement.error();
    return checked(replaced(document, {*replacement}), std::move(opened->values), path);
}

Result<std::string> with_renamed_key(const std::string& document, const TomlPath& path, const std::string& key) {
    Result<EditedDocument> opened = open_document(document);
    if (!opened) return opened.error();
    const std::string* const former = path.empty() ? nullptr : std::get_if<std::string>(&path.back());
    if (former == nullptr || find_at(opened->values, path) == nullptr)
        return Error{"is no key of a table", path_text(path)};
    if (key == *former) return document;
    TomlValue& table = *find_at(opened->values, first_steps(path, path.size() - 1));
    if (table.find(key) != nullptr) return Error{"the name \"" + key + "\" is taken", path_text(path)};
    *std::find(table.keys.begin(), table.keys.end(), *former) = key;

    std::vector<Replacement> replacements;
    for (const Statement& statement : opened->layout.statements)
        for (const KeyPlace& part : statement.keys)
            if (part.depth == path.size() && starts_with(statement.path, path))
                replacements.push_back({part.range, toml_key(key)});
    if (const Statement* const assignment = assignment_of(opened->layout, path); assignment && assignment->path != path)
        for (const KeyPlace& part : inline_keys(*assignment, path)) replacements.push_back({part.range, toml_key(key)});
    return checked(replaced(document, replacements), std::move(opened->values), path);
}

}  // namespace myo::toml
