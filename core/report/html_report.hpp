#pragma once

#include <concepts>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/result.hpp"
#include "report/json.hpp"

namespace myo::report {

// The page is built from typed blocks instead of HTML text, so that escaping and number formats are decided in one
// place.

/// A report as a value; html() converts it to one self-contained page without scripts or network access, also for
/// print.
///
///     HtmlReport report{.title = "Silicone beam", .summary = {"Calibrated on two trials."}};
///     report.sections.push_back({"Fit", {Paragraph{"..."}, Figure{chart::svg(chart), "Tip marker."}, table}});
///     write_html(out / "report.html", report);

/// Plain text; markup in it is escaped. A blank line starts a new paragraph.
struct Paragraph {
    std::string text = {};
};

/// Unordered list.
struct BulletList {
    std::vector<std::string> items = {};
};

/// Column of a table.
struct Column {
    std::string title = {};
    std::string unit = {};  // shown below the title; may be empty
    int digits = 4;         // significant digits of the largest number in the column
};

/// Text or a number. A number that is not finite is shown as a dash.
struct Cell {
    std::variant<std::string, double> content;
    Cell(std::string text) : content(std::move(text)) {}
    Cell(const char* text) : content(std::string(text)) {}
    template <class Number>
    requires(std::floating_point<Number> || std::integral<Number>) Cell(Number value)
        : content(static_cast<double>(value)) {}
};

/// Table. Columns of numbers only use figures of equal width and align the decimal point. Rows shorter than the header
/// are filled with empty cells.
struct Table {
    std::string caption = {};
    std::vector<Column> columns = {};
    std::vector<std::vector<Cell>> rows = {};
};

/// SVG document (from chart.hpp) with a caption.
struct Figure {
    std::string svg = {};
    std::string caption = {};
};

/// Highlighted warnings.
struct WarningBox {
    std::vector<std::string> lines = {};  // empty: no box
};

/// Monospaced text without formatting.
struct Preformatted {
    std::string text = {};
};

/// Invisible machine-readable data in the page: <script type="application/json" id="...">.
struct EmbeddedJson {
    std::string id = {};  // id attribute, unique in the page
    Json value;
};

struct Block;

/// Collapsed content. Browsers that support it print it expanded.
struct Details {
    std::string summary = {};
    std::vector<Block> blocks;  // an initialiser would need the complete type
};

/// Any content of a section. Converts implicitly from each kind.
struct Block {
    std::variant<Paragraph, BulletList, Table, Figure, WarningBox, Preformatted, EmbeddedJson, Details> content;
    template <class Kind>
    requires(!std::same_as<std::remove_cvref_t<Kind>, Block>) Block(Kind&& kind) : content(std::forward<Kind>(kind)) {}
};

/// Part of a report with a heading.
struct Section {
    std::string title = {};
    std::vector<Block> blocks = {};
};

/// A number shown as a tile at the top of the page.
struct KeyFigure {
    std::string label = {};
    std::string value = {};  // "2.61 × 10⁵"
    std::string unit = {};
    std::string note = {};  // "± 0.02", "was 3.1"
};

/// Content of a report page.
struct HtmlReport {
    std::string title = {};
    std::vector<std::string> summary = {};  // lines below the title
    std::vector<KeyFigure> key_figures = {};
    WarningBox warnings = {};
    std::vector<Section> sections = {};
    std::string footer = {};  // e.g. versions, options, time
};

/// The HTML page. It is also well-formed XML; text is escaped, and embedded JSON cannot end its script element.
std::string html(const HtmlReport& report);

/// Writes the page atomically (temporary file, then rename).
/// Errors: those of writing the file.
Result<void> write_html(const std::filesystem::path& path, const HtmlReport& report);

}  // namespace myo::report
