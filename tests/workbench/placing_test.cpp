#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/example_copy.hpp"

// Places of the declaration are set by clicks on the body: markers and probes, the support, loads, tendons, chambers.

namespace myo {
namespace {

using Eigen::Vector3d;
using test::Driver;
using test::pixel_of;
using testing::HasSubstr;
using ui::commands::Undo;

/// A window with a copy of a bundled example, or with an experiment made of a bar of 80 x 20 x 20 mm.
struct PlacingWindow {
    test::Folder folder;
    Driver driver;

    explicit PlacingWindow(const std::string& name) : folder(name), driver(backend::make_core_backend(), 1280, 1800) {}

    void open(const std::filesystem::path& path) {
        driver.window->open(path);
        ASSERT_TRUE(driver.wait_for_job(60));
        ASSERT_TRUE(driver.state().body) << driver.state().log.back().text;
    }
    void open_example(const std::string& name) { open(test::example_copy(folder, name)); }
    void open_bar() {
        ASSERT_TRUE(mesh::write_stl(folder.path() / "bar.stl",
                                    mesh::box_surface(Box{{0.0, 0.0, 0.0}, {0.08, 0.02, 0.02}}), 1.0));
        driver.workbench->execute(ui::commands::Open{folder.path() / "bar.stl", 1.0});
        ASSERT_TRUE(driver.wait_for_job(60));
        driver.workbench->execute(ui::commands::MakeExperiment{folder.path() / "bar"});
        ASSERT_TRUE(driver.wait_for_job(60));
        ui::commands::Settings coarse = driver.state().settings;
        coarse.resolution_m = 0.01;
        driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
        driver.workbench->execute(ui::commands::BuildMesh{});
        ASSERT_TRUE(driver.wait_for_job(60));
        ASSERT_TRUE(driver.state().body);
    }
    void show(const std::string& panel) {
        driver.window->show_panel(panel);
        driver.settle();
    }
    void run() {
        driver.workbench->execute(ui::commands::Run{});
        ASSERT_TRUE(driver.wait_for_job(120));
        ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
        ASSERT_TRUE(driver.state().run->problem.empty()) << driver.state().run->problem;
    }
    const ui::commands::Scene& scene() const { return *driver.state().scene; }
};

TEST(PlacingInWindow, AProbeIsClickedOntoTheBodyAndItsMotionIsPlottedWithoutARecording) {
    PlacingWindow window("placing_probe");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("probe");
    driver.click("probe/place");
    const Vector3d top(0.06, 0.012, 0.02);
    driver.click_at(pixel_of(driver, top));
    ASSERT_EQ(window.scene().markers.size(), 1u) << driver.state().refused;
    EXPECT_EQ(window.scene().markers[0].name, "m1");
    EXPECT_LT((window.scene().markers[0].rest_m - top).norm(), 5e-4);
    EXPECT_NEAR(window.scene().markers[0].rest_m.z(), 0.02, 1e-9);
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("view/placing_hint"));
    EXPECT_TRUE(driver.has("markers/not_run"));
    ASSERT_NO_FATAL_FAILURE(window.run());
    const Eigen::Matrix3Xd& track = driver.state().simulated_trial()->markers.at(0);
    EXPECT_LT(track(2, track.cols() - 1), 0.019) << "it falls with the bar";
    EXPECT_FALSE(driver.has("markers/not_run"));
    EXPECT_TRUE(driver.has("plot/z"));
    EXPECT_FALSE(driver.has("residual/z")) << "nothing to compare with";
    driver.workbench->execute(Undo{});
    EXPECT_TRUE(window.scene().markers.empty());
}

TEST(PlacingInWindow, MarkersAreDraggedRenamedAndRemovedWithOneUndoStepEach) {
    PlacingWindow window("placing_drag");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("probe");
    driver.click("probe/place");
    const Vector3d from(0.04, 0.01, 0.02), to(0.065, 0.008, 0.02);
    driver.click_at(pixel_of(driver, from));
    driver.click_at(pixel_of(driver, {0.075, 0.01, 0.02}));
    ASSERT_EQ(window.scene().markers.size(), 2u);
    const auto before = window.scene().markers[0].rest_m;
    driver.drag(pixel_of(driver, before), pixel_of(driver, to));
    EXPECT_LT((window.scene().markers[0].rest_m - to).norm(), 5e-4) << driver.state().refused;
    EXPECT_EQ(driver.state().marker, 0);
    driver.workbench->execute(Undo{});
    EXPECT_EQ(window.scene().markers[0].rest_m, before) << "one step per drag";
    ASSERT_EQ(window.scene().markers.size(), 2u);
    // A click on a marker selects it and adds none.
    driver.click_at(pixel_of(driver, window.scene().markers[1].rest_m));
    EXPECT_EQ(window.scene().markers.size(), 2u);
    EXPECT_EQ(driver.state().marker, 1);
    driver.key(ImGuiKey_Delete);
    ASSERT_EQ(window.scene().markers.size(), 1u);
    EXPECT_EQ(window.scene().markers[0].name, "m1");
    driver.click("probe/name");
    driver.key(ImGuiKey_End);
    driver.type("_tip");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(window.scene().markers[0].name, "m1_tip") << driver.state().refused;
}

TEST(PlacingInWindow, ADraggedMarkerIsSeenWhereItIsHeldAndEscapePutsItBack) {
    PlacingWindow window("placing_held");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("probe");
    driver.click("probe/place");
    driver.click_at(pixel_of(driver, {0.04, 0.01, 0.02}));
    const Vector3d before = window.scene().markers.at(0).rest_m, to(0.06, 0.01, 0.02);
    const ImVec2 start = pixel_of(driver, before), end = pixel_of(driver, to);
    driver.window->input().push(ui::platform::MouseMoved{start.x, start.y});
    driver.window->input().push(ui::platform::MouseButton{0, true, {}});
    driver.settle();
    driver.window->input().push(ui::platform::MouseMoved{end.x, end.y});
    driver.settle();
    ASSERT_EQ(driver.window->scene().markers.size(), 1u);
    EXPECT_LT((driver.window->scene().markers[0].position - to).norm(), 5e-4);
    EXPECT_EQ(window.scene().markers[0].rest_m, before) << "declared at the release only";
    driver.key(ImGuiKey_Escape);
    driver.window->input().push(ui::platform::MouseButton{0, false, {}});
    driver.settle();
    EXPECT_EQ(window.scene().markers[0].rest_m, before);
    EXPECT_TRUE(driver.has("view/placing_hint")) << "the first Escape ends the drag only";
}

TEST(PlacingInWindow, BesideRecordingsAProbeIsAddedAndTrialsStayAsTheyAre) {
    PlacingWindow window("placing_recorded");
    ASSERT_NO_FATAL_FAILURE(window.open_example("silicone_beam"));
    Driver& driver = window.driver;
    const std::size_t count = window.scene().markers.size();
    window.show("probe");
    driver.click("probe/place");
    driver.click("probe/next");
    driver.type("elbow");
    driver.click_at(pixel_of(driver, {0.09, 0.015, 0.02}));
    ASSERT_EQ(window.scene().markers.size(), count + 1) << driver.state().refused;
    EXPECT_EQ(window.scene().markers.back().name, "elbow");
    EXPECT_TRUE(window.scene().markers.back().probe);
    EXPECT_EQ(driver.state().marker, static_cast<int>(count));
    // No recording holds it, so that it cannot be one of the recorded markers.
    driver.click("probe/recorded");
    EXPECT_THAT(driver.state().refused, HasSubstr("elbow"));
    EXPECT_TRUE(window.scene().markers.back().probe);
    driver.key(ImGuiKey_Escape);
    // A recorded marker keeps its label under a new name.
    driver.click("probe/list/mid_top");
    driver.click("probe/name");
    driver.key(ImGuiKey_End);
    driver.type("_a");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(window.scene().markers[3].name, "mid_top_a") << driver.state().refused;
    EXPECT_EQ(window.scene().markers[3].label, "mid_top");
    EXPECT_TRUE(ui::commands::is_seen(window.scene().trials[0], 3));
    ASSERT_NO_FATAL_FAILURE(window.run());
    EXPECT_TRUE(driver.state().simulated_trial()->markers.at(count).allFinite());
    EXPECT_LT(driver.state().run->rms_m, 0.02) << "the recorded markers are compared as before";
}

TEST(PlacingInWindow, TheSupportIsTheFaceThatIsClicked) {
    PlacingWindow window("placing_support");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("support");
    driver.click("support/box/pick");
    const ImVec2 end_face = pixel_of(driver, {0.08, 0.011, 0.009});
    driver.window->input().push(ui::platform::MouseMoved{end_face.x, end_face.y});
    driver.settle();
    // What a click would hold is tinted: all faces of that end, and no others.
    const ui::viewport::DrawnScene& drawn = driver.window->scene();
    ASSERT_EQ(drawn.tints.cols(), drawn.body->faces.count());
    for (Eigen::Index f = 0; f < drawn.tints.cols(); ++f) {
        bool at_end = true;
        for (const int node : drawn.body->faces.nodes.col(f)) at_end = at_end && drawn.positions(0, node) > 0.0795;
        EXPECT_EQ(drawn.tints(3, f) > 0.0f, at_end);
    }
    driver.click_at(end_face);
    ASSERT_TRUE(window.scene().clamp_m);
    EXPECT_NEAR(window.scene().clamp_m->lowest.x(), 0.0792, 1e-7);
    EXPECT_NEAR(window.scene().clamp_m->highest.x(), 0.0808, 1e-7);
    EXPECT_NEAR(window.scene().clamp_m->lowest.y(), -0.0008, 1e-7);
    EXPECT_FALSE(driver.has("view/placing_hint"));
    ASSERT_NO_FATAL_FAILURE(window.run());
    const Eigen::Matrix3Xd& last = driver.state().simulated_trial()->frames.back();
    const Eigen::Matrix3Xd& rest = driver.state().body->mesh.nodes;
    for (Eigen::Index n = 0; n < last.cols(); ++n) {
        if (rest(0, n) < 0.0799) continue;
        EXPECT_LT((last.col(n) - rest.col(n)).norm(), 1e-9);
    }
    driver.workbench->execute(Undo{});
    EXPECT_LT(window.scene().clamp_m->highest.x(), 0.01) << "one step";
}

TEST(PlacingInWindow, ALoadActsOnTheFaceThatIsClicked) {
    PlacingWindow window("placing_load");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("trial");
    driver.click("trial/add_force");
    driver.click("trial/load/0/box/pick");
    driver.click_at(pixel_of(driver, {0.05, 0.01, 0.02}));
    ASSERT_EQ(window.scene().trials[0].loads.size(), 1u);
    const Box& box = window.scene().trials[0].loads[0].box_m;
    EXPECT_NEAR(box.lowest.z(), 0.0192, 1e-7);
    EXPECT_NEAR(box.lowest.x(), -0.0008, 1e-7);
    EXPECT_NEAR(box.highest.x(), 0.0808, 1e-7);
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("view/placing_hint"));
}

TEST(PlacingInWindow, ATendonIsDrawnAlongTheBodyPulledAndItsGuideDragged) {
    PlacingWindow window("placing_tendon");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("probe");
    driver.click("probe/place");
    driver.click_at(pixel_of(driver, {0.078, 0.01, 0.02}));
    driver.key(ImGuiKey_Escape);
    ASSERT_NO_FATAL_FAILURE(window.run());
    const auto height = [&] {
        const Eigen::Matrix3Xd& tip = driver.state().simulated_trial()->markers.at(0);
        return tip.row(2).mean();
    };
    const double hanging = height();
    window.show("tendon");
    driver.click("tendon/add");
    for (const double x : {0.004, 0.03, 0.055, 0.076}) driver.click_at(pixel_of(driver, {x, 0.01, 0.02}));
    EXPECT_TRUE(window.scene().declared.tendons.empty());
    driver.key(ImGuiKey_Enter);
    ASSERT_EQ(window.scene().declared.tendons.size(), 1u) << driver.state().refused;
    EXPECT_EQ(window.scene().declared.tendons[0].name, "tendon1");
    ASSERT_EQ(window.scene().declared.tendons[0].path_m.cols(), 4);
    EXPECT_NEAR(window.scene().declared.tendons[0].path_m(2, 1), 0.02, 1e-9);
    ASSERT_EQ(driver.state().actuators.tendons.size(), 1u) << "drawn on the mesh at hand";
    driver.click("tendon/command/kind");
    driver.click("tendon/command/kind/constant");
    EXPECT_EQ(window.scene().trials[0].commands.at("tendon1").signal.value(0.5), 1.0) << driver.state().refused;
    ASSERT_NO_FATAL_FAILURE(window.run());
    EXPECT_GT(height(), hanging + 1e-3) << "a tendon along the top lifts the tip";
    window.show("tendon");
    driver.click("tendon/drag");
    const Vector3d guide = window.scene().declared.tendons[0].path_m.col(2);
    const ImVec2 at = pixel_of(driver, guide);
    driver.drag(at, {at.x + 12.0f, at.y});
    EXPECT_GT((window.scene().declared.tendons[0].path_m.col(2) - guide).norm(), 1e-4) << driver.state().refused;
    driver.workbench->execute(Undo{});
    EXPECT_EQ(window.scene().declared.tendons[0].path_m.col(2), guide);
    driver.key(ImGuiKey_Escape);
    driver.click("tendon/drive");
    driver.click("tendon/drive/shortening");
    EXPECT_TRUE(window.scene().declared.tendons[0].by_shortening) << driver.state().refused;
    const std::size_t guides = driver.state().actuators.tendons[0].guides.size();
    driver.click("tendon/channel");
    EXPECT_TRUE(window.scene().declared.tendons[0].channel) << driver.state().refused;
    EXPECT_GT(driver.state().actuators.tendons[0].guides.size(), guides) << "bound on its way, too";
    driver.click("tendon/channel");
    EXPECT_FALSE(window.scene().declared.tendons[0].channel) << driver.state().refused;
    driver.click("tendon/remove");
    EXPECT_TRUE(window.scene().declared.tendons.empty()) << driver.state().refused;
}

TEST(PlacingInWindow, AChamberIsListedWithItsCavityAndKeptWhereATrialNeedsIt) {
    PlacingWindow window("placing_chamber");
    ASSERT_NO_FATAL_FAILURE(window.open_example("pneumatic_finger"));
    Driver& driver = window.driver;
    window.show("chamber");
    ASSERT_EQ(window.scene().declared.cavities.size(), 1u);
    EXPECT_EQ(window.scene().declared.cavities[0].chamber, "chamber");
    EXPECT_NEAR(window.scene().declared.cavities[0].volume_m3, 0.06 * 0.01 * 0.005, 1e-15);
    EXPECT_TRUE(driver.has("chamber/chamber/volume"));
    // Another trial has its pressure in a file, which a chamber without this name would leave unread.
    driver.click("chamber/chamber/remove");
    EXPECT_THAT(driver.state().refused, HasSubstr("trial[1].actuation"));
    EXPECT_EQ(window.scene().declared.chambers, std::vector<std::string>{"chamber"});
    driver.click("chamber/chamber/pressure/kind");
    driver.click("chamber/chamber/pressure/kind/rest");
    EXPECT_EQ(window.scene().trials[0].commands.at("chamber").signal.value(0.1), 0.0) << driver.state().refused;
    driver.workbench->execute(Undo{});
    EXPECT_EQ(window.scene().trials[0].commands.at("chamber").signal.value(0.1), 25000.0);
}

TEST(PlacingInWindow, TheWallOfACavityIsClickedInsideTheCutBody) {
    PlacingWindow window("placing_cavity");
    const std::filesystem::path finger = test::example_copy(window.folder, "pneumatic_finger");
    // The finger as it comes from a drawing program: a body and its support, without a chamber.
    const std::string text = *read_file(finger / "experiment.toml");
    const auto table = [&](const std::string& header) {
        const std::size_t from = text.find(header), to = text.find("\n[", from + 1);
        return text.substr(from, to - from) + "\n";
    };
    ASSERT_TRUE(write_file(finger / "experiment.toml",
                           "schema = \"experiment/1\"\nname = \"finger\"\n" + table("[geometry]") + table("[clamp]") +
                               table("[material]") +
                               "[[trial]]\nname = \"blown\"\nrole = \"simulate\"\nduration_s = 0.3\n"
                               "start = \"straight\"\n"));
    ASSERT_NO_FATAL_FAILURE(window.open(finger));
    Driver& driver = window.driver;
    ASSERT_EQ(window.scene().declared.cavities.size(), 1u);
    EXPECT_TRUE(window.scene().declared.cavities[0].chamber.empty());
    window.show("chamber");
    driver.click("chamber/pick");
    EXPECT_TRUE(driver.state().view.clip.on);
    // A wall that the cut leaves in view: tried over the picture of the cavity.
    for (double x = 0.01; x < 0.066 && window.scene().declared.chambers.empty(); x += 0.004)
        for (double z = 0.010; z < 0.0151 && window.scene().declared.chambers.empty(); z += 0.001)
            driver.click_at(pixel_of(driver, {x, 0.010, z}));
    ASSERT_EQ(window.scene().declared.chambers, std::vector<std::string>{"chamber1"}) << driver.state().refused;
    EXPECT_EQ(window.scene().declared.cavities[0].chamber, "chamber1");
    ASSERT_EQ(driver.state().actuators.chambers.size(), 1u);
    driver.click("chamber/chamber1/pressure/kind");
    driver.click("chamber/chamber1/pressure/kind/step");
    EXPECT_EQ(window.scene().trials[0].commands.at("chamber1").signal.value(0.1), 1e4) << driver.state().refused;
    ASSERT_NO_FATAL_FAILURE(window.run());
    const ui::commands::SimulatedTrial& blown = *driver.state().simulated_trial();
    const Eigen::Matrix3Xd& rest = driver.state().body->mesh.nodes;
    EXPECT_GT((blown.frames.back() - rest).colwise().norm().maxCoeff(), 1e-3);
    driver.click("chamber/chamber1/name");
    driver.key(ImGuiKey_End);
    driver.type("a");
    driver.key(ImGuiKey_Enter);
    ASSERT_EQ(window.scene().declared.chambers, std::vector<std::string>{"chamber1a"}) << driver.state().refused;
    EXPECT_EQ(window.scene().trials[0].commands.at("chamber1a").signal.value(0.1), 1e4) << "trials follow";
    driver.click("chamber/chamber1a/remove");
    EXPECT_TRUE(window.scene().declared.chambers.empty()) << driver.state().refused;
    EXPECT_TRUE(driver.state().actuators.empty());
    driver.click("chamber/add/0");
    EXPECT_EQ(window.scene().declared.chambers, std::vector<std::string>{"chamber1"}) << driver.state().refused;
    for (int step = 0; step < 2; ++step) driver.workbench->execute(Undo{});
    EXPECT_EQ(window.scene().declared.chambers, std::vector<std::string>{"chamber1a"});
}

/// Choosing another tool, or another body, ends the tool; the camera stays where it is while places are set.
TEST(PlacingInWindow, OneToolAtATimeHasTheClicks) {
    PlacingWindow window("placing_one_tool");
    ASSERT_NO_FATAL_FAILURE(window.open_bar());
    Driver& driver = window.driver;
    window.show("probe");
    driver.click("probe/place");
    ASSERT_TRUE(driver.has("view/placing_hint"));
    driver.click("view/y");
    const ui::viewport::Camera before = driver.window->viewport().camera;
    driver.click_at(pixel_of(driver, {0.04, 0.0, 0.01}));
    ASSERT_EQ(window.scene().markers.size(), 1u);
    EXPECT_EQ(driver.window->viewport().camera, before);
    driver.click("task/body");
    driver.click("support/box/pick");
    driver.click_at(pixel_of(driver, {0.06, 0.0, 0.01}));
    EXPECT_EQ(window.scene().markers.size(), 1u) << "the click was for the support";
    driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam");
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_FALSE(driver.has("view/placing_hint"));
}

}  // namespace
}  // namespace myo
