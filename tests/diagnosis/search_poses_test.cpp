#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/recorded_beam.hpp"
#include "diagnosis/search/beginning_context.hpp"
#include "support/figures.hpp"

// Search on poses of a finger so soft that its declared threads, which run straight, bend it far more than the channels
// that it really has: the declared fit ends at a modulus twice too high.

namespace myo::diagnosis::search_poses_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A hanging finger of 20 x 2 x 2 cm with two threads of two legs each, pulled and held. Markers at rest are recorded.
setup::Setup pulled_finger(const test::Folder& folder) {
    std::string toml = R"(schema = "experiment/1"
name = "pulled finger"
[geometry]
kind = "box"
size_m = [0.02, 0.02, 0.2]
[clamp]
box_m = [[-0.001, -0.001, 0.1995], [0.021, 0.021, 0.2005]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 3.0e5
youngs_modulus_tolerance = 0.6
poissons_ratio = 0.45
density_kg_m3 = 1100
damping_s = 0.003
calibrate = ["youngs_modulus"]
[registration]
known = true
[[tendon]]
name = "left"
path_m = [[0.002, 0.01, 0.2], [0.002, 0.01, 0.1], [0.002, 0.01, 0.0]]
drive = "tension"
[[tendon]]
name = "right"
path_m = [[0.018, 0.01, 0.2], [0.018, 0.01, 0.1], [0.018, 0.01, 0.0]]
drive = "tension"
[markers]
noise_m = 3e-4
[markers.rest_m]
upper = [0.02, 0.01, 0.12]
lower = [0.0, 0.01, 0.06]
tip = [0.01, 0.01, 0.0]
)";
    const auto pose = [&](const std::string& name, const std::string& left, const std::string& right) {
        toml += "[[trial]]\nname = \"" + name +
                "\"\nrole = \"fit\"\ntrace = \"rest.csv\"\nformat = \"csv\"\nhold = true\ntension_N = { left = " +
                left + ", right = " + right + " }\n";
    };
    pose("left 2", "1.75", "0.0");
    pose("left 4", "3.5", "0.0");
    pose("left 7", "7.0", "0.0");
    pose("right 2", "0.0", "2.1");
    pose("right 4", "0.0", "4.2");
    pose("both", "4.9", "2.1");
    std::string text = "time_s,upper_x_m,upper_y_m,upper_z_m,lower_x_m,lower_y_m,lower_z_m,tip_x_m,tip_y_m,tip_z_m\n";
    for (int k = 0; k < 5; ++k) text += "0." + std::to_string(k) + ",0.02,0.01,0.12,0.0,0.01,0.06,0.01,0.01,0.0\n";
    folder.write("experiment.toml", toml);
    folder.write("rest.csv", text);
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    return setup_of_folder(folder, settings);
}

TEST(SearchPoses, FindTheEffectOnTheSmallPosesFirst) {
    const test::Folder folder("search_poses");
    const setup::Setup finger = pulled_finger(folder);
    prediction::ParameterValues truth = prediction::declared_values(finger);
    truth.youngs_modulus_Pa = 2e5;
    truth.effects = {{"tendon_channel", {{"share", 0.5}}, false}};
    const Diagnosis d = diagnose(
        test::recorded(finger, truth),
        test::among({"tendon_channel", "strain_stiffening", "tendon_friction", "clamp_compliance", "cable_tug"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    test::record("modulus of the declared fit, over true", d.declared.fit.values.youngs_modulus_Pa / 2e5);
    EXPECT_GT(d.declared.fit.values.youngs_modulus_Pa, 1.6 * 2e5);
    ASSERT_THAT(test::ids_of(d.verdict.effects), ElementsAre("tendon_channel")) << d.verdict.reason;
    EXPECT_NEAR(effect::number(d.verdict.effects.front().parameters, "share"), 0.5, 0.03);
    EXPECT_NEAR(d.augmented.fit.values.youngs_modulus_Pa, 2e5, 6e3);
    EXPECT_THAT(d.notes, Contains(HasSubstr("on the 2 poses with the smallest motion")));
}

/// A context with four poses, of which the third moves least and the first most; their residuals are 1, 2, 3 and 4.
DiagnosisContext poses() {
    DiagnosisContext context;
    const test::Folder folder("poses");
    context.setup = pulled_finger(folder);
    context.setup.trials.resize(4);
    context.data.trials = {0, 1, 2, 3};
    context.data = fit_data(context.setup, context.data.trials);
    context.declared.fit.residual.resize(context.data.layout.size());
    const double motion_m[] = {0.04, 0.02, 0.01, 0.03};
    for (const double distance : motion_m) {
        prediction::TrialPrediction prediction;
        for (const Eigen::Vector3d& rest :
             {Eigen::Vector3d(0.02, 0.01, 0.12), Eigen::Vector3d(0.0, 0.01, 0.06), Eigen::Vector3d(0.01, 0.01, 0.0)})
            prediction.positions_m.push_back((rest + Eigen::Vector3d(0.0, 0.0, distance)).replicate(1, 5));
        context.declared.fit.predictions.push_back(prediction);
    }
    for (const statistics::ResidualSeries& series : context.data.layout.series)
        context.declared.fit.residual.segment(series.begin, series.end - series.begin).setConstant(series.trial + 1.0);
    return context;
}

TEST(SearchPoses, TheSmallestMotionsComeFirst) {
    DiagnosisContext context = poses();
    EXPECT_NEAR(std::pow(residual_in_beginnings(context, 0.1), 2), (9.0 + 4.0) / 2.0, 1e-9) << "at least two";
    EXPECT_NEAR(std::pow(residual_in_beginnings(context, 0.5), 2), (9.0 + 4.0) / 2.0, 1e-9);
    EXPECT_NEAR(std::pow(residual_in_beginnings(context, 0.75), 2), (9.0 + 4.0 + 16.0) / 3.0, 1e-9);
    EXPECT_NEAR(std::pow(residual_in_beginnings(context, 1.0), 2), 30.0 / 4.0, 1e-9);
    EXPECT_EQ(beginning_words(context, 0.1), "the 2 poses with the smallest motion");
    context.setup.trials[3].hold = false;
    EXPECT_EQ(beginning_words(context, 0.75),
              "the first 75 % of every recording and the 3 poses with the smallest motion");
}

}  // namespace
}  // namespace myo::diagnosis::search_poses_test
