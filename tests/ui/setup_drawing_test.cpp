#include <gtest/gtest.h>

#include <algorithm>

#include "commands/actuator_drawing.hpp"
#include "commands/body_cut.hpp"
#include "commands/scene_at_time.hpp"
#include "ui/driver.hpp"

// What the view shows around the body: obstacles, parts, loads and gravity.

namespace myo::ui {
namespace {

using test::Driver;

/// State of the opened beam, 0.1 x 0.03 x 0.03 m, with another scene.
struct DrawnBeam {
    Driver driver;
    commands::WorkbenchState state;
    commands::Scene scene;

    DrawnBeam() {
        driver.open_beam();
        state = driver.state();
        scene = *state.scene;
        scene.obstacles = {{commands::ScenePlane{{0.0, 0.0, -0.012}, Eigen::Vector3d::UnitZ()}},
                           {commands::SceneSphere{{0.05, 0.0, -0.03}, 0.02}},
                           {Box{{0.0, 0.0, -0.03}, {0.02, 0.02, -0.02}}}};
        scene.parts.resize(1);
        scene.parts[0].name = "tip";
        scene.parts[0].box_m = Box{{0.05, -0.01, -0.01}, {0.11, 0.04, 0.04}};
        commands::SceneLoad force, mass;
        force.box_m = mass.box_m = Box{{0.099, -0.01, -0.01}, {0.101, 0.04, 0.04}};
        force.force_N = {0.0, 0.0, -0.25};
        mass.is_mass = true;
        mass.mass_kg = 0.012;
        scene.trials[0].loads = {force, mass};
        scene.gravity_m_s2 = {0.0, 0.0, -9.81};
    }
    viewport::DrawnScene drawn() {
        state.scene = std::make_shared<const commands::Scene>(scene);
        commands::MotionSummary motion = commands::summarize_motion(state);
        commands::BodyCut().apply(state, motion);
        return commands::scene_at_time(state, platform::make_theme(platform::ThemeName::light, 1.0f), motion);
    }
};

bool has_label(const viewport::DrawnScene& drawn, const std::string& text) {
    return std::any_of(drawn.labels.begin(), drawn.labels.end(),
                       [&](const viewport::DrawnLabel& label) { return label.text == text; });
}

/// Number of lines whose finite points all satisfy a condition.
template <class Condition>
std::ptrdiff_t lines_with(const viewport::DrawnScene& drawn, const Condition& condition) {
    return std::count_if(drawn.lines.begin(), drawn.lines.end(), [&](const viewport::DrawnLine& line) {
        for (const auto& point : line.points.colwise())
            if (point.allFinite() && !condition(Eigen::Vector3d(point))) return false;
        return true;
    });
}

TEST(SetupDrawing, DrawsObstaclesWhereTheyAre) {
    DrawnBeam shown;
    const viewport::DrawnScene drawn = shown.drawn();
    EXPECT_EQ(lines_with(drawn, [](const Eigen::Vector3d& x) { return std::abs(x.z() + 0.012) < 1e-12; }), 2)
        << "grid and edge of the patch of the plane";
    const Eigen::Vector3d centre(0.05, 0.0, -0.03);
    EXPECT_EQ(lines_with(drawn, [&](const Eigen::Vector3d& x) { return std::abs((x - centre).norm() - 0.02) < 1e-9; }),
              1);
    const Box box{{0.0, 0.0, -0.03}, {0.02, 0.02, -0.02}};
    EXPECT_EQ(lines_with(drawn, [&](const Eigen::Vector3d& x) { return box.contains(x); }), 12) << "edges of the box";
    shown.state.view.obstacles = false;
    EXPECT_EQ(lines_with(shown.drawn(), [&](const Eigen::Vector3d& x) { return box.contains(x); }), 0);
}

TEST(SetupDrawing, HighlightsWhatIsEdited) {
    DrawnBeam shown;
    const viewport::Color accent = viewport::color_of(platform::make_theme(platform::ThemeName::light, 1.0f).accent);
    const auto accented = [&](const viewport::DrawnScene& drawn) {
        return std::count_if(drawn.lines.begin(), drawn.lines.end(),
                             [&](const viewport::DrawnLine& line) { return line.color == accent; });
    };
    EXPECT_EQ(accented(shown.drawn()), 0);
    shown.state.view.edited = "obstacle/1";
    EXPECT_EQ(accented(shown.drawn()), 1);
    shown.state.view.edited = "trial/load/0";
    EXPECT_EQ(accented(shown.drawn()), 12) << "the box that carries an opened load";
}

TEST(SetupDrawing, TintsTheElementsOfAPartUnlessAMuscleDoes) {
    DrawnBeam shown;
    const viewport::DrawnScene drawn = shown.drawn();
    const mesh::BoundaryFaces& faces = shown.state.body->boundary;
    ASSERT_EQ(drawn.tints.cols(), faces.count());
    const mesh::VolumeMesh& mesh = shown.state.body->mesh;
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        const double x = mesh.nodes(Eigen::all, mesh.cells.col(faces.cell(f))).row(0).mean();
        EXPECT_EQ(drawn.tints(3, f) > 0.0f, x > 0.05) << f;
    }
    EXPECT_TRUE(has_label(drawn, "tip"));
}

TEST(SetupDrawing, ACutLeavesTheTintOfAChamberOnItsWalls) {
    DrawnBeam shown;
    shown.scene.parts.clear();
    const commands::MeshedBody& body = *shown.state.body;
    const auto x_of = [&](const mesh::BoundaryFaces& faces, Eigen::Index f) {
        return body.mesh.nodes(0, faces.nodes.col(f)).mean();
    };
    // Both ends of the beam are walls; the cut removes one of them.
    commands::ShownChamber chamber;
    for (Eigen::Index f = 0; f < body.boundary.count(); ++f)
        if (const double x = x_of(body.boundary, f); x < 1e-9 || x > 0.1 - 1e-9)
            chamber.walls.push_back(static_cast<int>(f));
    shown.state.actuators.chambers = {chamber};
    shown.state.view.clip = {true, Eigen::Vector3d::UnitX(), 0.05, false};
    auto paint = std::make_shared<fibre::CellPaint>(fibre::blank_paint(body.mesh));
    paint->weights.setOnes();
    paint->directions.row(0).setOnes();
    for (const bool painted : {false, true}) {
        if (painted) shown.state.settings.muscles.resize(1), shown.state.paint = {paint};
        const viewport::DrawnScene drawn = shown.drawn();
        ASSERT_EQ(drawn.tints.cols(), drawn.body->faces.count());
        ASSERT_LT(drawn.tints.cols(), body.boundary.count());
        const viewport::Color color = commands::actuator_color(
            shown.state, platform::make_theme(platform::ThemeName::light, 1.0f), 0);
        int walls = 0;
        for (Eigen::Index f = 0; f < drawn.tints.cols(); ++f) {
            const bool wall = drawn.tints(3, f) > 0.0f && drawn.tints.col(f).head<3>() == color.head<3>();
            EXPECT_EQ(wall, x_of(drawn.body->faces, f) < 1e-9) << f;
            walls += wall ? 1 : 0;
        }
        EXPECT_EQ(2 * static_cast<std::size_t>(walls), chamber.walls.size()) << "one of two equal ends";
    }
}

TEST(SetupDrawing, LoadsFollowTheBodyAndSayHowLargeTheyAre) {
    DrawnBeam shown;
    viewport::DrawnScene drawn = shown.drawn();
    EXPECT_TRUE(has_label(drawn, "0.25 N"));
    EXPECT_TRUE(has_label(drawn, "12 g"));
    EXPECT_TRUE(has_label(drawn, "g 9.81 m/s\xc2\xb2"));
    shown.state.view.loads = false;
    EXPECT_FALSE(has_label(shown.drawn(), "0.25 N"));
    shown.state.view.loads = true;
    const auto place = [&](const viewport::DrawnScene& scene, const std::string& text) {
        for (const viewport::DrawnLabel& label : scene.labels)
            if (label.text == text) return label.position;
        return Eigen::Vector3d(Eigen::Vector3d::Zero());
    };
    const Eigen::Vector3d before = place(drawn, "0.25 N");
    EXPECT_NEAR(before.x(), 0.1, 1e-9) << "at the middle of the loaded end";
    shown.driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(shown.driver.wait_for_job());
    shown.state.run = shown.driver.state().run;
    shown.state.time_s = 0.15;  // half a swing after the release: the tip has sunk
    EXPECT_LT(place(shown.drawn(), "0.25 N").z(), before.z() - 0.005);
}

TEST(SetupDrawing, AForceIsFaintWhenItDoesNotAct) {
    DrawnBeam shown;
    shown.scene.trials[0].loads[0].until_s = 0.1;
    const auto alpha = [&](double time_s) {
        shown.state.time_s = time_s;
        for (const viewport::DrawnLabel& label : shown.drawn().labels)
            if (label.text == "0.25 N") return label.color[3];
        return 0.0f;
    };
    EXPECT_EQ(alpha(0.05), 1.0f);
    EXPECT_LT(alpha(0.2), 0.5f);
    EXPECT_GT(alpha(0.2), 0.0f);
}

}  // namespace
}  // namespace myo::ui
