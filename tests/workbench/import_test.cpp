#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "backend/workbench_backend.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/rigid_motion.hpp"
#include "measurement/trace_csv.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::Driver;
using test::Folder;

/// The bundled beam in a folder of its own.
fs::path beam_in(const Folder& folder) {
    fs::copy(fs::path(MYOLOOP_SOURCE_DIR) / "assets/examples/silicone_beam", folder.path() / "beam", fs::copy_options::recursive);
    return folder.path() / "beam";
}

const RigidMotion camera{Eigen::AngleAxisd(1.9, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()).toRotationMatrix(), {0.8, -0.2, 1.5}};

/// A trial of the beam as other cameras would have recorded it: still for 0.6 s, then the motion; other names, another order, another frame.
fs::path take_of(const Folder& folder, const fs::path& trace) {
    Recording recording = *read_trace_csv(trace);
    const double step = 1.0 / recording.rate_Hz;
    const auto still = static_cast<Eigen::Index>(0.6 / step);
    const Eigen::Index first = (recording.time_s.array() < -1e-9).count();
    Recording take;
    take.rate_Hz = recording.rate_Hz;
    take.time_s = Eigen::VectorXd::LinSpaced(still + recording.sample_count() - first, 0.0, step * static_cast<double>(still + recording.sample_count() - first - 1));
    for (std::size_t i = recording.labels.size(); i-- > 0;) {
        take.labels.push_back("p" + std::to_string(take.labels.size()));
        Eigen::Matrix3Xd track(3, take.time_s.size());
        track.leftCols(still).colwise() = Eigen::Vector3d(recording.tracks[i].col(first));
        track.rightCols(recording.sample_count() - first) = recording.tracks[i].rightCols(recording.sample_count() - first);
        // Cameras are never still.
        for (Eigen::Index t = 0; t < still; ++t) track.col(t) += 2e-5 * Eigen::Vector3d(std::sin(7.0 * static_cast<double>(t)), std::sin(11.0 * static_cast<double>(t)), std::cos(5.0 * static_cast<double>(t)));
        take.tracks.push_back(track);
    }
    take = transform(take, camera);
    const fs::path file = folder.path() / "take 7.csv";
    EXPECT_TRUE(write_trace_csv(file, take));
    return file;
}

TEST(CoreImport, ARecordingByOtherCamerasBecomesTheTrialThatItWas) {
    Folder folder("import");
    const fs::path beam = beam_in(folder);
    Driver driver(make_core_backend(), 1400, 900);
    driver.workbench->execute(command::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    const SceneTrial known = driver.state().scene->trials[0];
    ASSERT_EQ(known.name, "gravity_release");
    driver.workbench->execute(command::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    const double rms = driver.state().run->trials[0].rms_m;
    driver.workbench->execute(command::ReadRecording{take_of(folder, beam / "gravity_release.csv")});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import) << driver.state().log.back().text;
    // Markers and frame are told by their distances alone.
    const RecordingImport& import = *driver.state().import;
    EXPECT_EQ(import.view.problem, "");
    EXPECT_LT(import.view.rms_m, 5e-4);
    EXPECT_LT(rotation_angle(import.view.rotation * camera.rotation), 0.02);
    EXPECT_NEAR(import.choices.start_s, 0.6, 0.015);
    // By the run the start is found, too, although its modulus is not that of the beam.
    driver.workbench->execute(command::AlignImport{});
    EXPECT_NEAR(driver.state().import->choices.start_s, 0.6, 0.03);
    ImportChoices choices = driver.state().import->choices;
    choices.start_s = 0.6;
    choices.fit = false;
    choices.trial = "again";
    driver.workbench->execute(command::ChangeImport{choices});
    driver.workbench->execute(command::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_FALSE(driver.state().import) << driver.state().log.back().text;
    const SceneTrial* const added = driver.state().scene_trial();
    ASSERT_TRUE(added);
    EXPECT_EQ(added->name, "again");
    EXPECT_EQ(added->role, "validate");
    driver.workbench->execute(command::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    EXPECT_NEAR(driver.state().run->trials.back().rms_m, rms, 0.05 * rms) << "the same motion, from another folder of files";
    EXPECT_NEAR(driver.state().run->trials.front().rms_m, rms, 1e-6);
}

TEST(CoreImport, APlainMeshBecomesAnExperiment) {
    Folder folder("import_mesh");
    const fs::path beam = beam_in(folder);
    Driver driver(make_core_backend(), 1400, 900);
    driver.workbench->execute(command::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    const std::vector<SceneMarker> markers = driver.state().scene->markers;
    const fs::path mesh = folder.path() / "plain.stl";
    ASSERT_TRUE(write_stl(mesh, driver.state().scene->surface, 1e-3));
    const fs::path take = take_of(folder, beam / "gravity_release.csv");
    driver.workbench->execute(command::Open{mesh, 1e-3});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(command::ReadRecording{take});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import);
    EXPECT_FALSE(driver.state().import->view.problem.empty());
    driver.workbench->execute(command::ProposeMarkers{});
    EXPECT_EQ(driver.state().log.back().level, LogLevel::warning) << "nothing has been clicked";
    // Three are clicked; take_of turned their order round.
    ImportChoices choices = driver.state().import->choices;
    for (const std::size_t i : {0u, 1u, 2u}) choices.markers[i] = {"m" + std::to_string(i), markers[markers.size() - 1 - i].rest_m};
    choices.folder = folder.path() / "made";
    driver.workbench->execute(command::ChangeImport{choices});
    driver.workbench->execute(command::ProposeMarkers{});
    const RecordingImport& import = *driver.state().import;
    ASSERT_EQ(import.view.problem, "");
    for (std::size_t i = 0; i < markers.size(); ++i) {
        ASSERT_TRUE(import.choices.markers[i].rest_m) << i;
        EXPECT_LT((*import.choices.markers[i].rest_m - markers[markers.size() - 1 - i].rest_m).norm(), 2e-3) << i;
    }
    driver.workbench->execute(command::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_FALSE(driver.state().import) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().scene->trials.size(), 1u);
    EXPECT_EQ(driver.state().scene->markers.size(), markers.size());
    driver.workbench->execute(command::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    EXPECT_LT(driver.state().run->rms_m, 0.02);
}

}  // namespace
}  // namespace myo
