#include "report/html_report.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "base/markup.hpp"
#include "report/html_parts.hpp"

namespace myo::report {
namespace {

/// <name>content</name>; the content must be escaped.
std::string element(const std::string& name, const std::string& escaped_content) {
    return "<" + name + ">" + escaped_content + "</" + name + ">\n";
}

/// Unordered list of plain texts; empty without items.
std::string list_of(const std::vector<std::string>& items) {
    std::string out;
    for (const std::string& item : items) out += element("li", escape_markup(item));
    return items.empty() ? out : element("ul", out);
}

/// Splits at blank lines.
std::string block(const Paragraph& paragraph) {
    std::string out, rest = paragraph.text;
    for (std::size_t end = 0; !rest.empty(); rest.erase(0, end)) {
        end = std::min(rest.find("\n\n"), rest.size());
        out += element("p", escape_markup(rest.substr(0, end)));
        end = std::min(rest.find_first_not_of('\n', end), rest.size());
    }
    return out;
}

std::string block(const BulletList& list) { return list_of(list.items); }

// Tables have their own file because of the number formats.
std::string block(const Table& table) { return html_table(table); }

std::string block(const Figure& figure) {
    // The SVG comes from svg() and is inserted without escaping.
    std::string out = "<figure>\n" + figure.svg;
    if (!figure.caption.empty()) out += element("figcaption", escape_markup(figure.caption));
    return out + "</figure>\n";
}

/// Empty without warnings.
std::string block(const WarningBox& box) {
    if (box.lines.empty()) return {};
    std::string out = "<div class=\"warn\" role=\"note\"><strong>";
    out += box.lines.size() == 1 ? "Warning" : "Warnings";
    return out + "</strong>" + (box.lines.size() == 1 ? escape_markup(box.lines[0]) : list_of(box.lines)) + "</div>\n";
}

std::string block(const Preformatted& text) { return element("pre", escape_markup(text.text)); }

// HTML has no entities within a script element, so the text must not contain "<", which could end the element, nor, for
// XML readers of the page, "&". In JSON both occur within strings only, where \u escapes are equivalent.
std::string block(const EmbeddedJson& json) {
    std::string safe;
    for (const char c : json_line(json.value)) {
        if (c == '<')
            safe += "\\u003c";
        else if (c == '>')
            safe += "\\u003e";
        else if (c == '&')
            safe += "\\u0026";
        else
            safe += c;
    }
    return "<script type=\"application/json\" id=\"" + escape_markup(json.id) + "\">" + safe + "</script>\n";
}

std::string blocks(const std::vector<Block>& content);

// Details contain blocks, and blocks may be details: hence the declaration above.
std::string block(const Details& details) {
    return "<details><summary>" + escape_markup(details.summary) + "</summary>\n" + blocks(details.blocks) +
           "</details>\n";
}

std::string blocks(const std::vector<Block>& content) {
    std::string out;
    // A new kind of block is an alternative of Block and an overload above.
    for (const Block& one : content) out += std::visit([](const auto& kind) { return block(kind); }, one.content);
    return out;
}

/// Key figures as a definition list.
std::string tiles(const std::vector<KeyFigure>& figures) {
    if (figures.empty()) return {};
    std::string out = "<dl class=\"figures\">\n";
    for (const KeyFigure& figure : figures) {
        out += "<div><dt>" + escape_markup(figure.label) + "</dt><dd>" + escape_markup(figure.value);
        if (!figure.unit.empty()) out += " <span class=\"unit\">" + escape_markup(figure.unit) + "</span>";
        if (!figure.note.empty()) out += "<span class=\"note\">" + escape_markup(figure.note) + "</span>";
        out += "</dd></div>\n";
    }
    return out + "</dl>\n";
}

}  // namespace

std::string html(const HtmlReport& report) {
    const std::string title = escape_markup(report.title);
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        // An empty icon in the page prevents browsers from requesting one.
        "<link rel=\"icon\" href=\"data:,\"/>\n<title>" +
        title + "</title>\n<style>" + std::string(html_style()) + "</style>\n</head>\n<body>\n<main>\n<header>\n<h1>" +
        title + "</h1>\n";
    for (const std::string& line : report.summary) out += element("p", escape_markup(line));
    out += tiles(report.key_figures) + "</header>\n" + block(report.warnings);
    for (const Section& section : report.sections) {
        out += "<section>\n";
        // The first section may follow the header without a heading of its own.
        if (!section.title.empty()) out += element("h2", escape_markup(section.title));
        out += blocks(section.blocks) + "</section>\n";
    }
    if (!report.footer.empty()) out += element("footer", escape_markup(report.footer));
    return out + "</main>\n</body>\n</html>\n";
}

Result<void> write_html(const std::filesystem::path& path, const HtmlReport& report) {
    return write_file(path, html(report));
}

}  // namespace myo::report
