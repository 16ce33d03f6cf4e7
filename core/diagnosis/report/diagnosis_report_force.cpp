#include <cassert>
#include <cmath>

#include "base/markup.hpp"
#include "chart/svg.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"

namespace myo::diagnosis {
namespace {

/// Correlation with two digits; a dash if it is not known.
std::string correlation_words(double r) { return std::isfinite(r) ? fixed_decimals(r, 2) : "–"; }

/// What a force that follows a quantity resembles, for one of the correlates of course_correlates().
std::string course_words(const statistics::Correlate& c) {
    if (c.name == "position")
        return c.correlation < 0.0 ? "it pulls back, like a spring"
                                   : "it pushes on, like a spring that is softer than declared";
    if (c.name == "velocity" || c.name == "|v| v")
        return c.correlation < 0.0 ? "it brakes, like a drag"
                                   : "it drives the motion: there is less damping than declared";
    if (c.name == "acceleration")
        return c.correlation < 0.0 ? "it acts like a mass that is not in the model"
                                   : "it acts as if there were less mass";
    if (c.name == "strain rate") return "it goes with the rate of strain, like damping in the material";
    if (c.name == "time") return "it drifts with time";
    return "it goes with the " + c.name;
}

/// Place, size and course of a mode in sentences. A correlate is named only if it is strong and not chance.
std::string mode_words(const ForceMode& mode) {
    std::string words = "It acts mainly " + mode.where + ", with up to " + readable_number(mode.peak_N(), 2) + " N.";
    if (mode.steady > diagnosis_report_policy.min_steady)
        return words + " It is nearly constant: a load, a stress or a shape that the model does not have.";
    if (mode.correlates.empty()) return words;
    const statistics::Correlate& first = mode.correlates.front();
    if (std::abs(first.correlation) < diagnosis_report_policy.min_correlation ||
        first.p > diagnosis_report_policy.max_p)
        return words + " Its course follows none of the tested quantities.";
    return words + " Its course follows the " + first.name + " most (correlation " +
           correlation_words(first.correlation) + "): " + course_words(first) + ".";
}

/// Chart (SVG) of the amplitudes of all modes [N] over time.
std::string chart_of(const MissingForce& force) {
    chart::Chart chart{"", {.label = "time", .unit = "s"}, {}};
    chart::Panel panel{{.label = "force", .unit = "N", .include_zero = true}, {}, 200.0};
    for (std::size_t k = 0; k < force.modes.size(); ++k)
        panel.series.push_back({std::to_string(k + 1) + ": " + force.modes[k].where,
                                {force.time_s.begin(), force.time_s.end()},
                                {force.modes[k].amplitude_N.begin(), force.modes[k].amplitude_N.end()},
                                chart::SeriesStyle::line,
                                static_cast<int>(k)});
    panel.horizontal.push_back({0.0, ""});
    chart.panels.push_back(std::move(panel));
    return chart::svg(chart);
}

/// Modes with place and size, in the order of their shares.
report::Table mode_table(const MissingForce& force) {
    report::Table table{"",
                        {{"Mode"},
                         {"Where, and in which direction"},
                         {"Share", "%", 3},
                         {"Middle, from clamp to end", "%", 3},
                         {"rms", "N", 3},
                         {"Largest", "N", 3},
                         {"Steady part", "%", 3}},
                        {}};
    for (std::size_t k = 0; k < force.modes.size(); ++k) {
        const ForceMode& mode = force.modes[k];
        table.rows.push_back({k + 1, mode.where, 100.0 * mode.share, 100.0 * mode.place, mode.rms_N(), mode.peak_N(),
                              100.0 * mode.steady});
    }
    return table;
}

/// Strongest correlates of each mode.
report::Table correlate_table(const MissingForce& force) {
    report::Table table{"Correlation of the courses",
                        {{"Mode"}, {"Follows"}, {"Correlation"}, {"Independent samples", "", 3}, {"p"}},
                        {}};
    for (std::size_t k = 0; k < force.modes.size(); ++k) {
        const std::vector<statistics::Correlate>& list = force.modes[k].correlates;
        for (std::size_t i = 0; i < std::min(diagnosis_report_policy.correlates, list.size()); ++i)
            table.rows.push_back({k + 1, list[i].name, correlation_words(list[i].correlation),
                                  std::round(list[i].effective_samples), p_words(list[i].p)});
    }
    return table;
}

}  // namespace

report::Section force_section(const Diagnosis& d) {
    assert(d.missing_force);
    const MissingForce& force = *d.missing_force;
    if (!force.failure.empty())
        return {"The missing force", {report::Paragraph{"No force could be inferred: " + force.failure + "."}}};
    std::string words = "Below is the smallest smooth force that would have to act in " + force.trial +
                        ", in addition to the best attempt, for the model to move as it was measured. With it "
                        "the residual falls from " +
                        readable_number(force.before_over_noise, 3) + " to " +
                        readable_number(force.after_over_noise, 3) + " times the noise: it takes away " +
                        readable_number(100.0 * force.removed(), 3) + " % of its square.";
    if (!force.modes.empty()) words += "\n\n" + mode_words(force.modes.front());
    return {
        "The missing force",
        {report::Paragraph{words},
         report::Figure{chart_of(force),
                        "Size of the missing force over time: sum of the lengths of its nodal forces, with the sign of "
                        "its direction."},
         mode_table(force), correlate_table(force),
         report::Paragraph{"Position, velocity and acceleration are those of the body along the force. Where several "
                           "forces would do, the smallest is shown: it tends to sit where the body yields most."}}};
}

}  // namespace myo::diagnosis
