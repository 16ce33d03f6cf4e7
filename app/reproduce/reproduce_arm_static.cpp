#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "reproduce/arm_static_parts.hpp"
#include "reproduce/reproduction_cases.hpp"

namespace myo::reproduce {
// Static map from pressure to muscle signals: fitted at some pressures, tested at those left out. Every second pressure
// and leave-one-out separate interpolation from extrapolation; independent recordings test repeatability.
namespace {

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

/// Models that are compared. The order is that of `chosen_variant` and of the numbers in findings_of().
std::vector<ArmVariant> arm_variants(bool coarse) {
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
/// Prediction of one pressure from the trials `known`, marked as extrapolated outside of their pressures.
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
    // With the paper's pressures, the map through 75, 175, ... mbar predicts 125, 225, ... mbar: interpolation only.
    for (std::size_t i = 0; i < all.size(); i += 2) even.push_back(i);
    for (std::size_t i = 1; i < all.size() && !progress.cancelled(); i += 2)
        result.every_second.push_back(predict(arm, even, map[i].name, map[i].pressure_mbar, arm.measured_m[i].col(0)));
    for (std::size_t i = 0; i < all.size() && all.size() > 2 && !progress.cancelled(); ++i) {
        std::vector<std::size_t> known = all;
        known.erase(known.begin() + static_cast<std::ptrdiff_t>(i));
        result.left_one_out.push_back(predict(arm, known, map[i].name, map[i].pressure_mbar, arm.measured_m[i].col(0)));
    }
    // Length of the records of the sweep after the onset.
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
    // A slot per variant and instant, so that tasks write without a lock.
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

/// The case: data, fits, predictions, tables and figures.
Result<Reproduction> run_arm_static(const ReproduceSettings& settings, const Progress& progress) {
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(settings), steps = read_arm_steps(settings);
    if (!sweep) return sweep.error();
    if (!steps) return steps.error();
    if (progress.cancelled()) return Error{"stopped", ""};
    Reproduction result;
    result.title = "Pneumatic arm: pressure to muscle, at rest";
    if (sweep->empty()) result.warnings.push_back(missing_data(settings, "arm_pressure_sweep"));
    if (steps->empty()) result.warnings.push_back(missing_data(settings, "arm"));
    // Without the body nothing can be run.
    if (!std::filesystem::exists(geometry_file(settings, paper_arm()))) {
        result.warnings.push_back(missing_geometry(settings, paper_arm()));
        return result;
    }
    const std::vector<ArmVariant> list = arm_variants(settings.coarse);
    // Bodies with their rest are made once and shared by both instants.
    const auto bodies = responses(settings, list, progress);
    if (!bodies) return bodies.error();
    // A map needs pressures to leave out.
    if (sweep->size() < 3) {
        Reproduction response = response_only(list, *bodies);
        response.warnings = result.warnings;
        return response;
    }
    std::vector<RobotTrial> map, others;
    const std::vector<std::size_t> of_map = pressures_of_map(*sweep);
    for (std::size_t i = 0; i < sweep->size(); ++i)
        (std::find(of_map.begin(), of_map.end(), i) != of_map.end() ? map : others).push_back((*sweep)[i]);
    // Recordings that no map has seen: further pressures of the sweep, then the step trials.
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
            run_arm_static};
}

}  // namespace myo::reproduce
