#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/gradcheck.hpp"
#include "experiment/law_file.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"
#include "support/law_texts.hpp"

namespace myo::calibration {
namespace {

/// A force without potential, on the deformed surface, with a direction and a test condition.
const std::string stream_law = R"law(schema = "law/1"
id = "stream"
sentence = "a stream presses where the surface faces it, up to a soft level"
acts_on = "surface"
conditions = ["share"]
let = ["below = smooth_step((level_m - x.z) / 0.02[m])", "w_m_s = speed_m_s * along - v", "q = dot(w_m_s, n)",
       "pressure = if(q < 0, share * density_kg_m3 * q^2, 0)"]
traction_Pa = "(-pressure * area_ratio * n + 2[Pa s2/m2] * norm(v) * w_m_s) * below"
[[parameter]]
name = "density_kg_m3"
range = [0.0, 1e4]
scale = 300.0
over_decades = true
start = 500.0
[[parameter]]
name = "speed_m_s"
range = [0.0, 50.0]
scale = 0.5
start = 2.0
[[parameter]]
name = "level_m"
range = [-1.0, 1.0]
scale = 0.01
start = 0.02
[[parameter]]
name = "along"
kind = "direction"
scale = 0.3
start = [1.0, 2.0, -1.0]
)law";

effect::EffectDeclaration of_law(const std::string& text, const effect::EffectParameters& parameters) {
    const Result<effect::LawPointer> law = experiment::read_law_text(text, "law.toml");
    EXPECT_TRUE(law) << law.error().text();
    return {(*law)->id, parameters, false, *law};
}

TEST(LawGradients, AgreeWithDifferences) {
    const test::Folder folder("law_gradients");
    const Eigen::VectorXd place = Eigen::Vector3d(0.0995, 0.017, 0.021), anchor = Eigen::Vector3d(0.12, 0.1, 0.2),
                          along = Eigen::Vector3d(1.0, 2.0, -1.0).normalized();
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.trials[0].actuation_steps = {{"upper", 5000.0}};
        for (experiment::TrialDeclaration& trial : e.trials) trial.condition["share"] = 0.7;
        e.effects = {
            of_law(test::drag_law, {{"coefficient_kg_m3", 3000.0}}),
            of_law(test::cable_law, {{"stiffness_N_m", 3.0}, {"position_m", place}, {"anchor_m", anchor}}),
            of_law(stream_law, {{"density_kg_m3", 500.0}, {"speed_m_s", 2.0}, {"level_m", 0.02}, {"along", along}}),
            of_law(test::lag_law, {{"time_constant_s", 0.02}})};
    });
    const TrialGradientCheck run = gradcheck(setup, 0, 3);
    ASSERT_TRUE(run.check.complete()) << run.check.message;
    std::vector<double> errors;
    int rows = 0;
    for (const sensitivity::GradientCheckRow& row : run.check.rows) {
        if (row.name.rfind("effect.own_", 0) != 0 && row.name.rfind("effect.stream", 0) != 0) continue;
        ++rows;
        errors.push_back(row.relative_error);
        // A place behind its face has the nearest point on it.
        if (row.name != "effect.own_cable.position_m.x") {
            EXPECT_NE(row.adjoint, 0.0) << row.name;
            EXPECT_NE(row.adjoint, row.difference) << row.name << ": not independent";
        }
        EXPECT_LE(row.relative_error, 1e-6) << row.name;
    }
    EXPECT_EQ(rows, 14) << "drag 1, cable 7, stream 5, lag 1";
    test::record("relative_errors", errors);
}

}  // namespace
}  // namespace myo::calibration
