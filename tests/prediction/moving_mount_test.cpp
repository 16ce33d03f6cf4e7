#include <gtest/gtest.h>

#include <numbers>

#include "prediction/prediction.hpp"
#include "prediction/trial_target.hpp"
#include "support/experiment_folder.hpp"
#include "support/figures.hpp"
#include "support/swung_beam.hpp"
#include "support/turning_mount.hpp"

namespace myo::prediction {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Vector3d shaken_along = Vector3d(0.3, 0.5, 0.8).normalized();
constexpr double shaken_m = 2e-3, shaken_Hz = 6.0, shaken_rad = 0.7;

effect::EffectDeclaration mount_vibration() {
    return {"base_vibration",
            {{"amplitude_m", shaken_m},
             {"frequency_Hz", shaken_Hz},
             {"direction", VectorXd(shaken_along)},
             {"phase_rad", shaken_rad}},
            false};
}

/// The swung beam with these effects.
setup::Setup vibrated_beam(const test::Folder& folder, const std::vector<effect::EffectDeclaration>& effects,
                           double youngs_modulus_Pa = 2.6e5, double end_s = 0.3) {
    test::swung_beam(folder, end_s);
    Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    experiment->effects = effects;
    experiment->material.youngs_modulus_Pa = youngs_modulus_Pa;
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.03;
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings);
    EXPECT_TRUE(setup) << setup.error().text();
    for (setup::PreparedTrial& trial : setup->trials)
        trial.options.solver.tolerance = trial.options.solver.tangent_tolerance = 1e-10;
    return std::move(*setup);
}

Vector3d mount_place(double t) {
    return shaken_m * std::sin(2.0 * std::numbers::pi * shaken_Hz * t + shaken_rad) * shaken_along;
}

/// A stiff body goes where its mount goes, as the cameras see it.
TEST(MovingMount, CarriesAStiffBody) {
    const test::Folder folder("stiff_on_mount");
    setup::Setup stiff = vibrated_beam(folder, {mount_vibration()}, 1e10, 0.1);
    for (setup::PreparedTrial& trial : stiff.trials) trial.model.gravity_m_s2.setZero();
    const TrialPrediction seen = predict_trial(stiff, 0, declared_values(stiff));
    ASSERT_TRUE(seen.ok()) << seen.message;
    const VectorXd& times = stiff.trials[0].measured.time_s;
    double most = 0.0;
    for (std::size_t m = 0; m < seen.positions_m.size(); ++m)
        for (Eigen::Index t = 0; t < times.size(); ++t)
            most = std::max(
                most, (seen.positions_m[m].col(t) - stiff.experiment.markers.on_body[m].rest_m - mount_place(times(t)))
                          .norm());
    test::record("strain_m", most);
    EXPECT_LT(most, 1e-6);
}

/// Trace of the markers on the body and of four on the mount.
std::string mount_trace(const setup::Setup& setup, const TrialPrediction& seen,
                        const std::map<std::string, Vector3d>& on_mount) {
    std::string text = "time_s";
    for (const std::string& name : setup.marker_names)
        for (const char axis : {'x', 'y', 'z'}) text += "," + name + "_" + axis + "_m";
    for (const auto& [name, place] : on_mount)
        for (const char axis : {'x', 'y', 'z'}) text += "," + name + "_" + axis + "_m";
    const VectorXd& times = setup.trials[0].measured.time_s;
    for (Eigen::Index t = 0; t < times.size(); ++t) {
        char number[64];
        std::snprintf(number, sizeof number, "\n%.4f", times(t));
        text += number;
        const auto add = [&](const Vector3d& p) {
            std::snprintf(number, sizeof number, ",%.12g,%.12g,%.12g", p.x(), p.y(), p.z());
            text += number;
        };
        for (const Matrix3Xd& track : seen.positions_m) add(track.col(t));
        for (const auto& [name, place] : on_mount) add(place + mount_place(times(t)));
    }
    return text + "\n";
}

/// What the effect says of the mount, its markers say as well: the recording alone explains the motion.
TEST(MovingMount, MovesAsItsMarkersWereSeenTo) {
    const test::Folder folder("recorded_mount");
    const setup::Setup vibrated = vibrated_beam(folder, {mount_vibration()});
    const TrialPrediction truth = predict_trial(vibrated, 0, declared_values(vibrated));
    ASSERT_TRUE(truth.ok()) << truth.message;
    const std::map<std::string, Vector3d> on_mount{{"base_1", {-0.02, 0.0, 0.0}},
                                                   {"base_2", {-0.02, 0.05, 0.0}},
                                                   {"base_3", {-0.03, 0.0, 0.05}},
                                                   {"base_4", {-0.06, 0.03, 0.04}}};
    std::string fixed = "[markers.fixed_m]\n";
    for (const auto& [name, place] : on_mount)
        fixed += name + " = [" + std::to_string(place.x()) + ", " + std::to_string(place.y()) + ", " +
                 std::to_string(place.z()) + "]\n";
    folder.write("swing.csv", mount_trace(vibrated, truth, on_mount));
    const auto rms_of = [&](const std::string& motion) {
        folder.write("experiment.toml",
                     testing_support::replaced(test::swung_beam_toml(), "[[trial]]",
                                               fixed + "[mount]\nmotion = \"" + motion + "\"\n[[trial]]"));
        setup::SetupSettings settings;
        settings.mesh.resolution_m = 0.03;
        const setup::Setup setup = test::setup_of_folder(folder, settings);
        EXPECT_EQ(setup.trials[0].mount != nullptr, motion == "markers");
        const TrialPrediction seen = predict_trial(setup, 0, declared_values(setup));
        EXPECT_TRUE(seen.ok()) << seen.message;
        return rms(seen.residual_m);
    };
    const double with = rms_of("markers"), without = rms_of("fixed");
    test::record("rms_m", {with, without});
    EXPECT_LT(with, 1.5e-5);
    EXPECT_GT(without, 1e-3);
}

/// Relative errors of the tangents of the residuals against differences.
std::vector<double> tangent_errors(const setup::Setup& setup, const std::vector<ModelParameter>& parameters) {
    const ParameterValues values = declared_values(setup);
    const TrialPrediction here = predict_trial(setup, 0, values, parameters);
    EXPECT_TRUE(here.ok()) << here.message;
    std::vector<double> errors;
    for (std::size_t p = 0; p < parameters.size() && here.ok(); ++p) {
        const auto difference = [&](double step) {
            const auto at = [&](double side) {
                ParameterValues changed = values;
                set_value(parameters[p], value_of(parameters[p], values) + side * step, changed);
                return predict_trial(setup, 0, changed).residual_m;
            };
            const std::vector<Matrix3Xd> over = at(1.0), under = at(-1.0);
            Matrix3Xd all(3, 0);
            for (std::size_t m = 0; m < over.size(); ++m) {
                all.conservativeResize(3, all.cols() + over[m].cols());
                all.rightCols(over[m].cols()) = (over[m] - under[m]) / (2.0 * step);
            }
            return all;
        };
        const double size = parameters[p].parameter.over_decades ? std::max(std::abs(value_of(parameters[p], values)),
                                                                            0.05 * parameters[p].parameter.scale)
                                                                 : parameters[p].parameter.scale;
        const Matrix3Xd expected = (4.0 * difference(5e-3 * size) - difference(1e-2 * size)) / 3.0;
        Matrix3Xd found(3, 0);
        for (const Matrix3Xd& marker : here.tangents[p]) {
            found.conservativeResize(3, found.cols() + marker.cols());
            found.rightCols(marker.cols()) = marker;
        }
        EXPECT_GT(expected.norm(), 0.0) << parameters[p].parameter.name;
        errors.push_back((found - expected).norm() / expected.norm());
        EXPECT_LT(errors.back(), 1e-5) << parameters[p].parameter.name;
    }
    std::vector<double> sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_LE(sorted[sorted.size() / 2], 1e-6);
    return errors;
}

/// By the material and by every number of the effect, which moves what is seen and what is felt.
TEST(MovingMount, HasTheTangentsOfItsVibration) {
    const test::Folder folder("vibration_tangents");
    const setup::Setup setup = vibrated_beam(folder, {mount_vibration()}, 2.6e5, 0.15);
    std::vector<ModelParameter> parameters = free_parameters(setup, {"youngs_modulus", "damping"});
    for (const ModelParameter& p : effect_parameters(setup, setup.experiment.effects[0], 0)) parameters.push_back(p);
    ASSERT_EQ(parameters.size(), 7u);
    test::record("relative_errors", tangent_errors(setup, parameters));
}

/// A mount that turns, in air, on an elastic bed: what is fixed in the laboratory is seen from the mount.
TEST(MovingMount, HasTheTangentsOfOtherEffectsWhereItTurns) {
    const test::Folder folder("turning_tangents");
    setup::Setup setup = vibrated_beam(
        folder,
        {{"quadratic_drag", {{"coefficient_kg_m3", 500.0}}, false},
         {"point_mass", {{"mass_kg", 0.02}, {"position_m", VectorXd(Vector3d(0.1, 0.015, 0.03))}}, false},
         {"clamp_compliance", {{"stiffness_Pa_per_m", 3e7}}, false}},
        2.6e5, 0.1);
    setup.trials[0].mount = test::tumbling_mount();
    std::vector<ModelParameter> parameters = free_parameters(setup, {"youngs_modulus", "damping"});
    for (std::size_t e = 0; e < 3; ++e)
        parameters.push_back(effect_parameters(setup, setup.experiment.effects[e], e)[0]);
    test::record("relative_errors", tangent_errors(setup, parameters));
    // Targets seen from the mount are as far from the motion as the recording is in the laboratory.
    const ParameterValues values = declared_values(setup);
    const TrialPrediction seen = predict_trial(setup, 0, values);
    const inverse::MarkerTarget target = trial_target(setup, 0, 1.0);
    sensitivity::NodeMotion motion;
    motion.times_s = seen.trace.times_s;
    for (std::size_t k = 0; k < seen.trace.times_s.size(); ++k) {
        motion.positions.push_back(seen.trace.positions[k](Eigen::all, target.markers.nodes));
        motion.velocities.push_back(seen.trace.velocities[k](Eigen::all, target.markers.nodes));
    }
    const std::vector<Matrix3Xd> from_mount = inverse::target_residuals(target, motion);
    for (std::size_t m = 0; m < from_mount.size(); ++m)
        EXPECT_LT((from_mount[m].colwise().norm() - seen.residual_m[m].colwise().norm()).norm(), 1e-9);
    const TrialPrediction again = prediction_of(setup, 0, motion);
    EXPECT_LT((again.positions_m[0] - seen.positions_m[0]).norm(), 1e-9);
}

}  // namespace
}  // namespace myo::prediction
