#include "reproduce/reproduction.hpp"

#include "base/files.hpp"

namespace myo::reproduce {
namespace {

/// File name of a figure, see ReproductionFigure.
std::string figure_name(const ReproductionCase& one, const ReproductionFigure& figure) {
    return one.id + (figure.ending.empty() ? "" : "_" + figure.ending) + ".svg";
}

}  // namespace

report::Json table_json(const report::Table& table) {
    report::Json rows = report::Json::array();
    for (const std::vector<report::Cell>& cells : table.rows) {
        report::Json row = report::Json::object();
        for (std::size_t i = 0; i < cells.size() && i < table.columns.size(); ++i) {
            const report::Column& column = table.columns[i];
            // Keys carry the unit, as everywhere in files.
            const std::string key = column.unit.empty() ? column.title : column.title + " [" + column.unit + "]";
            if (const auto* text = std::get_if<std::string>(&cells[i].content))
                row[key] = *text;
            else
                row[key] = report::json_number(std::get<double>(cells[i].content));
        }
        rows.push_back(row);
    }
    return rows;
}

report::HtmlReport reproduction_report(const ReproductionCase& one, const Reproduction& result) {
    report::HtmlReport report;
    report.title = result.title;
    report.summary = {one.summary};
    report.warnings.lines = result.warnings;
    report::Section findings{"What came out", {report::BulletList{result.findings}}};
    for (const ReproductionFigure& figure : result.figures) findings.blocks.emplace_back(figure.figure);
    report.sections.push_back(findings);
    report::Section numbers{"Numbers", {}};
    for (const report::Table& table : result.tables) numbers.blocks.emplace_back(table);
    numbers.blocks.emplace_back(report::EmbeddedJson{one.id, result.values});
    report.sections.push_back(numbers);
    report.footer = "myoloop reproduce " + one.id +
                    " · the paper: Dubied, Michelis, Spielberg, Katzschmann, Sim-to-Real for Soft Robots using "
                    "Differentiable FEM, RA-L 2022";
    return report;
}

std::vector<std::filesystem::path> reproduction_files(const std::filesystem::path& folder,
                                                      const ReproductionCase& one) {
    std::vector<std::filesystem::path> files{folder / (one.id + ".json"), folder / "report.html"};
    std::error_code missing;
    // Figures of an earlier version may have other endings; all of this case are replaced.
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(one.id) && name.ends_with(".svg")) files.push_back(entry.path());
    }
    return files;
}

Result<void> write_reproduction(const std::filesystem::path& folder, const ReproductionCase& one,
                                const Reproduction& result) {
    report::Json json = {{"schema", "reproduce/1"}, {"case", one.id}, {"summary", one.summary}};
    json["findings"] = result.findings;
    json["warnings"] = result.warnings;
    // Values stand at the top level beneath the fixed keys.
    for (const auto& [key, value] : result.values.items()) json[key] = value;
    for (const report::Table& table : result.tables)
        json["tables"].push_back({{"caption", table.caption}, {"rows", table_json(table)}});
    if (const Result<void> written = report::write_json(folder / (one.id + ".json"), json); !written) return written;
    for (const ReproductionFigure& figure : result.figures)
        if (const Result<void> written = write_file(folder / figure_name(one, figure), figure.figure.svg); !written)
            return written;
    return report::write_html(folder / "report.html", reproduction_report(one, result));
}

std::string missing_data(const ReproduceSettings& settings, const std::string& folder) {
    const std::filesystem::path place = settings.data / "data/mocap" / folder;
    return "the measured files are not in " + place.string() +
           ": fetch the motion-capture recordings of the public repository srl-ethz/diffPD_sim2real (" + folder +
           ", .c3d or .csv) and put them there, or name the folder above data/mocap in MYOLOOP_DATA; without them only "
           "simulated and published numbers are shown";
}

}  // namespace myo::reproduce
