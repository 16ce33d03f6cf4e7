#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "report/chart.hpp"
#include "reproduce/arm_maps.hpp"
#include "reproduce/reproduction_cases.hpp"

namespace myo::reproduce {
// Static map from pressure to muscle signals: fitted at some pressures, tested at those left out. Every second pressure
// and leave-one-out separate interpolation from extrapolation; independent recordings test repeatability.
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double first_mbar = 75.0, last_mbar = 375.0, between_mbar = 50.0;  // pressures of the paper's map

/// Indices of the pressures of the paper's map; all, if fewer than four of these exist.
std::vector<std::size_t> pressures_of_map(const std::vector<RobotTrial>& trials) {
    std::vector<std::size_t> chosen, all(trials.size());
    std::iota(all.begin(), all.end(), 0);
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](std::size_t i) {
        const double p = trials[i].pressure_mbar;
        return p >= first_mbar && p <= last_mbar && std::fmod(p - first_mbar, between_mbar) == 0.0;
    });
    return chosen.size() < 4 ? all : chosen;
}

std::vector<ArmVariant> variants(bool coarse) {
    const MuscleBodyOptions published{.published = true, .edge_m = coarse ? 7e-3 : 0.0},
        own{.edge_m = coarse ? 9e-3 : 5e-3};
    const auto with = [](MuscleBodyOptions body, int muscles) {
        body.muscles = muscles;
        return body;
    };
    return {{"AC1 as published", with(published, 1), one_muscle()},
            {"AC2 as published", with(published, 2), tied_muscles()},
            {"AC1, our model", with(own, 1), one_muscle()},
            {"AC2, our model", with(own, 2), tied_muscles()},
            {"two signals, our model", with(own, 2), free_muscles()},
            {"two signals, fitted to the markers", with(own, 2), free_muscles(), true}};
}
/// The variant whose predictions are shown in full: two signals, our model.
constexpr std::size_t chosen_variant = 4;

/// Prediction of one pressure that the map does not contain.
struct Score {
    std::string what;
    double pressure_mbar = 0.0;
    bool extrapolated = false;
    ArmPrediction prediction;
    Vector3d measured_m = Vector3d::Zero();
    double error() const { return relative_error(prediction.tip_m, measured_m); }
};

/// A variant at one instant with its predictions.
struct Assessment {
    FittedArm arm;
    std::vector<Score> every_second;  // predicted from the first, third, ... pressure of the map
    std::vector<Score> left_one_out;
    std::vector<Score> others;  // recordings outside the map; like the grid, of the chosen variant only
    std::vector<ArmPrediction> grid;
};
constexpr double grid_first_mbar = 50.0, grid_step_mbar = 25.0;
constexpr int grid_count = 15;

double mean_error(const std::vector<Score>& scores, bool with_extrapolated = true) {
    double sum = 0.0;
    int count = 0;
    for (const Score& score : scores)
        if (with_extrapolated || !score.extrapolated) {
            sum += score.error();
            ++count;
        }
    return count > 0 ? sum / count : std::nan("");
}

/// Relative error in the bending plane of the recording itself: its direction depends on how the markers were placed.
double error_in_plane(const Score& score) {
    const Vector3d &p = score.prediction.tip_m, &m = score.measured_m;
    return std::hypot(std::hypot(p(0), p(1)) - std::hypot(m(0), m(1)), p(2) - m(2)) / m.norm();
}

/// Mean of error_in_plane() over pressures inside the map.
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

// A prediction outside the known pressures is marked as extrapolated.
Score predict(const FittedArm& arm, const std::vector<std::size_t>& known, const std::string& what,
              double pressure_mbar, const Vector3d& measured_m) {
    const auto pressure = [&](std::size_t i) { return arm.pressures_mbar[i]; };
    const bool outside = pressure_mbar < pressure(known.front()) || pressure_mbar > pressure(known.back());
    return {what, pressure_mbar, outside, predict_arm(arm, known, pressure_mbar), measured_m};
}

/// Fits a variant and predicts pressures left out: every second one, each one, and other recordings if `in_full`.
Result<Assessment> assess(const std::shared_ptr<const TipResponse>& response, const ArmVariant& variant,
                          const std::vector<RobotTrial>& map, const std::vector<RobotTrial>& others, Instant instant,
                          bool in_full, const Progress& progress) {
    Result<FittedArm> fitted = fit_arm(response, variant, map, instant, progress);
    if (!fitted) return fitted.error();
    Assessment result{std::move(*fitted), {}, {}, {}, {}};
    const FittedArm& arm = result.arm;
    std::vector<std::size_t> all(map.size()), even;
    std::iota(all.begin(), all.end(), 0);
    for (std::size_t i = 0; i < all.size(); i += 2) even.push_back(i);
    for (std::size_t i = 1; i < all.size() && !progress.cancelled(); i += 2)
        result.every_second.push_back(predict(arm, even, map[i].name, map[i].pressure_mbar, arm.measured_m[i].col(0)));
    for (std::size_t i = 0; i < all.size() && all.size() > 2 && !progress.cancelled(); ++i) {
        std::vector<std::size_t> known = all;
        known.erase(known.begin() + static_cast<std::ptrdiff_t>(i));
        result.left_one_out.push_back(predict(arm, known, map[i].name, map[i].pressure_mbar, arm.measured_m[i].col(0)));
    }
    const double as_long_s = map.front().time_s.tail(1)(0);
    for (const RobotTrial& trial : others) {
        if (progress.cancelled() || !in_full) break;
        // Step trials are held longer than the sweep and creep: they are compared at the same time after the onset.
        const Vector3d measured = trial.stepped && instant == Instant::end
                                      ? mean_between(trial, as_long_s - 0.1, as_long_s).col(0)
                                      : pose_at(trial, instant).col(0);
        result.others.push_back(predict(arm, all, trial.name, trial.pressure_mbar, measured));
    }
    for (int k = 0; in_full && k < grid_count && !progress.cancelled(); ++k)
        result.grid.push_back(predict_arm(arm, all, grid_first_mbar + grid_step_mbar * k));
    if (progress.cancelled()) return Error{"stopped", ""};
    return result;
}

/// Per variant, at both instants.
using Assessments = std::vector<std::array<Result<Assessment>, 2>>;

/// Bodies of all variants with their rest equilibrium.
Result<std::vector<std::shared_ptr<const TipResponse>>> responses(const ReproduceSettings& settings,
                                                                  const std::vector<ArmVariant>& list,
                                                                  const Progress& progress) {
    std::vector<std::shared_ptr<const TipResponse>> result;
    for (const ArmVariant& variant : list) {
        if (progress.cancelled()) return Error{"stopped", ""};
        Result<MuscleBody> body = make_muscle_body(settings, paper_arm(), variant.body);
        if (!body) return body.error();
        result.push_back(std::make_shared<TipResponse>(std::move(*body), variant.configuration));
        if (!result.back()->rest().ok) return Error{result.back()->rest().message, variant.name + " at rest"};
    }
    return result;
}

/// Mean errors per variant and kind of test.
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

/// Fitted signals and their remaining distance, pose by pose.
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
            const Eigen::Vector2d plane(list[v].body.published ? u(0) : -std::hypot(u(0), u(1)), u(2)),
                off = plane - Eigen::Vector2d(model(0), model(2));
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

void add_scores(report::Table& table, const std::string& kind, const std::vector<Score>& early,
                const std::vector<Score>& late) {
    for (std::size_t i = 0; i < late.size(); ++i) {
        const Vector3d p = 1e3 * late[i].prediction.tip_m, m = 1e3 * late[i].measured_m;
        table.rows.push_back({kind, late[i].what, late[i].pressure_mbar, p(0), m(0), p(1), m(1), p(2), m(2),
                              100.0 * early[i].error(), 100.0 * late[i].error()});
    }
}

/// Predictions of the chosen variant for pressures of the map that were left out.
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

/// Relative increase of the displacement of a step trial after `until_s`, until it is vented.
double creep(const RobotTrial& trial, double until_s) {
    const double then = mean_between(trial, until_s - 0.1, until_s).col(0).norm();
    double most = then;
    for (double t = until_s; t < trial.time_s.tail(1)(0); t += 0.1)
        if (const double now = mean_between(trial, t - 0.1, t).col(0).norm(); now > most) most = now;
    return most / then - 1.0;
}

/// Predictions of the chosen variant for recordings outside the map.
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
        table.rows.push_back({a.what, a.pressure_mbar, a.extrapolated ? "yes" : "no", 1e3 * a.measured_m.norm(),
                              1e3 * a.prediction.tip_m.norm(), 100.0 * a.error(), 100.0 * b.error(),
                              100.0 * error_in_plane(a), 100.0 * error_in_plane(b),
                              bending_direction({a.measured_m}) * 180.0 / std::numbers::pi,
                              100.0 * creep(others[i], as_long_s)});
    }
    return table;
}

/// Predictions on a regular grid of pressures.
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

/// Map from pressure to the signal of muscle 1, all variants.
std::string map_figure(const std::vector<ArmVariant>& list, const Assessments& all) {
    report::LineChart chart{.title = "Activation of muscle 1 over pressure",
                            .x = {.label = "pressure", .unit = "mbar", .lowest = 0.0},
                            .panels = {}};
    report::ChartPanel panel{.y = {.label = "a"}, .series = {}, .height_px = 320.0};
    for (std::size_t v = 0; v <= chosen_variant; ++v) {
        const FittedArm& arm = all[v][1]->arm;
        std::vector<double> lengths, pressures;
        Eigen::MatrixXd signals(list[v].configuration.signals, static_cast<Index>(arm.fits.size()));
        report::Series dots{.style = report::SeriesStyle::dots, .colour = static_cast<int>(v)},
            curve{.name = list[v].name, .colour = static_cast<int>(v)};
        for (std::size_t i = 0; i < arm.fits.size(); ++i) {
            signals.col(static_cast<Index>(i)) = arm.fits[i].signals;
            lengths.push_back(arm.measured_m[i].col(0).norm());
            dots.x.push_back(arm.pressures_mbar[i]);
            dots.y.push_back(arm.fits[i].signals(0));
        }
        const PressureMap map = list[v].body.published ? polynomial_map(arm.pressures_mbar, signals)
                                                       : map_from_rest(arm.pressures_mbar, signals, lengths);
        for (double p = list[v].body.published ? arm.pressures_mbar.front() : 0.0; p <= arm.pressures_mbar.back();
             p += 5.0) {
            curve.x.push_back(p);
            curve.y.push_back(map.at(p)(0));
        }
        panel.series.push_back(curve);
        panel.series.push_back(dots);
    }
    chart.panels = {panel};
    return report::svg(chart);
}

/// Mean errors as bars.
std::string error_figure(const std::vector<ArmVariant>& list, const Assessments& all) {
    report::BarChart chart{.title = "Error on pressures left out",
                           .categories = {},
                           .y = {.label = "error of the displacement", .unit = "%"},
                           .groups = {{"0.7 s after the onset", {}}, {"end of the record", {}}}};
    for (std::size_t v = 0; v < list.size(); ++v) {
        chart.categories.push_back(list[v].name);
        for (std::size_t k = 0; k < 2; ++k)
            chart.groups[k].values.push_back(100.0 * mean_error(all[v][k]->every_second));
    }
    return report::svg(chart);
}

/// Tip coordinates over pressure, each predicted without its own recording.
std::string pose_figure(const Assessments& all) {
    const Assessment &published = *all[1][1], &own = *all[chosen_variant][1];
    report::LineChart chart{
        .title = "Tip centre at the end of the record", .x = {.label = "pressure", .unit = "mbar"}, .panels = {}};
    const char* const axes[] = {"x", "y", "z"};
    for (Index c = 0; c < 3; ++c) {
        report::Series real{.name = "measured", .style = report::SeriesStyle::dots, .colour = report::ink_colour};
        for (std::size_t i = 0; i < own.arm.fits.size(); ++i) {
            real.x.push_back(own.arm.pressures_mbar[i]);
            real.y.push_back(1e3 * own.arm.measured_m[i](c, 0));
        }
        report::ChartPanel panel{.y = {.label = axes[c], .unit = "mm"}, .series = {real}, .height_px = 180.0};
        for (const Assessment* one : {&own, &published}) {
            report::Series out{.name = one->arm.variant.name + ", this pressure left out",
                               .style = report::SeriesStyle::line_and_dots};
            for (const Score& score : one->left_one_out) {
                out.x.push_back(score.pressure_mbar);
                out.y.push_back(1e3 * score.prediction.tip_m(c));
            }
            panel.series.push_back(out);
        }
        chart.panels.push_back(panel);
    }
    return report::svg(chart);
}

/// Response of the models to fixed activations, if no measured data are available.
Reproduction response_only(const std::vector<ArmVariant>& list,
                           const std::vector<std::shared_ptr<const TipResponse>>& bodies) {
    Reproduction result;
    result.title = "Pneumatic arm: a muscle for a chamber";
    report::Table table{"Tip centre over the activation of muscle 1",
                        {{"model"}, {"muscle 1", "", 3}, {"x", "mm", 4}, {"y", "mm", 4}, {"z", "mm", 4}},
                        {}};
    for (std::size_t v = 0; v < chosen_variant; ++v)
        for (const double a : {1.1, 1.2, 1.3, 1.4}) {
            const TipPose pose = bodies[v]->at(Eigen::VectorXd::Constant(1, a));
            if (pose.ok)
                table.rows.push_back({list[v].name, a, 1e3 * pose.displacement_m(0, 0), 1e3 * pose.displacement_m(1, 0),
                                      1e3 * pose.displacement_m(2, 0)});
        }
    result.tables = {table};
    result.values["models"] = table_json(table);
    return result;
}

/// All variants at both instants, in parallel.
Result<Assessments> assess_all(const ReproduceSettings& settings, const std::vector<ArmVariant>& list,
                               const std::vector<std::shared_ptr<const TipResponse>>& bodies,
                               const std::vector<RobotTrial>& map, const std::vector<RobotTrial>& others,
                               const Progress& progress) {
    Assessments all(list.size(), {Result<Assessment>(Error{"not run", ""}), Result<Assessment>(Error{"not run", ""})});
    std::atomic<int> done{0};
    const int count = 2 * static_cast<int>(list.size());
    parallel_tasks(count, settings.threads, [&](int task) {
        const auto v = static_cast<std::size_t>(task / 2), k = static_cast<std::size_t>(task % 2);
        all[v][k] = assess(bodies[v], list[v], map, others, both_instants[k], v == chosen_variant, progress);
        progress.report({"arm", static_cast<double>(++done), static_cast<double>(count), "maps", ""});
    });
    for (const auto& both : all)
        for (const Result<Assessment>& one : both)
            if (!one) return one.error();
    return all;
}

std::string percent(double share) { return format_number(100.0 * share, 3) + " %"; }

/// The results in sentences.
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
    double lowest = 10.0, highest = -10.0;
    for (const PoseFit& fit : late.arm.fits) {
        lowest = std::min(lowest, fit.signals(1));
        highest = std::max(highest, fit.signals(1));
    }
    findings.push_back(
        "With a signal of its own the antagonist contracts to " + format_number(lowest, 3) +
        " at most (AC2 would have it at " + format_number(1.0 - 0.5 * (late.arm.fits.back().signals(0) - 1.0), 3) +
        "). The arm bends " + format_number(bending_direction(late.arm.measured_m) * 180.0 / std::numbers::pi, 2) +
        " deg beside the x axis, which is about what hand-placed markers leave uncertain; the paper left y out.");
    if (!late.others.empty())
        findings.push_back(
            "Other recordings at pressures inside the map are predicted, in the plane of their own bending, with " +
            percent(mean_error_in_plane(early.others)) + " at 0.7 s and " + percent(mean_error_in_plane(late.others)) +
            " as long after the onset as the sweep was recorded; held longer, the arm creeps on by what the table "
            "says, which a map at rest does not know.");
    return findings;
}

/// The case: data, fits, predictions, tables and figures.
Result<Reproduction> run(const ReproduceSettings& settings, const Progress& progress) {
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(settings), steps = read_arm_steps(settings);
    if (!sweep) return sweep.error();
    if (!steps) return steps.error();
    if (progress.cancelled()) return Error{"stopped", ""};
    Reproduction result;
    result.title = "Pneumatic arm: pressure to muscle, at rest";
    if (sweep->empty()) result.warnings.push_back(missing_data(settings, "arm_pressure_sweep"));
    if (steps->empty()) result.warnings.push_back(missing_data(settings, "arm"));
    if (!std::filesystem::exists(geometry_file(settings, paper_arm()))) {
        result.warnings.push_back(missing_geometry(settings, paper_arm()));
        return result;
    }
    const std::vector<ArmVariant> list = variants(settings.coarse);
    const auto bodies = responses(settings, list, progress);
    if (!bodies) return bodies.error();
    if (sweep->size() < 3) {
        Reproduction response = response_only(list, *bodies);
        response.warnings = result.warnings;
        return response;
    }
    std::vector<RobotTrial> map, others;
    const std::vector<std::size_t> of_map = pressures_of_map(*sweep);
    for (std::size_t i = 0; i < sweep->size(); ++i)
        (std::find(of_map.begin(), of_map.end(), i) != of_map.end() ? map : others).push_back((*sweep)[i]);
    others.insert(others.end(), steps->begin(), steps->end());
    const Result<Assessments> all = assess_all(settings, list, *bodies, map, others, progress);
    if (!all) return all.error();
    const Assessment &early = *(*all)[chosen_variant][0], &late = *(*all)[chosen_variant][1];
    result.findings = findings_of(*all);
    result.tables = {errors_table(list, *all), predictions_table(early, late),
                     others_table(early, late, others, map.front().time_s.tail(1)(0)), fits_table(list, *all)};
    result.figures.push_back({"",
                              {map_figure(list, *all),
                               "Dots: fitted pose by pose at the end of the records. As published the paper's "
                               "polynomial; ours begins at rest."}});
    result.figures.push_back(
        {"errors", {error_figure(list, *all), "Pressures 125, 225, ... from a map through 75, 175, ..."}});
    result.figures.push_back({"poses", {pose_figure(*all), "Each pressure predicted from a map through the others."}});
    for (std::size_t v = 0; v < list.size(); ++v)
        result.values["models"].push_back(
            {{"name", list[v].name},
             {"dofs", (*bodies)[v]->body().model.body->dofs()},
             {"every_second_0.7_s", report::json_number(mean_error((*all)[v][0]->every_second))},
             {"every_second_end", report::json_number(mean_error((*all)[v][1]->every_second))},
             {"one_out_0.7_s", report::json_number(mean_error((*all)[v][0]->left_one_out))},
             {"one_out_end", report::json_number(mean_error((*all)[v][1]->left_one_out))}});
    for (const PoseFit& fit : late.arm.fits)
        result.values["signals"].push_back(std::vector<double>(fit.signals.begin(), fit.signals.end()));
    result.values["map"] = grid_json(early, late);
    result.values["others_in_plane_0.7_s"] = report::json_number(mean_error_in_plane(early.others));
    result.values["others_in_plane_end"] = report::json_number(mean_error_in_plane(late.others));
    result.values["paper_error"] = 0.1307;
    return result;
}

}  // namespace

ReproductionCase reproduce_arm_static() {
    return {"arm-static",
            "pressure-to-muscle maps of the pneumatic arm (AC1, AC2) and what they predict for pressures left out",
            run};
}

}  // namespace myo::reproduce
