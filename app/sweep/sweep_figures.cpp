#include "sweep/sweep_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "sweep/readable_number.hpp"

namespace myo::sweep {
namespace {

/// Indices of the varied quantities that begin an axis and take several values.
std::vector<std::size_t> axes_of(const Sweep& sweep) {
    std::vector<std::size_t> axes;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k)
        if (!sweep.varied[k].together && sweep.varied[k].values.size() > 1) axes.push_back(k);
    return axes;
}

/// Whether all values are finite numbers, so that they can be an axis.
bool is_numeric(const Varied& varied) {
    return std::all_of(varied.values.begin(), varied.values.end(), [](const toml::TomlValue& value) {
        return value.kind == toml::TomlValue::Kind::number && std::isfinite(value.number);
    });
}

/// The axis along which curves run: numbers before names, seeds last, then the most values.
std::size_t axis_of_curves(const Sweep& sweep, const std::vector<std::size_t>& axes) {
    const auto rank = [&](std::size_t k) {
        const Varied& varied = sweep.varied[k];
        // Random starts are repetitions, not a quantity to plot against.
        const double kind = varied.name == "--seed" ? 0.0 : is_numeric(varied) ? 2.0 : 1.0;
        return std::pair{kind, varied.values.size()};
    };
    return *std::max_element(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
}

/// Name of an axis with the quantities that move along.
std::string axis_name(const Sweep& sweep, std::size_t axis) {
    std::vector<std::string> others;
    for (std::size_t k = axis + 1; k < sweep.varied.size() && sweep.varied[k].together; ++k)
        others.push_back(shown_quantity(sweep.varied[k]).name);
    const std::string name = shown_quantity(sweep.varied[axis]).name;
    return others.empty() ? name : name + " (with " + join(others) + ")";
}

/// A value in its shown unit: "320 kPa".
std::string shown_value(const Varied& varied, std::size_t index) {
    const ShownQuantity shown = shown_quantity(varied);
    const toml::TomlValue& value = varied.values[index];
    const std::string text = value.kind == toml::TomlValue::Kind::number ? format_number(shown.factor * value.number, 4)
                                                                         : value_words(varied, index);
    return shown.unit.empty() ? text : text + " " + shown.unit;
}

/// Name of the curve of a row: values of all axes but that of the curve.
std::string curve_name(const Sweep& sweep, const std::vector<std::size_t>& axes, std::size_t along,
                       const SweepRow& row) {
    std::vector<std::string> words;
    for (const std::size_t k : axes)
        if (k != along)
            words.push_back(shown_quantity(sweep.varied[k]).name + " " + shown_value(sweep.varied[k], row.choice[k]));
    return join(words);
}

/// Axis of numbers, or of categories in the order of the values.
chart::Axis x_axis(const Sweep& sweep, std::size_t along) {
    const Varied& varied = sweep.varied[along];
    chart::Axis axis{.label = axis_name(sweep, along)};
    if (is_numeric(varied)) {
        axis.unit = shown_quantity(varied).unit;
        axis.logarithmic = varied.logarithmic;
        return axis;
    }
    for (std::size_t i = 0; i < varied.values.size(); ++i) axis.categories.push_back(value_words(varied, i));
    return axis;
}

/// Curves of a column by their names, in the order of the rows.
std::vector<chart::Series> curves_of(const SweepTable& table, const std::vector<std::size_t>& axes, std::size_t along,
                                     const SweepColumn& column) {
    const Varied& varied = table.sweep.varied[along];
    const bool numeric = is_numeric(varied);
    const double x_factor = shown_quantity(varied).factor, factor = shown_quantity(column.name, column.unit).factor;
    std::vector<chart::Series> curves;
    std::map<std::string, std::size_t> places;
    for (const SweepRow& row : table.rows) {
        const std::string name = curve_name(table.sweep, axes, along, row);
        const auto [place, is_new] = places.emplace(name, curves.size());
        // A new combination of the other axes begins a curve with the next colour.
        if (is_new)
            curves.push_back({.name = name,
                              .style = numeric ? chart::SeriesStyle::line_and_dots : chart::SeriesStyle::dots,
                              .colour = static_cast<int>(curves.size())});
        chart::Series& curve = curves[place->second];
        const std::size_t index = row.choice[along];
        curve.x.push_back(numeric ? x_factor * varied.values[index].number : static_cast<double>(index));
        const CaseNumber* number = row.find(column.name);
        // NaN makes a gap: a case that failed must not be bridged by a line.
        curve.y.push_back(number != nullptr ? factor * number->value : std::nan(""));
        if (column.has_deviation)
            curve.half_width.push_back(
                number != nullptr && std::isfinite(number->deviation) ? factor * number->deviation : 0.0);
    }
    return curves;
}

}  // namespace

SweepFigures sweep_figures(const SweepTable& table, const SweepPolicy& policy) {
    const std::vector<std::size_t> axes = axes_of(table.sweep);
    if (axes.empty()) return {{}, "A single case needs no figure."};
    const std::size_t along = axis_of_curves(table.sweep, axes);
    const std::size_t curves = table.rows.size() / table.sweep.varied[along].values.size();
    if (curves > policy.most_curves)
        return {{},
                "The grid would take " + std::to_string(curves) + " curves in a figure, more than " +
                    std::to_string(policy.most_curves) + "; sweep.csv holds all numbers."};
    SweepFigures figures;
    for (const SweepColumn& column : table.columns) {
        if (!column.shown) continue;
        const ShownQuantity shown = shown_quantity(column.name, column.unit);
        chart::Chart chart{.title = shown.name, .x = x_axis(table.sweep, along)};
        chart.panels.push_back(
            {.y = {.label = shown.name, .unit = shown.unit}, .series = curves_of(table, axes, along, column)});
        figures.charts.push_back(std::move(chart));
    }
    return figures;
}

}  // namespace myo::sweep
