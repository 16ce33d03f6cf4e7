#include "setup/held_nodes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "setup/setup.hpp"
#include "support/experiment_folder.hpp"
#include "support/setup_of_folder.hpp"

// [[support]]: from the declaration to the nodes, and what is said of supports that do not hold.

namespace myo::setup {
namespace {

using testing::HasSubstr;
using testing_support::replaced;

/// A beam of 100 x 20 x 20 mm on a hinge and on a roller along x, each a line in its lower face.
const char* const bridge_toml = R"(schema = "experiment/1"
name = "bridge"

[geometry]
kind = "box"
size_m = [0.1, 0.02, 0.02]

[[support]]
box_m = [[0.0, -0.001, 0.0], [0.0, 0.021, 0.0]]

[[support]]
box_m = [[0.1, -0.001, 0.0], [0.1, 0.021, 0.0]]
held = ["y", "z"]

[material]
model = "neo_hookean"
youngs_modulus_Pa = 1.0e5
poissons_ratio = 0.45
density_kg_m3 = 1000
damping_s = 0.003

[markers]
[markers.probe_m]
middle = [0.05, 0.01, 0.02]

[[trial]]
name = "sag"
role = "simulate"
duration_s = 0.1
start = "straight"
)";

Result<experiment::Experiment> read(const std::string& toml) {
    const test::Folder folder("bridge");
    folder.write("experiment.toml", toml);
    return experiment::read_experiment(folder.path());
}

setup::Setup prepared(const std::string& toml) {
    const test::Folder folder("bridge");
    folder.write("experiment.toml", toml);
    SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    return test::setup_of_folder(folder, settings);
}

TEST(Support, HoldsTheNodesInItsBoxAlongItsAxes) {
    const setup::Setup setup = prepared(bridge_toml);
    const model::Body& body = *setup.body;
    int clamped = 0;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) {
            ++clamped;
            EXPECT_NEAR(body.mesh.nodes(0, i), 0.0, 1e-9);
            EXPECT_NEAR(body.mesh.nodes(2, i), 0.0, 1e-9);
        }
    EXPECT_EQ(clamped, 3);
    ASSERT_EQ(body.guided.size(), 3u);
    for (const model::GuidedNode& node : body.guided) {
        EXPECT_NEAR(body.mesh.nodes(0, node.node), 0.1, 1e-9);
        EXPECT_EQ(node.held, (std::array<bool, 3>{false, true, true}));
    }
    EXPECT_EQ(check::check_support({setup}).front().level, check::CheckLevel::passed);
}

TEST(Support, AddsToTheClamp) {
    const std::string clamp = "[clamp]\nbox_m = [[-0.001, -0.001, -0.001], [0.0005, 0.021, 0.021]]\n\n[material]";
    const setup::Setup setup = prepared(replaced(bridge_toml, "[material]", clamp));
    EXPECT_EQ(std::count(setup.body->clamped.begin(), setup.body->clamped.end(), true), 9);
    EXPECT_EQ(setup.body->guided.size(), 3u);
}

TEST(Support, ThatLeavesAMotionIsNamedByTheCheck) {
    const setup::Setup rolls = prepared(
        replaced(bridge_toml, "0.0]]\n\n[[support]]", "0.0]]\nheld = [\"y\", \"z\"]\n\n[[support]]"));
    const check::Finding moves = check::check_support({rolls}).front();
    EXPECT_EQ(moves.level, check::CheckLevel::wrong);
    EXPECT_THAT(moves.sentence, HasSubstr("free to move along x"));
    const setup::Setup turns = prepared(replaced(bridge_toml, "held = [\"y\", \"z\"]", "held = [\"y\"]"));
    const check::Finding turning = check::check_support({turns}).front();
    EXPECT_EQ(turning.level, check::CheckLevel::wrong);
    EXPECT_THAT(turning.sentence, HasSubstr("free to turn about y"));
}

TEST(Support, OfABodyThatOnlyAnObstacleBearsIsThatObstacle) {
    const std::string
        table = "[[obstacle]]\nkind = \"plane\"\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nfriction = 0.5\n\n";
    const std::string toml = bridge_toml;
    const std::size_t first = toml.find("[[support]]"), end = toml.find("[material]");
    const setup::Setup lying = prepared(toml.substr(0, first) + table + toml.substr(end));
    const std::vector<check::Finding> found = check::check_support({lying});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].level, check::CheckLevel::passed);
    EXPECT_THAT(found[0].sentence, HasSubstr("obstacles bear the body"));
    EXPECT_TRUE(check::check_pose({lying}).empty());
}

TEST(Support, RefusesWhatHoldsNothingOrEverything) {
    const auto error = [](const std::string& toml) {
        const Result<experiment::Experiment> result = read(toml);
        EXPECT_FALSE(result);
        return result ? std::string() : result.error().text();
    };
    EXPECT_THAT(error(replaced(bridge_toml, "held = [\"y\", \"z\"]", "held = []")), HasSubstr("names no axis"));
    EXPECT_THAT(error(replaced(bridge_toml, "held = [\"y\", \"z\"]", "held = [\"w\"]")), HasSubstr("\"w\" is no axis"));
    EXPECT_THAT(error(replaced(bridge_toml, "held = [\"y\", \"z\"]", "held = [\"y\", \"y\"]")), HasSubstr("twice"));
    EXPECT_THAT(error(replaced(bridge_toml, "[[0.1, -0.001, 0.0], [0.1, 0.021, 0.0]]",
                               "[[0.2, -0.001, 0.0], [0.2, 0.021, 0.0]]")),
                HasSubstr("support[1].box_m: the box contains no material"));
    EXPECT_THAT(error(replaced(bridge_toml, "[[0.0, -0.001, 0.0], [0.0, 0.021, 0.0]]",
                               "[[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]")),
                HasSubstr("holds the whole body"));
}

/// The support that leaves nothing free is named, alone or after the others.
TEST(Support, ThatHoldsTheRestOfTheBodyIsNamed) {
    const std::string roller = "[[0.1, -0.001, 0.0], [0.1, 0.021, 0.0]]\nheld = [\"y\", \"z\"]";
    const Result<experiment::Experiment> whole = read(
        replaced(bridge_toml, roller, "[[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]"));
    ASSERT_FALSE(whole);
    EXPECT_THAT(whole.error().what, HasSubstr("support[1].box_m: holds the whole body"));
    const std::string half = replaced(bridge_toml, "[[0.0, -0.001, 0.0], [0.0, 0.021, 0.0]]",
                                      "[[-1.0, -1.0, -1.0], [0.05, 1.0, 1.0]]");
    const Result<experiment::Experiment> halves = read(replaced(half, roller, "[[0.05, -1.0, -1.0], [1.0, 1.0, 1.0]]"));
    ASSERT_TRUE(halves) << halves.error().text();
    SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    const Result<setup::Setup> held = prepare_setup(*halves, settings);
    ASSERT_FALSE(held);
    EXPECT_THAT(held.error().what, HasSubstr("support[1].box_m: holds the whole body"));
}

}  // namespace
}  // namespace myo::setup
