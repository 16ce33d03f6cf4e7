#include "reproduce/signal_fit.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "chart/svg.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double step_s = 0.01;  // of the recordings, and of the paper
constexpr double min_smoothness_m_s = 2e-5;

/// Unknown signals of a variant; as published they are piecewise constant.
inverse::SoughtSignals sought_signals(const SignalVariant& variant, double end_s) {
    inverse::SoughtSignals sought;
    sought.groups = variant.configuration.muscles;
    for (int s = 0; s < variant.configuration.signals; ++s)
        sought.signals.push_back(
            {"signal " + std::to_string(s + 1), variant.configuration.lower, variant.configuration.upper, 1.0});
    sought.frequency_Hz = variant.frequency_Hz;
    sought.end_s = end_s;
    sought.hold = variant.body.published;
    // Passive before the onset, so that the first change counts as a rate.
    sought.from_before = true;
    return sought;
}

/// The record from its onset on, rotated so that the model bends along x.
inverse::MarkerTarget target_of(const SignalVariant& variant, const measurement::MarkerSet& points,
                                const RobotTrial& trial, const Matrix3d& to_model) {
    // The rest before the onset is not compared: the model begins in equilibrium.
    Index first = 0;
    while (first < trial.time_s.size() && trial.time_s(first) < 0.0) ++first;
    inverse::MarkerTarget target;
    target.markers = points;
    target.from_start = true;
    target.times_s = trial.time_s.tail(trial.time_s.size() - first);
    target.positions_m.assign(points.bindings.size(), Matrix3Xd::Constant(3, target.times_s.size(), std::nan("")));
    // Only the tracked point is followed; the columns of the markers stay NaN.
    target.positions_m[0] = to_model * trial.tip_m.rightCols(target.times_s.size());
    if (variant.body.published) target.positions_m[0].row(1).setConstant(std::nan(""));
    return target;
}

/// Initial signals: those of the final pose, scaled at each knot by the share of the motion done by then.
Result<MatrixXd> start_values(const TipResponse& response, const inverse::SoughtSignals& sought,
                              const inverse::MarkerTarget& target, const Progress& progress) {
    if (!response.rest().ok) return Error{response.rest().message, "at rest"};
    // The mean of the last 0.1 s is taken for the final pose.
    const Index last = target.times_s.size(), tail = std::min<Index>(last, 10);
    Matrix3Xd goal = Matrix3Xd::Constant(3, static_cast<Index>(target.positions_m.size()), std::nan(""));
    goal.col(0) = target.positions_m[0].rightCols(tail).rowwise().mean();
    const Result<PoseFit> end = fit_pose(response, goal, unmoved(response), progress);
    if (!end) return end.error();
    MatrixXd values = inverse::unmoved_values(sought);
    const std::vector<double> knots = inverse::knot_times(sought);
    for (Index k = 0; k < values.cols(); ++k) {
        // A held value represents the interval up to the next knot.
        const double t = knots[static_cast<std::size_t>(k)] + (sought.hold ? 0.5 / sought.frequency_Hz : 0.0);
        Index sample = 0;
        while (sample + 1 < last && target.times_s(sample) < t) ++sample;
        const double share = std::clamp(target.positions_m[0](0, sample) / goal(0, 0), 0.0, 1.2);
        values.col(k) = (1.0 + share * (end->signals.array() - 1.0)).matrix();
    }
    return values;
}

/// Largest jump, rate and range of the activations, and values at bounds.
void measure_smoothness(SignalFit& result) {
    for (const fibre::Signal& signal : result.activation) {
        const auto [low, high] = std::minmax_element(signal.values.begin(), signal.values.end());
        for (std::size_t k = 1; k < signal.values.size(); ++k)
            if (const double jump = std::abs(signal.values[k] - signal.values[k - 1]); jump > result.largest_jump) {
                result.largest_jump = jump;
                result.range = *high - *low;
            }
    }
    result.largest_rate_1_s = result.largest_jump * result.sought.frequency_Hz;
    for (Index s = 0; s < result.fit.values.rows(); ++s) {
        const inverse::SoughtSignal& signal = result.sought.signals[static_cast<std::size_t>(s)];
        result.at_bounds += static_cast<int>((result.fit.values.row(s).array() <= signal.lower).count() +
                                             (result.fit.values.row(s).array() >= signal.upper).count());
    }
}

}  // namespace

Result<SignalFit> fit_signals(const ReproduceSettings& settings, const MuscleRobot& robot, const SignalVariant& variant,
                              const RobotTrial& trial, const Progress& progress) {
    const Stopwatch watch;
    if (progress.cancelled()) return Error{"stopped", ""};
    const Result<MuscleBody> body = make_muscle_body(settings, robot, variant.body);
    if (!body) return body.error();
    // End of the record after the onset [s].
    const double end = trial.time_s.tail(1)(0);
    const double angle = variant.body.published
                             ? 0.0
                             : bending_direction({mean_between(trial, end - 0.1, end)}, robot.bends_to);
    // The model bends along x; the robot bends in the plane of the recording's final pose.
    const Matrix3d to_robot = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    // Static response for the start of the search; the search itself runs the dynamics.
    const TipResponse response(*body, variant.configuration);

    inverse::ActuationProblem problem;
    problem.model = body->model;
    // Integrator and step of the published program, or ours at the same step.
    problem.options.start = dynamics::StartKind::equilibrium;
    problem.options.integrator = variant.body.published ? dynamics::Integrator::implicit_euler
                                                        : dynamics::Integrator::tr_bdf2;
    problem.options.h_s = step_s;
    problem.options.end_s = end;
    problem.target = target_of(variant, body->points, trial, to_robot.transpose());
    problem.sought = sought_signals(variant, end);
    problem.smoothness_m_s = std::max(min_smoothness_m_s, trial.noise_m);
    const Result<MatrixXd> start = start_values(response, problem.sought, problem.target, progress);
    if (!start) return Error{start.error().text(), variant.name};

    SignalFit result{
        variant,
        problem.sought,
        inverse::fit_actuation(problem, *start, {.max_evaluations = variant.max_evaluations, .relative_decrease = 3e-5},
                               progress),
        {},
        {},
        {},
        {}};
    if (progress.cancelled()) return Error{"stopped", ""};
    if (!result.fit.usable()) return Error{result.fit.message, variant.name};
    result.activation = inverse::commands_of(problem.sought, result.fit.values);
    result.times_s = problem.target.times_s;
    result.measured_m = trial.tip_m.rightCols(result.times_s.size());
    const measurement::MarkerTracks tracks = measurement::observe(result.fit.best.motion, body->points, result.times_s),
                                    origin = measurement::observe(result.fit.best.motion, body->points,
                                                                  Eigen::VectorXd::Zero(1));
    // Displacements from the equilibrium at t = 0, rotated back to the frame of the robot.
    result.simulated_m = to_robot * (tracks.positions[0].colwise() - Vector3d(origin.positions[0].col(0)));
    result.rms_m = (result.simulated_m - result.measured_m).rowwise().squaredNorm().cwiseSqrt() /
                   std::sqrt(static_cast<double>(result.times_s.size()));
    measure_smoothness(result);
    result.seconds = watch.seconds();
    return result;
}

Result<std::vector<SignalFit>> fit_all_signals(const ReproduceSettings& settings, const MuscleRobot& robot,
                                               const std::vector<SignalVariant>& variants, const RobotTrial& trial,
                                               const Progress& progress) {
    std::vector<Result<SignalFit>> results(variants.size(), Error{"not run", ""});
    std::vector<double> done(variants.size(), 0.0);
    double total = 0.0;
    for (const SignalVariant& variant : variants) total += variant.max_evaluations;
    std::mutex mutex;
    parallel_tasks(static_cast<int>(variants.size()), settings.threads, [&](int task) {
        const auto v = static_cast<std::size_t>(task);
        const auto report = [&](double evaluations) {
            const std::lock_guard lock(mutex);
            done[v] = evaluations;
            // Total of all variants: each reports its own evaluations only.
            double sum = 0.0;
            for (const double one : done) sum += one;
            progress.report({robot.id, sum, total, "evaluations at most", variants[v].name});
        };
        results[v] = fit_signals(settings, robot, variants[v], trial,
                                 progress.with_sink([&](const ProgressEvent& event) { report(event.done); }));
        // A fit that converged early counts as complete.
        report(variants[v].max_evaluations);
    });
    std::vector<SignalFit> fits;
    for (Result<SignalFit>& result : results) {
        if (!result) return result.error();
        fits.push_back(std::move(*result));
    }
    return fits;
}

report::Table signal_table(const std::string& caption, const std::vector<SignalFit>& fits) {
    report::Table table{caption,
                        {{"model"},
                         {"unknowns", "", 5},
                         {"x, rms", "mm", 3},
                         {"y, rms", "mm", 3},
                         {"z, rms", "mm", 3},
                         {"all, of the way", "%", 3},
                         {"largest jump of a", "", 3},
                         {"of its range", "%", 3},
                         {"fastest", "1/s", 3},
                         {"values at a bound", "", 2},
                         {"evaluations", "", 3},
                         {"took", "s", 3}},
                        {}};
    for (const SignalFit& fit : fits) {
        // Largest displacement of the tracked point: errors are stated as a share of it.
        const double way = fit.measured_m.colwise().norm().maxCoeff();
        const Vector3d mm = 1e3 * fit.rms_m;
        table.rows.push_back({fit.variant.name, static_cast<double>(fit.fit.values.size()), mm(0), mm(1), mm(2),
                              100.0 * fit.rms_m.norm() / way, fit.largest_jump, 100.0 * fit.largest_jump / fit.range,
                              fit.largest_rate_1_s, fit.at_bounds, fit.fit.log.size(), fit.seconds});
    }
    return table;
}

std::string signal_figure(const std::string& title, const std::vector<SignalFit>& fits) {
    chart::Chart chart{.title = title, .x = {.label = "time", .unit = "s"}, .panels = {}};
    const char* const axes[] = {"x", "y", "z"};
    const auto as_list = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
    for (Index c = 0; c < 3; ++c) {
        chart::Panel panel{.y = {.label = axes[c], .unit = "mm"},
                           .series = {{.name = "measured",
                                       .x = as_list(fits.front().times_s),
                                       .y = as_list(1e3 * fits.front().measured_m.row(c)),
                                       .colour = chart::ink_colour}},
                           .height_px = c == 0 ? 260.0 : 150.0};
        for (std::size_t i = 0; i < fits.size(); ++i)
            panel.series.push_back({.name = fits[i].variant.name,
                                    .x = as_list(fits[i].times_s),
                                    .y = as_list(1e3 * fits[i].simulated_m.row(c)),
                                    .colour = static_cast<int>(i)});
        chart.panels.push_back(panel);
    }
    // Below the coordinates: one colour per variant, dashed for its second muscle.
    chart::Panel panel{.y = {.label = "activation"}, .series = {}, .height_px = 220.0};
    for (std::size_t i = 0; i < fits.size(); ++i)
        for (std::size_t m = 0; m < fits[i].activation.size(); ++m) {
            chart::Series series{.style = m == 0 ? chart::SeriesStyle::line : chart::SeriesStyle::dashed,
                                 .colour = static_cast<int>(i)};
            for (std::size_t k = 0; k < fits[i].activation[m].times_s.size(); ++k)
                if (fits[i].activation[m].times_s[k] >= 0.0 &&
                    fits[i].activation[m].times_s[k] <= fits[i].times_s.tail(1)(0)) {
                    series.x.push_back(fits[i].activation[m].times_s[k]);
                    series.y.push_back(fits[i].activation[m].values[k]);
                }
            panel.series.push_back(series);
        }
    chart.panels.push_back(panel);
    return chart::svg(chart);
}

report::Json signal_json(const std::vector<SignalFit>& fits) {
    report::Json rows = report::Json::array();
    for (const SignalFit& fit : fits) {
        report::Json row = {{"name", fit.variant.name},
                            {"rms_x_m", fit.rms_m(0)},
                            {"rms_y_m", fit.rms_m(1)},
                            {"rms_z_m", fit.rms_m(2)},
                            {"largest_jump", fit.largest_jump},
                            {"largest_rate_1_s", fit.largest_rate_1_s},
                            {"range", fit.range},
                            {"at_bounds", fit.at_bounds},
                            {"evaluations", fit.fit.log.size()},
                            {"way_m", fit.measured_m.colwise().norm().maxCoeff()}};
        for (const fibre::Signal& signal : fit.activation)
            row["activation"].push_back({{"times_s", signal.times_s}, {"values", signal.values}});
        rows.push_back(row);
    }
    return rows;
}

}  // namespace myo::reproduce
