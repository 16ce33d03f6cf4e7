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

/// A report as a value; html() turns it into one self-contained page: no script, no network, prints well.
///
///     HtmlReport report{.title = "Silicone beam", .summary = {"Calibrated on two trials."}};
///     report.sections.push_back({"Fit", {Paragraph{"..."}, Figure{svg(chart), "Tip marker."}, table}});
///     write_html(out / "report.html", report);

/// Plain text; markup in it is shown, not obeyed. A blank line starts a new paragraph.
struct Paragraph {
    std::string text = {};
};

/// Unnumbered list.
struct BulletList {
    std::vector<std::string> items = {};
};

struct Column {
    std::string title = {};
    std::string unit = {};  // shown under the title; empty for none
    int digits = 4;         // significant digits of the column's largest number
};

/// Text or a number. A number that is not finite shows as a dash.
struct Cell {
    std::variant<std::string, double> content;
    Cell(std::string text) : content(std::move(text)) {}
    Cell(const char* text) : content(std::string(text)) {}
    template <class Number>
    requires(std::floating_point<Number> || std::integral<Number>) Cell(Number value)
        : content(static_cast<double>(value)) {}
};

/// Columns whose cells are all numbers are set in figures of equal width, aligned at the point. Rows shorter than the
/// header are filled with empty cells.
struct Table {
    std::string caption = {};
    std::vector<Column> columns = {};
    std::vector<std::vector<Cell>> rows = {};
};

/// An SVG document (from chart.hpp) with a caption.
struct Figure {
    std::string svg = {};
    std::string caption = {};
};

struct WarningBox {
    std::vector<std::string> lines = {};  // none = no box
};

/// Monospaced text as it is.
struct Preformatted {
    std::string text = {};
};

/// Machine-readable copy inside the page: <script type="application/json" id="...">, invisible.
struct EmbeddedJson {
    std::string id = {};
    Json value;
};

struct Block;

/// Closed until clicked; printed open by browsers that can.
struct Details {
    std::string summary = {};
    std::vector<Block> blocks = {};
};

struct Block {
    std::variant<Paragraph, BulletList, Table, Figure, WarningBox, Preformatted, EmbeddedJson, Details> content;
    template <class Kind>
    requires(!std::same_as<std::remove_cvref_t<Kind>, Block>) Block(Kind&& kind) : content(std::forward<Kind>(kind)) {}
};

struct Section {
    std::string title = {};
    std::vector<Block> blocks = {};
};

/// A number worth a tile at the top.
struct KeyFigure {
    std::string label = {};
    std::string value = {};  // "2.61 × 10⁵"
    std::string unit = {};
    std::string note = {};  // "± 0.02", "was 3.1"
};

struct HtmlReport {
    std::string title = {};
    std::vector<std::string> summary = {};  // lines below the title
    std::vector<KeyFigure> key_figures = {};
    WarningBox warnings = {};
    std::vector<Section> sections = {};
    std::string footer = {};  // versions, options, when
};

/// The page. Well-formed as XML as well; text is escaped, JSON cannot end its script element.
std::string html(const HtmlReport& report);

/// Writes the page at once (temporary name, then renamed).
Result<void> write_html(const std::filesystem::path& path, const HtmlReport& report);

}  // namespace myo::report
