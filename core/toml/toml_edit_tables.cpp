#include <algorithm>
#include <vector>

#include "toml/toml_edit.hpp"
#include "toml/toml_edit_document.hpp"
#include "toml/toml_inline.hpp"

namespace myo::toml {
namespace {

// Consecutive statements at or below a path, as indices [begin, end).
std::vector<TextRange> runs_of(const TomlLayout& layout, const TomlPath& path) {
    std::vector<TextRange> runs;
    for (std::size_t i = 0; i < layout.statements.size(); ++i) {
        if (!starts_with(layout.statements[i].path, path)) continue;
        if (runs.empty() || runs.back().end != i) runs.push_back({i, i});
        runs.back().end = i + 1;
    }
    return runs;
}

// Text of a run of statements with the comments that belong to them.
TextRange text_of_run(const EditedDocument& document, const TextRange& run) {
    const auto& [text, values, layout] = document;
    const Statement& first = layout.statements[run.begin];
    const Statement& last = layout.statements[run.end - 1];
    const bool with_header = std::any_of(layout.statements.begin() + static_cast<std::ptrdiff_t>(run.begin),
                                         layout.statements.begin() + static_cast<std::ptrdiff_t>(run.end),
                                         [](const Statement& statement) { return statement.is_header(); });
    // Comments above a key may describe several keys.
    if (!with_header) return {first.lines.begin, last.lines.end};
    return {first.is_header() ? begin_with_comments(text, layout, run.begin) : first.lines.begin,
            end_with_comments(text, layout, run.end - 1)};
}

// Text of a run to be removed: with comments, and with the blank lines that would otherwise double.
TextRange removal_of_run(const EditedDocument& document, const TextRange& run) {
    const auto& [text, values, layout] = document;
    TextRange range = text_of_run(document, run);
    if (!layout.statements[run.begin].is_header()) return range;
    if (follows_blank_line(text, layout, range.begin))
        while (is_blank_line(text, range.end)) range.end = next_line(text, range.end);
    if (range.end == text.size())
        while (range.begin > layout.begin && follows_blank_line(text, layout, range.begin))
            range.begin = std::max(line_begin(text, range.begin - 1), layout.begin);
    return range;
}

// Removes part of a value.
Result<std::string> without_entry(std::string text, const Statement& assignment, const TomlPath& path) {
    std::vector<TextRange> ranges = inline_removals(text, assignment, path);
    for (std::size_t left = ranges.size(); left > 0; --left) {
        text = replaced(text, {{ranges.back(), ""}});
        const TomlLayout layout = layout_of(text);
        const Statement* const remaining = assignment_of(layout, path);
        if (left > 1) ranges = inline_removals(text, *remaining, path);
    }
    return text;
}

// The element that lines below a header "[[trial.load]]" describe.
//
// Errors: the lines are not valid, or hold anything else.
Result<TomlValue> element_of_body(const TomlPath& element, const std::string& body) {
    Result<TomlValue> parsed = parse_toml(header_text(element) + "\n" + body, {});
    if (!parsed) return Error{parsed.error().what, path_text(element)};
    TomlValue* at = &*parsed;
    for (const TomlStep& step : element) {
        if (std::holds_alternative<std::size_t>(step) && at->kind != TomlValue::Kind::array) continue;
        if (at->items.size() != 1) return Error{"the new lines hold more than one table", path_text(element)};
        at = &at->items.front();
    }
    return *at;
}

}  // namespace

Result<std::string> without(const std::string& document, const TomlPath& path) {
    Result<EditedDocument> opened = open_document(document);
    if (!opened) return opened.error();
    if (path.empty()) return Error{"the whole file cannot be removed", {}};
    if (find_at(opened->values, path) == nullptr) return document;
    remove_at(opened->values, path);

    const Statement* const assignment = assignment_of(opened->layout, path);
    if (assignment != nullptr && assignment->path != path) {
        const Result<std::string> text = without_entry(document, *assignment, path);
        return checked(*text, std::move(opened->values), path);
    }
    std::vector<Replacement> removals;
    for (const TextRange& run : runs_of(opened->layout, path)) removals.push_back({removal_of_run(*opened, run), ""});
    return checked(replaced(document, removals), std::move(opened->values), path);
}

Result<std::string> with_appended_table(const std::string& document, const TomlPath& array, const std::string& body) {
    Result<EditedDocument> opened = open_document(document);
    if (!opened) return opened.error();
    if (array.empty() || !std::holds_alternative<std::string>(array.back()))
        return Error{"is no key of an array of tables", path_text(array)};
    if (assignment_of(opened->layout, array) != nullptr)
        return Error{"is not written as tables with headers, so no table can be appended", path_text(array)};
    for (std::size_t count = 1; count < array.size(); ++count) {
        const TomlPath parent = first_steps(array, count);
        if (std::holds_alternative<std::size_t>(parent.back()) && find_at(opened->values, parent) == nullptr)
            return Error{path_text(parent) + " does not exist", path_text(array)};
    }
    const TomlValue* const present = find_at(opened->values, array);
    if (present != nullptr && present->kind != TomlValue::Kind::array)
        return Error{"is " + kind_name(present->kind) + " and not an array of tables", path_text(array)};
    TomlPath element = array;
    element.emplace_back(present == nullptr ? 0 : present->items.size());

    const std::string lines = body.empty() || body.back() == '\n' ? body : body + "\n";
    const Result<TomlValue> value = element_of_body(element, with_line_ends(lines, line_end_of(document)));
    if (!value) return value.error();
    if (const Result<void> set = set_at(opened->values, element, *value); !set) return set.error();
    const std::string text = replaced(document, {inserted_table(*opened, element, lines)});
    return checked(text, std::move(opened->values), element);
}

Result<std::string> with_duplicated_table(const std::string& document, const TomlPath& element) {
    Result<EditedDocument> opened = open_document(document);
    if (!opened) return opened.error();
    const auto& [text, values, layout] = *opened;
    const auto is_header = [&](const Statement& s) { return s.kind == Statement::Kind::element && s.path == element; };
    if (std::none_of(layout.statements.begin(), layout.statements.end(), is_header))
        return Error{"is no element of an array of tables", path_text(element)};
    TomlValue expected = values;
    TomlValue& array = *find_at(expected, first_steps(element, element.size() - 1));
    const std::size_t index = std::get<std::size_t>(element.back());
    const TomlValue copy = array.items[index];
    array.items.insert(array.items.begin() + static_cast<std::ptrdiff_t>(index), copy);

    std::string lines;
    std::size_t at = 0;
    for (const TextRange& run : runs_of(layout, element)) {
        const TextRange range = text_of_run(*opened, run);
        if (lines.empty() && follows_blank_line(text, layout, range.begin)) lines = "\n";
        lines += text.substr(range.begin, range.end - range.begin);
        if (lines.back() != '\n') lines += "\n";
        at = range.end;
    }
    return checked(replaced(text, {inserted_lines(text, at, lines)}), std::move(expected), element);
}

}  // namespace myo::toml
