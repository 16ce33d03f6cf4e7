#include "toml/toml_edit_document.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "toml/toml_text.hpp"

namespace myo::toml {
namespace {

bool is_empty_container(const TomlValue& value) {
    return (value.kind == TomlValue::Kind::table || value.kind == TomlValue::Kind::array) && value.items.empty();
}

// True if a header stands for a table or an element of an array directly below a path.
bool is_directly_below(const Statement& header, const TomlPath& parent) {
    if (!header.is_header() || !starts_with(header.path, parent)) return false;
    const std::size_t steps = header.path.size() - parent.size();
    return steps == 1 || (steps == 2 && header.kind == Statement::Kind::element);
}

// True if a blank line separates a new table below `parent` from what is above: always at the top level, otherwise as
// for the last table with that parent.
bool stands_apart(const EditedDocument& document, const TomlPath& parent) {
    const auto& [text, values, layout] = document;
    if (parent.empty()) return true;
    for (std::size_t i = layout.statements.size(); i-- > 0;)
        if (is_directly_below(layout.statements[i], parent))
            return follows_blank_line(text, layout, begin_with_comments(text, layout, i));
    return false;
}

}  // namespace

Result<EditedDocument> open_document(const std::string& text) {
    Result<TomlValue> values = parse_toml(text, {});
    if (!values) return values.error();
    return EditedDocument{text, std::move(*values), layout_of(text)};
}

Result<std::string> checked(const std::string& text, TomlValue expected, const TomlPath& path) {
    const Result<TomlValue> values = parse_toml(text, {});
    if (values) {
        for (std::size_t count = path.size(); count-- > 1;) {
            const TomlPath parent = first_steps(path, count);
            const TomlValue* const value = find_at(expected, parent);
            if (value != nullptr && is_empty_container(*value) && find_at(*values, parent) == nullptr)
                remove_at(expected, parent);
        }
        if (same_values(*values, expected)) return text;
    }
    return Error{"cannot be changed without changing other parts of the file", path_text(path)};
}

const Statement* assignment_of(const TomlLayout& layout, const TomlPath& path) {
    for (const Statement& statement : layout.statements)
        if (!statement.is_header() && starts_with(path, statement.path)) return &statement;
    return nullptr;
}

std::optional<std::size_t> last_statement_of(const TomlLayout& layout, const TomlPath& path) {
    for (std::size_t i = layout.statements.size(); i-- > 0;)
        if (starts_with(layout.statements[i].path, path)) return i;
    return std::nullopt;
}

std::optional<std::size_t> first_statement_of(const TomlLayout& layout, const TomlPath& path) {
    for (std::size_t i = 0; i < layout.statements.size(); ++i)
        if (starts_with(layout.statements[i].path, path)) return i;
    return std::nullopt;
}

std::size_t last_of_section(const TomlLayout& layout, std::size_t statement) {
    std::size_t last = statement;
    while (last + 1 < layout.statements.size() && !layout.statements[last + 1].is_header()) ++last;
    return last;
}

std::size_t steps_in_headers(const TomlLayout& layout, const TomlPath& path) {
    std::size_t most = 0;
    for (const Statement& statement : layout.statements)
        if (statement.is_header()) most = std::max(most, common_steps(statement.path, path));
    return most;
}

std::string header_text(const TomlPath& path) {
    std::vector<std::string> names;
    for (const TomlStep& step : path)
        if (const std::string* name = std::get_if<std::string>(&step)) names.push_back(toml_key(*name));
    const bool element = std::holds_alternative<std::size_t>(path.back());
    return (element ? "[[" : "[") + join(names, ".") + (element ? "]]" : "]");
}

Replacement inserted_table(const EditedDocument& document, const TomlPath& path, const std::string& lines) {
    const auto& [text, values, layout] = document;
    // The innermost table or array on the path that has statements; the whole file if there is none.
    TomlPath neighbours = first_steps(path, path.size() - 1);
    while (!neighbours.empty() && !last_statement_of(layout, neighbours)) neighbours.pop_back();
    std::size_t at = text.size();
    // A header among dotted keys would take the keys below it.
    if (!neighbours.empty())
        at = end_with_comments(text, layout, last_of_section(layout, *last_statement_of(layout, neighbours)));
    const bool apart = stands_apart(document, neighbours);
    const bool blank_above = apart && !follows_blank_line(text, layout, at);
    const bool blank_below = apart && at < text.size() && !is_blank_line(text, at);
    return inserted_lines(text, at,
                          (blank_above ? "\n" : "") + header_text(path) + "\n" + lines + (blank_below ? "\n" : ""));
}

}  // namespace myo::toml
