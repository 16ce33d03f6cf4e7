#include "reproduce/arm_static_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "chart/svg.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Appends one row per score to predictions_table(); places at the end of the record [mm], errors at both instants [%].
void add_scores(report::Table& table, const std::string& kind, const std::vector<Score>& early,
                const std::vector<Score>& late) {
    for (std::size_t i = 0; i < late.size(); ++i) {
        const Vector3d p = 1e3 * late[i].prediction.tip_m, m = 1e3 * late[i].measured_m;
        table.rows.push_back({kind, late[i].what, late[i].pressure_mbar, p(0), m(0), p(1), m(1), p(2), m(2),
                              100.0 * early[i].error(), 100.0 * late[i].error()});
    }
}

/// Relative increase of the displacement of a step trial after `until_s` [s], until it is vented: the largest mean of
/// 0.1 s, since the displacement falls again when the pressure is released.
double creep(const RobotTrial& trial, double until_s) {
    const double then = mean_between(trial, until_s - 0.1, until_s).col(0).norm();
    double most = then;
    for (double t = until_s; t < trial.time_s.tail(1)(0); t += 0.1)
        if (const double now = mean_between(trial, t - 0.1, t).col(0).norm(); now > most) most = now;
    return most / then - 1.0;
}

/// Share in percent, with its sign.
std::string percent(double share) { return format_number(100.0 * share, 3) + " %"; }

}  // namespace

double mean_error(const std::vector<Score>& scores, bool with_extrapolated) {
    double sum = 0.0;
    int count = 0;
    for (const Score& score : scores)
        if (with_extrapolated || !score.extrapolated) {
            sum += score.error();
            ++count;
        }
    return count > 0 ? sum / count : std::nan("");
}

double error_in_plane(const Score& score) {
    const Vector3d &p = score.prediction.tip_m, &m = score.measured_m;
    // Distance from the axis and height: the angle about the axis is left out.
    return std::hypot(std::hypot(p(0), p(1)) - std::hypot(m(0), m(1)), p(2) - m(2)) / m.norm();
}

double mean_error_in_plane(const std::vector<Score>& scores) {
    double sum = 0.0;
    int count = 0;
    for (const Score& score : scores)
        if (!score.extrapolated) {
            sum += error_in_plane(score);
            ++count;
        }
    return count > 0 ? sum / count : std::nan("");
}

report::Table errors_table(const std::vector<ArmVariant>& list, const Assessments& all) {
    report::Table table{
        "Mean error of the tip centre's displacement on pressures left out: |predicted - measured| / |measured|; the "
        "paper: 13.07 % by its own measure, 16-21 % as displacement",
        {{"model"},
         {"every second, 0.7 s", "%", 3},
         {"every second, end", "%", 3},
         {"inside, one out, 0.7 s", "%", 3},
         {"inside, one out, end", "%", 3},
         {"with the ends, 0.7 s", "%", 3},
         {"with the ends, end", "%", 3},
         {"markers, rms", "mm", 3},
         {"simulations a pose", "", 2}},
        {}};
    for (std::size_t v = 0; v < list.size(); ++v) {
        // Order of `both_instants`.
        const Assessment &early = *all[v][0], &late = *all[v][1];
        const double rms = std::accumulate(late.arm.marker_rms_m.begin(), late.arm.marker_rms_m.end(), 0.0) /
                           static_cast<double>(late.arm.marker_rms_m.size());
        table.rows.push_back({list[v].name, 100.0 * mean_error(early.every_second),
                              100.0 * mean_error(late.every_second), 100.0 * mean_error(early.left_one_out, false),
                              100.0 * mean_error(late.left_one_out, false), 100.0 * mean_error(early.left_one_out),
                              100.0 * mean_error(late.left_one_out), 1e3 * rms,
                              static_cast<double>(late.arm.simulations()) / static_cast<double>(late.arm.fits.size())});
    }
    return table;
}

report::Table fits_table(const std::vector<ArmVariant>& list, const Assessments& all) {
    report::Table table{"Poses at the end of the records: signals, and where they leave the tip centre",
                        {{"model"},
                         {"pressure", "mbar", 3},
                         {"muscle 1", "", 4},
                         {"muscle 2", "", 4},
                         {"measured x", "mm", 4},
                         {"y", "mm", 4},
                         {"z", "mm", 4},
                         {"off in the fitted plane", "%", 2}},
                        {}};
    for (std::size_t v = 0; v < list.size(); ++v) {
        const FittedArm& arm = all[v][1]->arm;
        for (std::size_t i = 0; i < arm.fits.size(); ++i) {
            const Vector3d u = arm.measured_m[i].col(0), model = arm.fits[i].pose.tracked_m();
            // The plane of the fit: x and z as published, else that of the bending, where the model bends towards -x.
            const Eigen::Vector2d plane(list[v].body.published ? u(0) : -std::hypot(u(0), u(1)), u(2)),
                off = plane - Eigen::Vector2d(model(0), model(2));
            // From signal to activation, see MuscleConfiguration.
            const auto activation = [&](std::size_t m) {
                if (m >= list[v].configuration.muscles.size()) return std::nan("");
                const inverse::SignalShare& share = list[v].configuration.muscles[m];
                return 1.0 + share.factor * (arm.fits[i].signals(static_cast<Index>(share.signal)) - 1.0);
            };
            table.rows.push_back({list[v].name, arm.pressures_mbar[i], activation(0), activation(1), 1e3 * u(0),
                                  1e3 * u(1), 1e3 * u(2), 100.0 * off.norm() / u.norm()});
        }
    }
    return table;
}

report::Table predictions_table(const Assessment& early, const Assessment& late) {
    report::Table table{early.arm.variant.name + ": predictions, at the end of the records and 0.7 s after the onset",
                        {{"left out"},
                         {"recording"},
                         {"pressure", "mbar", 3},
                         {"x", "mm", 4},
                         {"measured", "mm", 4},
                         {"y", "mm", 4},
                         {"measured", "mm", 4},
                         {"z", "mm", 4},
                         {"measured", "mm", 4},
                         {"error, 0.7 s", "%", 3},
                         {"error, end", "%", 3}},
                        {}};
    add_scores(table, "every second", early.every_second, late.every_second);
    add_scores(table, "this one", early.left_one_out, late.left_one_out);
    return table;
}

report::Table others_table(const Assessment& early, const Assessment& late, const std::vector<RobotTrial>& others,
                           double as_long_s) {
    report::Table table{early.arm.variant.name + ": recordings that are not of the map, at 0.7 s and at " +
                            format_number(as_long_s, 2) + " s, as long as the sweep was recorded",
                        {{"recording"},
                         {"pressure", "mbar", 3},
                         {"outside the map"},
                         {"way, 0.7 s", "mm", 4},
                         {"predicted", "mm", 4},
                         {"error, 0.7 s", "%", 3},
                         {"error, end", "%", 3},
                         {"in the plane of its own bending, 0.7 s", "%", 3},
                         {"end", "%", 3},
                         {"bends to", "deg", 3},
                         {"creeps on", "%", 2}},
                        {}};
    for (std::size_t i = 0; i < others.size(); ++i) {
        const Score &a = early.others[i], &b = late.others[i];
        // Ways are lengths of the displacement of the tip centre [mm].
        table.rows.push_back({a.what, a.pressure_mbar, a.extrapolated ? "yes" : "no", 1e3 * a.measured_m.norm(),
                              1e3 * a.prediction.tip_m.norm(), 100.0 * a.error(), 100.0 * b.error(),
                              100.0 * error_in_plane(a), 100.0 * error_in_plane(b),
                              bending_direction({a.measured_m}) * 180.0 / std::numbers::pi,
                              100.0 * creep(others[i], as_long_s)});
    }
    return table;
}

report::Json grid_json(const Assessment& early, const Assessment& late) {
    report::Json rows = report::Json::array();
    for (std::size_t k = 0; k < late.grid.size(); ++k) {
        const auto point = [](const ArmPrediction& p) {
            return report::Json{{"signals", std::vector<double>(p.signals.begin(), p.signals.end())},
                                {"x_m", report::json_number(p.tip_m(0))},
                                {"y_m", report::json_number(p.tip_m(1))},
                                {"z_m", report::json_number(p.tip_m(2))}};
        };
        rows.push_back({{"pressure_mbar", grid_first_mbar + grid_step_mbar * static_cast<double>(k)},
                        {"at_0.7_s", point(early.grid[k])},
                        {"at_end", point(late.grid[k])}});
    }
    return rows;
}

std::string map_figure(const std::vector<ArmVariant>& list, const Assessments& all) {
    chart::Chart chart{.title = "Activation of muscle 1 over pressure",
                       .x = {.label = "pressure", .unit = "mbar", .lowest = 0.0},
                       .panels = {}};
    chart::Panel panel{.y = {.label = "a"}, .series = {}, .height_px = 320.0};
    for (std::size_t v = 0; v <= chosen_variant; ++v) {
        const FittedArm& arm = all[v][1]->arm;
        std::vector<double> lengths, pressures;
        Eigen::MatrixXd signals(list[v].configuration.signals, static_cast<Index>(arm.fits.size()));
        chart::Series dots{.style = chart::SeriesStyle::dots, .colour = static_cast<int>(v)},
            curve{.name = list[v].name, .colour = static_cast<int>(v)};
        for (std::size_t i = 0; i < arm.fits.size(); ++i) {
            signals.col(static_cast<Index>(i)) = arm.fits[i].signals;
            lengths.push_back(arm.measured_m[i].col(0).norm());
            dots.x.push_back(arm.pressures_mbar[i]);
            dots.y.push_back(arm.fits[i].signals(0));
        }
        const PressureMap map = list[v].body.published ? polynomial_map(arm.pressures_mbar, signals)
                                                       : map_from_rest(arm.pressures_mbar, signals, lengths);
        // The published polynomial means nothing below the first pressure.
        for (double p = list[v].body.published ? arm.pressures_mbar.front() : 0.0; p <= arm.pressures_mbar.back();
             p += 5.0) {
            curve.x.push_back(p);
            curve.y.push_back(map.at(p)(0));
        }
        panel.series.push_back(curve);
        panel.series.push_back(dots);
    }
    chart.panels = {panel};
    return chart::svg(chart);
}

std::string error_figure(const std::vector<ArmVariant>& list, const Assessments& all) {
    chart::BarChart chart{.title = "Error on pressures left out",
                          .categories = {},
                          .y = {.label = "error of the displacement", .unit = "%"},
                          .groups = {{"0.7 s after the onset", {}}, {"end of the record", {}}}};
    for (std::size_t v = 0; v < list.size(); ++v) {
        chart.categories.push_back(list[v].name);
        for (std::size_t k = 0; k < 2; ++k)
            chart.groups[k].values.push_back(100.0 * mean_error(all[v][k]->every_second));
    }
    return chart::svg(chart_of(chart));
}

std::string pose_figure(const Assessments& all) {
    // Variant 1 is AC2 as published.
    const Assessment &published = *all[1][1], &own = *all[chosen_variant][1];
    chart::Chart chart{
        .title = "Tip centre at the end of the record", .x = {.label = "pressure", .unit = "mbar"}, .panels = {}};
    const char* const axes[] = {"x", "y", "z"};
    for (Index c = 0; c < 3; ++c) {
        chart::Series real{.name = "measured", .style = chart::SeriesStyle::dots, .colour = chart::ink_colour};
        for (std::size_t i = 0; i < own.arm.fits.size(); ++i) {
            real.x.push_back(own.arm.pressures_mbar[i]);
            real.y.push_back(1e3 * own.arm.measured_m[i](c, 0));
        }
        chart::Panel panel{.y = {.label = axes[c], .unit = "mm"}, .series = {real}, .height_px = 180.0};
        for (const Assessment* one : {&own, &published}) {
            chart::Series out{.name = one->arm.variant.name + ", this pressure left out",
                              .style = chart::SeriesStyle::line_and_dots};
            for (const Score& score : one->left_one_out) {
                out.x.push_back(score.pressure_mbar);
                out.y.push_back(1e3 * score.prediction.tip_m(c));
            }
            panel.series.push_back(out);
        }
        chart.panels.push_back(panel);
    }
    return chart::svg(chart);
}

std::vector<std::string> findings_of(const Assessments& all) {
    const auto error = [&](std::size_t v, std::size_t k) { return mean_error(all[v][k]->every_second); };
    const Assessment &early = *all[chosen_variant][0], &late = *all[chosen_variant][1];
    std::vector<std::string> findings = {
        "Fitted at every second pressure, two muscles with a signal each predict the pressures between with an error "
        "of " +
            percent(error(chosen_variant, 0)) + " at 0.7 s and " + percent(error(chosen_variant, 1)) +
            " at the end; the paper's AC2 as published " + percent(error(1, 0)) + " and " + percent(error(1, 1)) +
            " by the same measure.",
        "Leaving out one pressure at a time, those inside the map are predicted with " +
            percent(mean_error(early.left_one_out, false)) + " and " + percent(mean_error(late.left_one_out, false)) +
            "; with its two ends, which are then extrapolated, " + percent(mean_error(early.left_one_out)) + " and " +
            percent(mean_error(late.left_one_out)) + ".",
        "One muscle alone does it in our model with " + percent(error(2, 1)) +
            " at the end; tying a contracting antagonist to it (AC2) lifts the tip too much: " + percent(error(3, 1)) +
            "."};
    // Range of the antagonist's signal over the pressures.
    double lowest = 10.0, highest = -10.0;
    for (const PoseFit& fit : late.arm.fits) {
        lowest = std::min(lowest, fit.signals(1));
        highest = std::max(highest, fit.signals(1));
    }
    findings.push_back(
        "With a signal of its own the antagonist contracts to " + format_number(lowest, 3) +
        " at most (AC2 would have it at " + format_number(1.0 - 0.5 * (late.arm.fits.back().signals(0) - 1.0), 3) +
        "). The arm bends " + format_number(bending_direction(late.arm.measured_m) * 180.0 / std::numbers::pi, 2) +
        " deg off the x axis, which is about what hand-placed markers leave uncertain; the paper left y out.");
    if (!late.others.empty())
        findings.push_back(
            "Other recordings at pressures inside the map are predicted, in the plane of their own bending, with " +
            percent(mean_error_in_plane(early.others)) + " at 0.7 s and " + percent(mean_error_in_plane(late.others)) +
            " as long after the onset as the sweep was recorded; held longer, the arm creeps on by what the table "
            "says, which a map at rest does not know.");
    return findings;
}

}  // namespace myo::reproduce
