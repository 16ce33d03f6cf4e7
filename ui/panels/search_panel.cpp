#include "panels/search_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

namespace {

/// Plot of a quantity over the evaluations. The line shows the course, the dots the single evaluations.
plot::Plot evaluations_plot(const char* id, const chart::Axis& axis, const Eigen::VectorXd& values,
                            const ImVec4& color) {
    const Eigen::VectorXd number = Eigen::VectorXd::LinSpaced(values.size(), 1.0, static_cast<double>(values.size()));
    plot::Plot plot;
    plot.id = id;
    plot.x = {.label = "evaluation"};
    plot.panel.y = axis;
    plot.panel.series.push_back(plot::plot_series("value", number, values, color));
    plot.panel.series.back().style = chart::SeriesStyle::line_and_dots;
    return plot;
}

/// A quantity of every evaluation.
template <class Quantity>
Eigen::VectorXd over_evaluations(const commands::SearchView& search, const Quantity& quantity) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(search.log.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = quantity(search.log[static_cast<std::size_t>(i)]);
    return values;
}

/// Loss and gradient fall by orders of magnitude, so their axes are logarithmic. A failed evaluation leaves a gap.
chart::Axis logarithmic_axis(const char* label, const commands::SearchView& search) {
    return {.label = label, .unit = search.loss_unit, .logarithmic = true};
}

}  // namespace

std::string SearchPanel::title() const { return std::string(platform::icon::line_chart) + "  Search"; }

/// Table of the searched values on the left.
void SearchPanel::draw_values(PanelContext& context, bool starts) {
    const commands::SearchView& search = *context.state.search;
    const platform::Theme& theme = context.theme;
    const int runs = static_cast<int>(search.log.size());
    ImGui::PushFont(theme.strong);
    ImGui::TextUnformatted((std::to_string(runs) + (runs == 1 ? " evaluation" : " evaluations")).c_str());
    ImGui::PopFont();
    context.items.mark("search/evaluations");
    if (!search.target.empty()) muted_text(theme, "Follows the " + search.target);
    context.items.mark("search/target");
    std::vector<Heading> headings{{"Value", "Unknown that the search varies"},
                                  {"Best so far", "Of the evaluation with the least loss", true}};
    // Levels of signals are numbers without unit.
    const bool units = std::any_of(search.parameters.begin(), search.parameters.end(),
                                   [](const commands::ParameterRow& row) { return !row.unit.empty(); });
    if (units) headings.push_back({"Unit", ""});
    // The start value stands before the best one.
    if (starts) headings.insert(headings.begin() + 1, {"Start", "Initial value of the search", true});
    if (!ImGui::BeginTable("values", static_cast<int>(headings.size()),
                           ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX | ImGuiTableFlags_ScrollY))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const Heading& heading : headings)
        if (heading.number) number_column(theme, heading);
    if (units) ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("kg/m3").x);
    heading_row(theme, headings);
    for (const commands::ParameterRow& row : search.parameters) {
        ImGui::TableNextRow();
        text_cell(theme, row.name, theme.text);
        if (starts) number_cell(theme, plot::plain_label(row.start, 4));
        number_cell(theme, plot::plain_label(row.value, 4));
        if (units) text_cell(theme, row.unit, theme.muted);
    }
    ImGui::EndTable();
}

void SearchPanel::draw_curve(PanelContext& context, const plot::Plot& plot, const std::string& tip, const ImVec2& size,
                             plot::PlotState& plot_state) {
    const plot::PlotResult drawn = plot::draw_plot(plot, size, context.theme, context.items, evaluations_, plot_state,
                                                   hidden_);
    // Above the drawing area only; inside it the crosshair shows the values.
    if (ImGui::GetIO().MousePos.y < drawn.area.pixels.lowest.y) tooltip(context.theme, tip);
    const ImVec2 corner = ImGui::GetItemRectMin();
    context.items.add(plot.id + "/title", {corner, {ImGui::GetItemRectMax().x, drawn.area.pixels.lowest.y}});
}

void SearchPanel::draw_curves(PanelContext& context, int curves) {
    const platform::Theme& theme = context.theme;
    const commands::SearchView& search = *context.state.search;
    const float gap = 4.0f * theme.scale;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size{std::floor((room.x - gap * static_cast<float>(curves - 1)) / static_cast<float>(curves)), room.y};
    // Only a calibration has a loss without unit.
    const bool calibrates = search.loss_unit.empty();
    const std::string what =
        calibrates
            ? "the loss |r|² / 2, r = (simulated − measured) / noise"
            : "the loss [mm²], the markers' mean square distance plus a small penalty on the rate of the signals";
    const auto rms = over_evaluations(search, [](const auto& point) { return 1e3 * point.rms_m; });
    draw_curve(
        context, evaluations_plot("search/rms", {.label = "rms error", .unit = "mm"}, rms, theme.simulated),
        "Root mean square distance of simulated and measured coordinates [mm], over the evaluations of the search",
        size, error_);
    if (curves < 2) return;
    ImGui::SameLine(0.0f, gap);
    const auto loss = over_evaluations(search, [](const auto& point) { return point.loss; });
    draw_curve(context, evaluations_plot("search/loss", logarithmic_axis("loss", search), loss, theme.accent),
               "Quantity that the search minimises: " + what + ".", size, loss_);
    if (curves < 3) return;
    ImGui::SameLine(0.0f, gap);
    draw_gradient(context, what, size);
}

void SearchPanel::draw_gradient(PanelContext& context, const std::string& what, const ImVec2& size) {
    const commands::SearchView& search = *context.state.search;
    const auto norm = over_evaluations(search, [](const auto& point) { return point.gradient_norm; });
    const char* const which = search.loss_unit.empty() ? ", each parameter in its scale"
                                                       : ", without the part that the bounds block";
    draw_curve(context,
               evaluations_plot("search/gradient", logarithmic_axis("|gradient|", search), norm, context.theme.force),
               "Length of the gradient of " + what + which + ". It is 0 at the optimum.", size, gradient_);
}

/// Table of the values on the left, up to three curves on the right: error, loss and gradient, as many as there is room
/// for.
void SearchPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (!state.search || state.search->log.empty()) {
        muted_text(theme, state.searching()
                              ? "The first evaluation is running."
                              : "Calibrate and Optimise show their error and values over the evaluations here.");
        return;
    }
    const ImVec2 space = ImGui::GetContentRegionAvail();
    // In a narrow strip the start values and the later curves are left out.
    const float s = theme.scale;
    // Wide enough for the column of start values.
    const bool wide = space.x > 620.0f * s;
    const float values_width = std::floor(
        std::max(wide ? 280.0f * s : 220.0f * s, std::min(0.3f * space.x, 380.0f * s)));
    // A curve below 150 pixels (at scale 1) is not readable.
    const int curves = std::clamp(static_cast<int>((space.x - values_width) / (150.0f * s)), 1, 3);
    ImGui::BeginChild("values", {values_width, 0.0f});
    draw_values(context, wide);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("curves", {0.0f, 0.0f}, false, ImGuiWindowFlags_NoScrollbar);
    draw_curves(context, curves);
    ImGui::EndChild();
}

}  // namespace myo::ui::panels
