#include "panels/curve_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <limits>

#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// New rows of a curve.
struct CurveRowPolicy {
    double rise_s = 0.5;      // in which a new curve reaches its value
    double spacing_s = 0.1;   // of a row behind a jump or behind the only row
    double longest_s = 3600;  // largest time of a row
    double apart_s = 1e-6;    // least distance of a row from a jump
};
constexpr CurveRowPolicy curve_row_policy;

/// Times that a row may have: between those of its neighbours, equal ones included. Two equal times are a jump, so
/// that a row next to one keeps off it.
commands::Limits time_limits(const fibre::Signal& curve, std::size_t row) {
    const std::vector<double>& t = curve.times_s;
    const double apart = curve_row_policy.apart_s;
    commands::Limits limits{-curve_row_policy.longest_s, curve_row_policy.longest_s};
    if (row > 0) limits.lowest = t[row - 1] + (row > 1 && t[row - 2] == t[row - 1] ? apart : 0.0);
    if (row + 1 < t.size())
        limits.highest = t[row + 1] - (row + 2 < t.size() && t[row + 2] == t[row + 1] ? apart : 0.0);
    return limits;
}

/// The curve with a row behind the last: as far behind it as that is behind the one before.
fibre::Signal with_row(fibre::Signal curve) {
    const std::size_t count = curve.times_s.size();
    const double last = count > 1 ? curve.times_s[count - 1] - curve.times_s[count - 2] : 0.0;
    curve.times_s.push_back(curve.times_s.back() + (last > 0.0 ? last : curve_row_policy.spacing_s));
    curve.values.push_back(curve.values.back());
    return curve;
}

}  // namespace

std::optional<CurveEdit> curve_rows(PanelContext& context, const NumberField& value, NumberEdits& edits,
                                    const fibre::Signal& curve, const std::string& subject) {
    std::optional<CurveEdit> edit;
    const float button = ImGui::GetFrameHeight(), spacing = ImGui::GetStyle().ItemSpacing.x;
    for (std::size_t row = 0; row < curve.times_s.size(); ++row) {
        const std::string item = value.name + "/" + std::to_string(row);
        const float width = (ImGui::GetContentRegionAvail().x - button - 2.0f * spacing) / 2.0f;
        // Time and value of the row, and the button that removes it, share a line.
        NumberField time{"Time",
                         item + "/time",
                         commands::Dimension::time,
                         "s",
                         "Time of the trial [s]; two equal times are a jump.",
                         time_limits(curve, row),
                         0.005};
        NumberField amount = value;
        amount.name = item + "/value";
        // Each row edits a copy of the curve, so that an edit changes one row only.
        CurveEdit changed{curve};
        ImGui::SetNextItemWidth(width);
        bool any = number_field(context, time, edits, changed.curve.times_s[row], changed.goes_on, subject);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(width);
        any = number_field(context, amount, edits, changed.curve.values[row], changed.goes_on, subject) || any;
        ImGui::SameLine();
        // A curve has at least two rows.
        ImGui::BeginDisabled(curve.times_s.size() < 3);
        if (ImGui::Button((std::string(platform::icon::remove) + "##" + item).c_str(), {button, 0.0f})) {
            const auto at = static_cast<std::ptrdiff_t>(row);
            changed.curve.times_s.erase(changed.curve.times_s.begin() + at);
            changed.curve.values.erase(changed.curve.values.begin() + at);
            any = true;
        }
        ImGui::EndDisabled();
        context.items.mark(item + "/remove");
        if (any) edit = changed;
    }
    if (ImGui::Button(("Add a row##" + value.name).c_str(), {-1.0f, 0.0f})) edit = CurveEdit{with_row(curve), false};
    context.items.mark(value.name + "/add");
    tooltip(context.theme, "Linear between the rows, constant before the first and after the last.");
    return edit;
}

fibre::Signal new_curve(double value) { return {{0.0, curve_row_policy.rise_s}, {0.0, value}}; }

}  // namespace myo::ui::panels
