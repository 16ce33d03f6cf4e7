#include <algorithm>
#include <cmath>
#include <limits>

#include "base/markup.hpp"
#include "chart/svg.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/periodogram.hpp"
#include "statistics/residual_patterns.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The entries as a list, for charts.
std::vector<double> numbers(const VectorXd& values) { return {values.begin(), values.end()}; }

/// Fit with its name and its colour, which is the same on the whole page.
struct Compared {
    std::string name;
    const VectorXd* residual;
    int colour;
};
/// Residuals of the declared fit and, if there is another one, of the verdict's fit.
std::vector<Compared> compared(const Diagnosis& d) {
    std::vector<Compared> list{{"declared model", &d.declared.fit.residual, before_colour}};
    if (has_two_fits(d)) list.push_back({after_words(d), &d.augmented.fit.residual, after_colour});
    return list;
}

/// Chart (SVG) of the mean spectrum of the residual in a trial; white noise of the declared size is at 1.
std::string spectrum(const Diagnosis& d, int trial) {
    chart::Chart chart{"", {.label = "frequency", .unit = "Hz"}, {}};
    chart::Panel panel{{.label = "power over that of white noise", .logarithmic = true}, {}, 190.0};
    for (const Compared& fit : compared(d)) {
        const statistics::Spectrum found = statistics::mean_spectrum(*fit.residual, d.data.layout, trial);
        panel.series.push_back(
            {fit.name, numbers(found.frequency_Hz), numbers(found.power), chart::SeriesStyle::line, fit.colour});
    }
    panel.horizontal.push_back({1.0, "noise"});
    chart.panels.push_back(std::move(panel));
    return chart::svg(chart);
}

/// Mean sampling interval of a trial [s]; 0 if it has no two samples.
double interval_s(const statistics::ResidualLayout& layout, int trial) {
    for (const statistics::ResidualSeries& series : layout.series) {
        if (series.trial != trial || series.size() < 2) continue;
        const auto first = static_cast<std::size_t>(series.begin), last = static_cast<std::size_t>(series.end - 1);
        return (layout.time_s[last] - layout.time_s[first]) / std::max(1, layout.sample[last] - layout.sample[first]);
    }
    return 0.0;
}

/// Chart (SVG) of the autocorrelation of the residual in a trial, with the 95 % limits of white noise.
std::string memory(const Diagnosis& d, int trial) {
    chart::Chart chart{"", {.label = "lag", .unit = "ms"}, {}};
    chart::Panel panel{{.label = "autocorrelation", .include_zero = true}, {}, 170.0};
    double pairs = 0.0;
    for (const Compared& fit : compared(d)) {
        const statistics::Autocovariance found = statistics::pooled_autocovariance(*fit.residual, d.data.layout,
                                                                                   diagnosis_report_policy.lags, trial);
        const VectorXd correlation = found.correlation();
        const VectorXd at = 1e3 * interval_s(d.data.layout, trial) *
                            VectorXd::LinSpaced(correlation.size(), 0.0, static_cast<double>(correlation.size() - 1));
        panel.series.push_back(
            {fit.name, numbers(at), numbers(correlation), chart::SeriesStyle::line_and_dots, fit.colour});
        if (found.pairs.size() > 0) pairs = found.pairs(0);
    }
    // Two standard deviations of the estimate from that many pairs of white noise.
    if (pairs > 0.0) panel.horizontal = {{2.0 / std::sqrt(pairs), "noise"}, {-2.0 / std::sqrt(pairs), ""}};
    chart.panels.push_back(std::move(panel));
    return chart::svg(chart);
}

/// Rms of each marker over the fit trials [noise levels].
std::vector<double> marker_rms(const setup::Setup& setup, const Diagnosis& d, const VectorXd& residual) {
    const std::size_t count = setup.marker_names.size();
    std::vector<double> squares(count, 0.0), samples(count, 0.0), rms;
    for (const statistics::ResidualSeries& series : d.data.layout.series) {
        const auto m = static_cast<std::size_t>(series.marker);
        squares[m] += residual.segment(series.begin, series.size()).squaredNorm();
        samples[m] += static_cast<double>(series.size());
    }
    for (std::size_t m = 0; m < count; ++m)
        rms.push_back(samples[m] > 0.0 ? std::sqrt(squares[m] / samples[m]) : std::numeric_limits<double>::quiet_NaN());
    return rms;
}

/// Rms at each marker over all fit trials: bars, or a table if there are many markers.
report::Block over_the_body(const setup::Setup& setup, const Diagnosis& d) {
    if (setup.marker_names.size() <= diagnosis_report_policy.bars) {
        chart::BarChart chart{"", setup.marker_names, {.label = "rms over the fit trials", .unit = "× noise"}, {}};
        chart.height_px = 220.0;
        for (const Compared& fit : compared(d)) chart.groups.push_back({fit.name, marker_rms(setup, d, *fit.residual)});
        return report::Figure{chart::svg(chart_of(chart)), "Over the body: residual at each marker."};
    }
    report::Table table{"Over the body: rms over the fit trials in units of the noise.", {{"Marker"}}, {}};
    for (const std::string& name : setup.marker_names) table.rows.push_back({name});
    for (const Compared& fit : compared(d)) {
        table.columns.push_back({fit.name, "× noise", 3});
        const std::vector<double> rms = marker_rms(setup, d, *fit.residual);
        for (std::size_t m = 0; m < rms.size(); ++m) table.rows[m].emplace_back(rms[m]);
    }
    return table;
}

/// First pattern of the declared model's residual in a trial, and the share of each fit's first pattern in its
/// residual.
std::vector<report::Block> patterns(const setup::Setup& setup, const Diagnosis& d, int trial) {
    std::string words;
    std::vector<report::Block> blocks;
    for (const Compared& fit : compared(d))
        for (const statistics::ResidualPatterns& found :
             statistics::residual_patterns(*fit.residual, d.data.layout, 1)) {
            if (found.trial != trial || found.modes.empty()) continue;
            const statistics::ResidualMode& mode = found.modes.front();
            words += (words.empty() ? "One pattern over the markers carries " : ", ") +
                     readable_number(100.0 * mode.share, 3) + " % of the residual of " +
                     setup.trials[static_cast<std::size_t>(trial)].name + " (" + fit.name + ")";
            // The table is that of the declared model; of the other fit only the share is stated.
            if (fit.colour != before_colour) continue;
            report::Table table{"First pattern of the declared model’s residual (root mean square 1)",
                                {{"Marker"}, {"x", "", 3}, {"y", "", 3}, {"z", "", 3}},
                                {}};
            for (std::size_t k = 0; k < found.markers.size(); ++k) {
                std::vector<report::Cell> row{setup.marker_names[static_cast<std::size_t>(found.markers[k])]};
                for (Index axis = 0; axis < 3; ++axis)
                    row.emplace_back(std::round(100.0 * mode.pattern(axis, static_cast<Index>(k))) / 100.0);
                table.rows.push_back(std::move(row));
            }
            blocks.push_back(report::Details{"First pattern over the markers", {table}});
        }
    if (!words.empty()) blocks.insert(blocks.begin(), report::Paragraph{words + "."});
    return blocks;
}

}  // namespace

report::Section residual_section(const setup::Setup& setup, const Diagnosis& d) {
    if (!d.declared.usable() || d.data.layout.size() == 0)
        return {"Residual", {report::Paragraph{"There is no residual."}}};
    const std::size_t worst = worst_trial(d.data, d.declared.fit.residual);
    const int trial = static_cast<int>(worst);
    const std::string& name = setup.trials[worst].name;
    report::Section section{
        "Residual",
        {over_the_body(setup, d),
         report::Figure{spectrum(d, trial), "Spectrum of the residual in " + name +
                                                ", mean over markers and axes. White noise would be at 1 everywhere."},
         report::Figure{memory(d, trial), "Autocorrelation of the residual in " + name +
                                              ". White noise would stay between the two lines."}}};
    for (report::Block& block : patterns(setup, d, trial)) section.blocks.push_back(std::move(block));
    return section;
}

}  // namespace myo::diagnosis
