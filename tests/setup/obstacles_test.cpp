#include "setup/obstacles.hpp"

#include <gtest/gtest.h>

#include "dynamics/simulate.hpp"
#include "support/setup_of_folder.hpp"

namespace myo::setup {
namespace {

/// A block on a table, which nothing else holds: it is pushed along by 0.3 of its weight for a tenth of a second.
const char* const lying_toml = R"(schema = "experiment/1"
name = "lying"

[geometry]
kind = "box"
size_m = [0.06, 0.03, 0.02]

[material]
model = "neo_hookean"
youngs_modulus_Pa = 1.0e5
poissons_ratio = 0.45
density_kg_m3 = 1000
damping_s = 0.003
calibrate = ["youngs_modulus"]

[environment]
gravity_m_s2 = [0, 0, -10]

[[obstacle]]
kind = "plane"
point_m = [0, 0, 0]
normal = [0, 0, 1]
friction = FRICTION

[markers]
noise_m = 1e-4
compare = "displacement"
[markers.rest_m]
tip = [0.06, 0.015, 0.01]

[[trial]]
name = "push"
role = "fit"
trace = "push.csv"
format = "csv"
start = "START"
start_s = 0.0
[[trial.load]]
kind = "force"
box_m = [[-0.001, -0.001, -0.001], [0.061, 0.031, 0.021]]
force_N = [0.108, 0.0, 0.0]
from_s = 0.0
)";

/// Mean displacement along x after 0.1 s.
double moved(const std::string& friction, const std::string& start) {
    const test::Folder folder("lying");
    std::string toml = lying_toml;
    toml.replace(toml.find("FRICTION"), 8, friction);
    toml.replace(toml.find("START"), 5, start);
    folder.write("experiment.toml", toml);
    std::string trace = "time_s,tip_x_m,tip_y_m,tip_z_m\n";
    for (int i = 0; i < 10; ++i) trace += "0.0" + std::to_string(i) + ",0,0,0\n";
    folder.write("push.csv", trace);
    SetupSettings settings;
    settings.mesh.element = fem::ElementKind::hex8;
    settings.mesh.resolution_m = 0.01;
    const Setup setup = test::setup_of_folder(folder, settings);
    const PreparedTrial& trial = setup.trials.front();
    dynamics::SimulationOptions options = trial.options;
    options.end_s = 0.1;
    const dynamics::Trace run = dynamics::simulate(trial.model, options);
    EXPECT_TRUE(run.complete()) << run.message;
    if (!run.complete()) return 0.0;
    const Eigen::Matrix3Xd& X = setup.body->mesh.nodes;
    EXPECT_NEAR((run.positions.back() - X).row(2).mean(), 0.0, 5e-4);
    return (run.positions.back() - X).row(0).mean();
}

/// Without friction s = a t^2 / 2 with a = 3 m/s2; with more friction than the push it stays.
TEST(Obstacles, BearABodyWithoutAClamp) {
    for (const char* start : {"straight", "equilibrium"}) {
        EXPECT_NEAR(moved("0.0", start), 0.015, 0.015 * 0.02) << start;
        EXPECT_LT(moved("0.5", start), 1e-3) << start;
    }
}

}  // namespace
}  // namespace myo::setup
