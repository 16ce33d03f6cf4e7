#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/import_drawing.hpp"
#include "commands/scene_at_time.hpp"
#include "commands/setup_drawing.hpp"
#include "commands/support_drawing.hpp"
#include "fibre/cell_paint.hpp"
#include "mesh/box_mesh.hpp"

// Supports, parts and the markers of an import, as they are drawn.

namespace myo::ui::scene_drawing {
namespace {

using Eigen::Vector3d;
using viewport::color_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Box body_box{{0.0, 0.0, 0.0}, {3.0, 4.0, 12.0}};  // its diagonal is 13

struct DrawnBody {
    commands::Scene scene;
    commands::WorkbenchState state;
    viewport::DrawnScene drawn;
    const platform::Theme theme = platform::make_theme(platform::ThemeName::dark, 1.0f);

    DrawnBody() { scene.surface = mesh::box_surface(body_box); }
    void publish() { state.scene = std::make_shared<const commands::Scene>(scene); }
};

TEST(SupportDrawing, HasABarWithStopsForEachHeldAxis) {
    for (const std::array<bool, 3>& held :
         {std::array{false, false, false}, std::array{true, false, false}, std::array{false, true, true}}) {
        DrawnBody body;
        // The box reaches far beyond the body; its mark is in the middle of what it holds of it.
        body.scene.supports = {{{{-50.0, -50.0, 6.0}, {50.0, 50.0, 50.0}}, held}};
        body.publish();
        commands::add_supports(body.drawn, body.state, body.theme);
        const Vector3d middle(1.5, 2.0, 9.0);
        std::size_t bars = 0;
        for (std::size_t i = 12; i < body.drawn.lines.size(); ++i) {
            const Eigen::Matrix3Xd& points = body.drawn.lines[i].points;
            const Vector3d along = points.col(1) - points.col(0), at = points.rowwise().mean();
            if ((at - middle).norm() > 1e-9) {
                EXPECT_NEAR(along.norm(), 2.0 * 0.02 * 13.0, 1e-12) << "a stop";
                continue;
            }
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(along(axis)) > 1e-9) {
                    EXPECT_TRUE(held[static_cast<std::size_t>(axis)]) << axis;
                }
            EXPECT_NEAR(along.norm(), 2.0 * 0.06 * 13.0, 1e-12);
            ++bars;
        }
        const auto axes = static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
        EXPECT_EQ(bars, axes);
        EXPECT_EQ(body.drawn.lines.size(), 12u + 5u * axes) << "the box, and two stops at each end";
    }
}

TEST(SupportDrawing, HighlightsTheOneThatIsEdited) {
    DrawnBody body;
    body.scene.supports.resize(2);
    body.publish();
    body.state.view.edited = "support/more/1";
    commands::add_supports(body.drawn, body.state, body.theme);
    ASSERT_EQ(body.drawn.lines.size(), 24u);
    EXPECT_EQ(body.drawn.lines[0].color, color_of(body.theme.muted, 0.9f));
    EXPECT_EQ(body.drawn.lines[12].color, color_of(body.theme.accent));
    EXPECT_GT(body.drawn.lines[12].width, body.drawn.lines[0].width);
}

TEST(PartDrawing, ColoursFollowThoseOfMusclesAndOfActuatorsThatAreDeclaredNow) {
    DrawnBody body;
    body.scene.parts.resize(2);
    for (commands::ScenePart& part : body.scene.parts) part.box_m = body_box;
    body.scene.parts[0].name = "core";
    body.scene.parts[1].name = "tip";
    body.publish();
    body.state.settings.muscles.resize(1);
    // A thread that was added after meshing; the mesh does not know it.
    body.state.body = std::make_shared<commands::MeshedBody>();
    body.state.actuators.tendons.resize(1);
    commands::add_setup(body.drawn, body.state, body.theme, {});
    ASSERT_EQ(body.drawn.labels.size(), 2u);
    EXPECT_EQ(body.drawn.labels[0].text, "core");
    EXPECT_EQ(body.drawn.labels[0].color, color_of(body.theme.muscle(2))) << "after the muscle and the thread";
    EXPECT_EQ(body.drawn.labels[1].color, color_of(body.theme.muscle(3)));
    EXPECT_EQ(body.drawn.labels[0].position, Vector3d(1.5, 4.0, 12.0)) << "above the middle of its upper edge";
    body.drawn = {};
    body.state.view.obstacles = false;
    commands::add_setup(body.drawn, body.state, body.theme, {});
    EXPECT_TRUE(body.drawn.labels.empty());
}

TEST(PartDrawing, ACellBelongsToTheLastPartThatHoldsItsMiddle) {
    DrawnBody body;
    auto meshed = std::make_shared<commands::MeshedBody>();
    meshed->mesh = mesh::box_hex_mesh({{0, 0, 0}, {4, 1, 1}}, {4, 1, 1});
    body.state.body = meshed;
    body.publish();
    EXPECT_TRUE(commands::part_of_cell(body.state).empty()) << "there are no parts";
    body.scene.parts.resize(3);
    body.scene.parts[0].box_m = Box{{0, 0, 0}, {2.4, 1, 1}};
    body.scene.parts[2].box_m = Box{{1.5, 0, 0}, {2.4, 1, 1}};
    body.publish();
    // Middles at 0.5, 1.5, 2.5 and 3.5; the second one lies on the face of the third part.
    EXPECT_EQ(commands::part_of_cell(body.state), (std::vector<int>{0, 2, -1, -1}));
    body.state.body.reset();
    EXPECT_TRUE(commands::part_of_cell(body.state).empty());
}

/// A part without a box has what the shares say; during a stroke, what the brush leaves of it.
TEST(PartDrawing, ACellShowsThePartThatHoldsHalfOfItOrIsPaintedThere) {
    DrawnBody body;
    auto meshed = std::make_shared<commands::MeshedBody>();
    meshed->mesh = mesh::box_hex_mesh({{0, 0, 0}, {4, 1, 1}}, {4, 1, 1});
    meshed->boundary = mesh::boundary_faces(meshed->mesh);
    body.state.body = meshed;
    body.scene.parts.resize(1);
    body.scene.parts[0].name = "spine";
    body.scene.parts[0].youngs_modulus_Pa = 2e6;
    body.publish();
    EXPECT_EQ(commands::part_of_cell(body.state), (std::vector<int>{-1, -1, -1, -1})) << "shares of another mesh";
    body.state.part_shares.resize(4, 2);
    body.state.part_shares << 0.0, 1.0, 0.5, 0.5, 0.6, 0.4, 1.0, 0.0;
    commands::MotionSummary motion;
    motion.part_of_cell = commands::part_of_cell(body.state);
    EXPECT_EQ(motion.part_of_cell, (std::vector<int>{0, 0, -1, -1}));
    const auto tinted = [&](const fibre::CellPaint* live) {
        body.drawn = {};
        body.drawn.body = std::make_shared<viewport::DrawnBody>(viewport::DrawnBody{meshed->boundary, {}});
        commands::add_setup(body.drawn, body.state, body.theme, motion, live);
        std::vector<bool> cells(4, false);
        for (Eigen::Index f = 0; f < meshed->boundary.count(); ++f)
            if (body.drawn.tints(3, f) > 0.0f) cells[static_cast<std::size_t>(meshed->boundary.cell(f))] = true;
        return cells;
    };
    EXPECT_EQ(tinted(nullptr), (std::vector<bool>{true, true, false, false}));
    ASSERT_EQ(body.drawn.legend.size(), 2u);
    EXPECT_EQ(body.drawn.legend[1].text, "spine 2 MPa");
    EXPECT_EQ(body.drawn.legend[1].color, color_of(body.theme.muscle(0)));
    fibre::CellPaint live = fibre::blank_paint(meshed->mesh);
    live.weights << 0.0, 1.0, 1.0, 0.0;
    body.state.brush.part = 0;
    EXPECT_EQ(tinted(&live), (std::vector<bool>{false, true, true, false}));
}

TEST(LoadDrawing, PointsAreThoseInTheBoxAtRest) {
    DrawnBody body;
    EXPECT_TRUE(commands::loaded_points(body.state).empty()) << "nothing is open";
    body.scene.trials.resize(1);
    body.scene.trials[0].loads.resize(2);
    body.scene.trials[0].loads[0].box_m = Box{{0, 0, 12}, {3, 4, 12}};
    body.scene.trials[0].loads[1].box_m = Box{{0.1, 0, 0}, {2.9, 4, 12}};
    body.publish();
    const auto loaded = commands::loaded_points(body.state);
    ASSERT_EQ(loaded.size(), 2u);
    EXPECT_EQ(loaded[0].size(), 4u) << "the corners of the upper side, boundary included";
    EXPECT_TRUE(loaded[1].empty());
}

TEST(ImportDrawing, PlacesLabelsAsTheChoicesSayAtTheShownTime) {
    DrawnBody body;
    auto recording = std::make_shared<measurement::Recording>();
    recording->time_s = Eigen::Vector3d(10.0, 11.0, 12.0);
    recording->labels = {"L0", "L1"};
    Eigen::Matrix3Xd track(3, 3);
    track << 1, 2, 3, 0, 0, 0, 0, 0, 0;
    recording->tracks = {track, 2.0 * track};
    auto import = std::make_shared<commands::RecordingImport>();
    import->file.recording = recording;
    import->choices.start_s = 10.25;
    import->choices.markers.resize(2);
    import->choices.markers[1].name = "tip";
    import->declared = {{"tip", { 9.0, 0.0, 0.0 }}, { "middle", { 4.0, 0.0, 0.0 } }};
    import->view.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x of the cameras points along y
    import->view.translation_m = Vector3d(0.0, 0.0, 5.0);
    import->view.before_m = Eigen::Matrix3Xd::Constant(3, 2, 7.0);
    import->view.target_m = Eigen::Matrix3Xd::Constant(3, 2, nan);
    import->view.target_m.col(1) = Vector3d(9.0, 0.0, 0.0);
    body.state.import = import;
    body.state.time_s = 0.25;  // half-way between the first two samples
    commands::add_import(body.drawn, body.state, body.theme);
    const std::vector<viewport::DrawnMarker>& markers = body.drawn.markers;
    ASSERT_EQ(markers.size(), 4u);
    // A ring where a click assigns a label, as none has this marker.
    EXPECT_TRUE(markers[0].ring);
    EXPECT_EQ(markers[0].label, "middle");
    EXPECT_EQ(markers[0].position, Vector3d(4.0, 0.0, 0.0));
    EXPECT_LT((markers[1].position - Vector3d(0.0, 1.5, 5.0)).norm(), 1e-12);
    EXPECT_EQ(markers[1].label, "L0");
    EXPECT_EQ(markers[1].color, color_of(body.theme.accent)) << "it is selected";
    EXPECT_LT((markers[2].position - Vector3d(0.0, 3.0, 5.0)).norm(), 1e-12);
    EXPECT_EQ(markers[2].label, "tip") << "its new name";
    EXPECT_EQ(markers[2].color, color_of(body.theme.measured));
    EXPECT_TRUE(markers[3].ring) << "where the marker is at rest";
    EXPECT_EQ(markers[3].position, Vector3d(9.0, 0.0, 0.0));
    ASSERT_EQ(body.drawn.lines.size(), 1u) << "only one label has a place to go to";
    EXPECT_EQ(body.drawn.lines[0].points.col(0), Vector3d::Constant(7.0));
    EXPECT_EQ(body.drawn.lines[0].points.col(1), Vector3d(9.0, 0.0, 0.0));
    for (const viewport::DrawnMarker& marker : markers) EXPECT_EQ(marker.number, -1) << "clicks assign, not choose";
}

}  // namespace
}  // namespace myo::ui::scene_drawing
