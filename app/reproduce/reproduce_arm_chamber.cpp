#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "chart/svg.hpp"
#include "dynamics/statics.hpp"
#include "reproduce/arm_maps.hpp"
#include "reproduce/chambered_arm.hpp"
#include "reproduce/reproduction_cases.hpp"

namespace myo::reproduce {
// Arm with real pressure chambers compared with muscle models of the same outer shape: which errors a muscle makes that
// lengthens instead of a chamber that inflates. Follower pressure loads, quasi-static.
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double mbar = 100.0;  // Pa

/// Equilibrium of the chambered arm under a pressure.
struct ChamberPose {
    double pressure_mbar = 0.0;
    // One column per point of the arm, see ChamberedArm::points.
    Matrix3Xd points_m;     // displacements of the lower face's points from rest without pressure
    double bent_rad = 0.0;  // rotation of the lower face from rest
    double grown_m3 = 0.0;  // increase of the chamber volume
    int iterations = 0;

    Vector3d tip_m() const { return points_m.rowwise().mean(); }
};

/// Positions of markers, 3 x markers [m], for node positions x, 3 x n [m].
Matrix3Xd points_at(const measurement::MarkerSet& markers, const Matrix3Xd& x) {
    Matrix3Xd points(3, static_cast<Eigen::Index>(markers.bindings.size()));
    for (std::size_t i = 0; i < markers.bindings.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = measurement::marker_position(
            markers.bindings[i], x(Eigen::all, markers.bindings[i].nodes));
    return points;
}

/// Poses up to the last pressure with an equilibrium.
struct Inflation {
    std::vector<ChamberPose> poses;
    double ballooned_mbar = 0.0;  // first pressure without equilibrium; 0: none
};

/// Path following from zero pressure in increments of at most 25 mbar.
///
/// Errors: no equilibrium at the first pressure; "stopped".
Result<Inflation> pressurise(const ChamberedArm& arm, const std::vector<double>& pressures_mbar,
                             const Progress& progress) {
    Inflation result;
    Matrix3Xd x = arm.model.body->mesh.nodes, origin;
    double volume = 0.0, before = 0.0;
    constexpr double max_at_once_mbar = 25.0;
    // Zero pressure first: displacements count from the equilibrium under gravity alone.
    std::vector<double> all{0.0};
    all.insert(all.end(), pressures_mbar.begin(), pressures_mbar.end());
    for (const double pressure : all) {
        ChamberPose pose;
        // Newton's method converges from the equilibrium of a slightly lower pressure.
        const int steps = std::max(1, static_cast<int>(std::ceil((pressure - before) / max_at_once_mbar)));
        for (int k = 1; k <= steps; ++k) {
            if (progress.cancelled()) return Error{"stopped", ""};
            model::Model model = arm.model;
            const double now = before + (pressure - before) * k / steps;
            model.force_elements = {
                model::cavity_pressure(*model.body, arm.walls, fibre::Signal::constant(now * mbar))};
            dynamics::StageSolver solver(model);
            const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, x);
            pose.iterations += report.newton_iterations;
            // Failure beyond the first pressure is a limit point: thin walls balloon.
            if (report.ok()) continue;
            if (result.poses.empty()) return Error{report.message, "chambers at " + format_number(now, 3) + " mbar"};
            result.ballooned_mbar = now;
            return result;
        }
        const Matrix3Xd points = points_at(arm.points, x);
        if (origin.size() == 0) {
            origin = points;
            volume = model::cavity_volume(*arm.model.body, arm.walls, x);
        }
        pose.pressure_mbar = pressure;
        pose.points_m = points - origin;
        // Points 0 and 1 lie at -x and +x: their connection turns with the lower face about y.
        const Vector3d side = points.col(1) - points.col(0);
        pose.bent_rad = std::atan2(-side(2), side(0));
        pose.grown_m3 = model::cavity_volume(*arm.model.body, arm.walls, x) - volume;
        if (pressure > 0.0) result.poses.push_back(pose);
        before = pressure;
        progress.report({"arm-chamber", pressure, all.back(), "mbar", {}});
    }
    return result;
}

/// A muscle model fitted to all poses of the chambered arm.
struct MuscleFit {
    std::string name;
    // Signal per pose [-]; 1: passive.
    std::vector<double> levels;
    std::vector<Matrix3Xd> points_m;
    std::vector<double> rms_m;  // over the coordinates of the points
};

/// One muscle level per pressure with the smallest distance of the lower face to that of the chambered arm.
Result<MuscleFit> imitate(const std::vector<ChamberPose>& poses, MuscleConfiguration configuration, double edge,
                          const Progress& progress) {
    // A wide range: the level is sought, not limited.
    configuration.lower = 0.3;
    configuration.upper = 4.0;
    const TipResponse response(filled_arm(edge, static_cast<int>(configuration.muscles.size())), configuration);
    if (!response.rest().ok) return Error{response.rest().message, configuration.name};
    MuscleFit result{configuration.name, {}, {}, {}};
    PoseFit last = unmoved(response);
    for (const ChamberPose& pose : poses) {
        // From the level of the pressure before, along one branch of equilibria.
        const Result<PoseFit> fit = fit_pose(response, pose.points_m, last, progress);
        if (!fit) return fit.error();
        last = *fit;
        result.levels.push_back(fit->signals(0));
        result.points_m.push_back(fit->pose.displacement_m);
        result.rms_m.push_back(std::sqrt((fit->pose.displacement_m - pose.points_m).squaredNorm() /
                                         static_cast<double>(pose.points_m.size())));
    }
    return result;
}

/// Nonlinearity: largest distance of values from the best straight line through (0, at_zero), over their range [-].
double bend_of_curve(const std::vector<double>& x, const std::vector<double>& y, double at_zero) {
    double xx = 0.0, xy = 0.0, off = 0.0, range = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += x[i] * x[i];
        xy += x[i] * (y[i] - at_zero);
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        off = std::max(off, std::abs(y[i] - at_zero - xy / xx * x[i]));
        range = std::max(range, std::abs(y[i] - at_zero));
    }
    return range > 0.0 ? off / range : 0.0;
}

/// Trajectory of the tip in the bending plane, in mm.
chart::Series path(const std::string& name, const std::vector<Vector3d>& tips, chart::SeriesStyle style,
                   int colour = chart::automatic_colour) {
    chart::Series series{.name = name, .style = style, .colour = colour};
    for (const Vector3d& tip : tips) {
        series.x.push_back(-1e3 * tip(0));
        series.y.push_back(1e3 * tip(2));
    }
    return series;
}

/// Length in mm, without its unit.
std::string mm(double m) { return format_number(1e3 * m, 3); }

/// The two muscle models that imitate the chambers.
struct MuscleModels {
    MuscleFit single, tied;
};

/// Chambers, muscle models and the real arm, one row per pressure, with the ways of their tips.
struct ChamberComparison {
    report::Table table;
    std::vector<Vector3d> chamber_tips, single_tips, tied_tips, real_tips;
};

/// Table and ways of the tips.
///
/// @param trials  of the sweep, in the order of the poses; may be fewer or none
ChamberComparison compare(const std::vector<ChamberPose>& poses, const MuscleModels& muscles,
                          const std::vector<RobotTrial>& trials) {
    ChamberComparison all;
    all.table
        .caption = "Tip of the arm with its chambers at +x under pressure, and the muscle level that comes nearest";
    all.table.columns = {{"pressure", "mbar"},        {"tip x", "mm"},      {"tip z", "mm"},      {"bent by", "deg"},
                         {"chambers grown by", "ml"}, {"AC1 level"},        {"AC1 off by", "mm"}, {"AC2 level"},
                         {"AC2 off by", "mm"},        {"real arm x", "mm"}, {"real arm z", "mm"}};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const ChamberPose& pose = poses[i];
        const Vector3d tip = pose.tip_m();
        const Vector3d real = i < trials.size() ? Vector3d(pose_at(trials[i], Instant::end).col(0))
                                                : Vector3d::Constant(std::nan(""));
        all.table.rows.push_back({pose.pressure_mbar, 1e3 * tip(0), 1e3 * tip(2),
                                  pose.bent_rad * 180.0 / std::numbers::pi, 1e6 * pose.grown_m3,
                                  muscles.single.levels[i], 1e3 * muscles.single.rms_m[i], muscles.tied.levels[i],
                                  1e3 * muscles.tied.rms_m[i], 1e3 * real(0), 1e3 * real(2)});
        all.chamber_tips.push_back(tip);
        all.single_tips.emplace_back(muscles.single.points_m[i].rowwise().mean());
        all.tied_tips.emplace_back(muscles.tied.points_m[i].rowwise().mean());
        if (real.allFinite()) all.real_tips.push_back(real);
    }
    return all;
}

/// Ways of the tips in the bending plane as SVG.
std::string tip_figure(const ChamberComparison& all) {
    chart::Chart chart;
    chart.title = "Way of the tip as the pressure rises";
    chart.x = {.label = "towards the unpressurised side", .unit = "mm", .include_zero = true};
    chart::Panel panel;
    panel.y = {.label = "up", .unit = "mm", .include_zero = true};
    panel.series = {path("chambers", all.chamber_tips, chart::SeriesStyle::line_and_dots),
                    path("AC1", all.single_tips, chart::SeriesStyle::dashed),
                    path("AC2", all.tied_tips, chart::SeriesStyle::line)};
    if (!all.real_tips.empty())
        panel.series.push_back(
            path("real arm, other chambers", all.real_tips, chart::SeriesStyle::dots, chart::ink_colour));
    chart.panels = {panel};
    return chart::svg(chart);
}

/// The results in sentences.
///
/// @param pressures  [mbar], those of the poses
std::vector<std::string> chamber_findings(const std::vector<ChamberPose>& poses, const std::vector<double>& pressures,
                                          const MuscleModels& muscles) {
    const ChamberPose& last = poses.back();
    int iterations = 0;
    for (const ChamberPose& pose : poses) iterations += pose.iterations;
    return {
        "At " + format_number(last.pressure_mbar, 3) + " mbar the chambers move the tip by " + mm(last.tip_m().norm()) +
            " mm and bend it by " + format_number(last.bent_rad * 180.0 / std::numbers::pi, 3) +
            " degrees; they grow by " + format_number(1e6 * last.grown_m3, 3) + " ml.",
        "One muscle in their place comes within " + mm(muscles.single.rms_m.back()) +
            " mm rms of the lower face then, two antagonists (AC2) within " + mm(muscles.tied.rms_m.back()) +
            " mm: a muscle that lengthens carries no pressure on the end caps and the side walls.",
        "The level of AC1 over pressure departs from a straight line by " +
            format_number(100.0 * bend_of_curve(pressures, muscles.single.levels, 1.0), 2) +
            " % of its range, that of AC2 by " +
            format_number(100.0 * bend_of_curve(pressures, muscles.tied.levels, 1.0), 2) +
            " %: a muscle model needs a map from pressure to level.",
        std::to_string(iterations) +
            " iterations of the solver for all pressures; the pressure follows its walls, and its tangent is that of "
            "the enclosed volume."};
}

/// What limits the comparison: the body that stands in for the arm, missing data, and walls that balloon.
std::vector<std::string> chamber_warnings(const ReproduceSettings& settings, bool own_file, bool recorded,
                                          double ballooned_mbar) {
    std::vector<std::string> warnings;
    if (!own_file)
        warnings.push_back(
            "the fine mesh of the paper's arm with its ribbed chambers is not public: a plain arm with chambers stands "
            "in for it; a closed surface in mm at " +
            chamber_geometry_file(settings).string() + " would be used instead");
    if (!recorded) warnings.push_back(missing_data(settings, "arm_pressure_sweep"));
    if (ballooned_mbar > 0.0)
        warnings.push_back(
            "at " + format_number(ballooned_mbar, 3) +
            " mbar the walls of the chambers balloon: there is no equilibrium any more, and nothing is said beyond");
    return warnings;
}

/// Pressures of the recordings [mbar]; without recordings, those of the paper.
std::vector<double> sweep_pressures(const std::vector<RobotTrial>& trials) {
    std::vector<double> pressures;
    for (const RobotTrial& trial : trials) pressures.push_back(trial.pressure_mbar);
    if (pressures.empty()) pressures = {75.0, 125.0, 175.0, 225.0, 275.0, 325.0, 375.0};
    return pressures;
}

/// The case: chambers under pressure, two muscle models fitted to them, and the recorded arm.
Result<Reproduction> run_arm_chamber(const ReproduceSettings& settings, const Progress& progress) {
    // Chambers and muscle models have one edge length, so that they are comparable.
    const double edge = settings.coarse ? 9e-3 : 5e-3;
    const Result<ChamberedArm> arm = make_chambered_arm(settings, edge);
    if (!arm) return arm.error();
    // Recordings are for comparison only; without them the case runs at the paper's pressures.
    const Result<std::vector<RobotTrial>> trials = read_arm_sweep(settings);
    if (!trials) return trials.error();
    std::vector<double> pressures = sweep_pressures(*trials);
    const Result<Inflation> inflation = pressurise(*arm, pressures, progress);
    if (!inflation) return inflation.error();
    const std::vector<ChamberPose>& poses = inflation->poses;
    // Pressures beyond ballooning have no pose.
    pressures.resize(poses.size());
    const Result<MuscleFit> single = imitate(poses, one_muscle(), edge, progress);
    if (!single) return single.error();
    const Result<MuscleFit> tied = imitate(poses, tied_muscles(), edge, progress);
    if (!tied) return tied.error();
    const MuscleModels muscles{*single, *tied};
    const ChamberComparison all = compare(poses, muscles, *trials);
    const bool own_file = std::filesystem::exists(chamber_geometry_file(settings));
    Reproduction result;
    result.title = "Pneumatic arm: pressure in true chambers against the muscle model";
    result.warnings = chamber_warnings(settings, own_file, !trials->empty(), inflation->ballooned_mbar);
    result.tables = {all.table};
    result.figures = {{"", {tip_figure(all), "Tip centre of the lower face, from where it hangs without pressure."}}};
    result.findings = chamber_findings(poses, pressures, muscles);
    result.values["chambers"] = arm->chambers;
    result.values["dofs"] = arm->model.body->dofs();
    result.values["geometry"] = own_file ? "file" : "plain";
    return result;
}

}  // namespace

ReproductionCase reproduce_arm_chamber() {
    return {"arm-chamber", "pressure in true chambers of an arm against the muscle model", run_arm_chamber};
}

}  // namespace myo::reproduce
