#include "backend/check_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "report/length.hpp"

namespace myo::backend {
namespace {

/// Task of the window in which a finding can be remedied. The residual of a declared model asks for a fit first.
std::string task_of(const check::Check* check, bool as_declared) {
    if (check == nullptr) return "run";
    return check->id == "residual" && as_declared ? "fit" : check->task;
}

/// Value with a prefix of suitable size and typographic powers: "320 kPa", "1070 kg/m³".
std::string number_text(double figure, std::string unit) {
    if (unit == "Pa")
        for (const auto& [size, larger] : {std::pair{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}})
            if (std::abs(figure) >= size) return format_number(figure / size, 3) + " " + larger;
    // Units of the core are ASCII ("kg/m3"); only a trailing power occurs in them.
    if (unit.ends_with("3")) unit.replace(unit.size() - 1, 1, "³");
    if (unit.ends_with("2")) unit.replace(unit.size() - 1, 1, "²");
    // Three digits would turn a four- to six-digit number, such as a density, into an exponent.
    const int digits = std::abs(figure) >= 1e3 && std::abs(figure) < 1e6 ? 6 : 3;
    return format_number(figure, digits) + (unit.empty() ? "" : " " + unit);
}

/// Lengths in a readable unit; the frequency error of the step in percent; other values with their unit.
std::string figure_text(const check::Finding& finding, double figure) {
    if (!std::isfinite(figure)) return {};
    if (finding.unit == "m" && std::abs(figure) < 1.0) return report::length_words(figure);
    if (finding.unit.empty() && finding.check == "step") return format_number(100.0 * figure, 2) + " %";
    return number_text(figure, finding.unit);
}

}  // namespace

ui::commands::CheckState shown_state(check::CheckLevel level) {
    if (level == check::CheckLevel::passed) return ui::commands::CheckState::green;
    return level == check::CheckLevel::doubtful ? ui::commands::CheckState::amber : ui::commands::CheckState::red;
}

ui::commands::CheckRows check_rows(const std::vector<check::Finding>& findings, bool as_declared) {
    ui::commands::CheckRows rows;
    for (const check::Finding& finding : findings) {
        const check::Check* const check = check::find_check(finding.check);
        rows.push_back({finding.check, check != nullptr ? check->question : finding.check, shown_state(finding.level),
                        finding.subject, figure_text(finding, finding.figure), figure_text(finding, finding.threshold),
                        finding.source, finding.sentence, finding.way_out, task_of(check, as_declared),
                        finding.warned});
    }
    // CheckState ascends from green to red.
    std::stable_sort(rows.begin(), rows.end(), [](const ui::commands::CheckRow& a, const ui::commands::CheckRow& b) {
        return a.state > b.state;
    });
    return rows;
}

}  // namespace myo::backend
