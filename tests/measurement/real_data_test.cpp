// Facts of the measured recordings, as their README states them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measurement/actuation_csv.hpp"
#include "measurement/c3d_reader.hpp"
#include "measurement/column_files.hpp"
#include "measurement/gaps.hpp"
#include "measurement/motion_start.hpp"
#include "measurement/noise.hpp"
#include "measurement/qtm_tsv.hpp"
#include "measurement/registration.hpp"
#include "measurement/rest_pose.hpp"
#include "measurement/trace_csv.hpp"
#include "support/shared_data.hpp"
#include "test_files.hpp"

namespace myo::measurement {
namespace {

#define NEED_DATA(folder, part)                                   \
    const std::filesystem::path folder = test::shared_data(part); \
    if (folder.empty()) GTEST_SKIP() << "skipped: no data"

struct Take {
    std::string file;
    int samples;
    std::vector<std::string> labels;
    int first_moving;  // by eye, 0-based
};

const std::vector<std::string> beam_labels{"Tip - 1", "Tip - 2", "Tip - 3", "Base - 1", "Base - 2", "Base - 3"};
const std::vector<std::string> arm_labels{"Base - 1", "Base - 2", "Base - 3", "Base - 4",
                                          "Tip - 1",  "Tip - 2",  "Tip - 3"};
const std::vector<std::string> segment_labels{"tip - 1",  "tip - 2",  "tip - 3",  "tip - 4",
                                              "base - 1", "base - 2", "base - 3", "base - 4"};

const std::vector<Take> c3d_takes{
    {"beam/beam_gravity_V2_a.c3d", 500, beam_labels, 71},  {"beam/beam_gravity_V2_b.c3d", 500, beam_labels, 65},
    {"beam/beam_load101_V2_a.c3d", 600, beam_labels, 51},  {"beam/beam_load101_V2_b.c3d", 600, beam_labels, 55},
    {"arm/100mbar_V3.c3d", 600, arm_labels, 59},           {"arm/200mbar_V3.c3d", 600, arm_labels, 79},
    {"arm/300mbar_V3.c3d", 600, arm_labels, 155},          {"arm/400mbar_V3.c3d", 600, arm_labels, 50},
    {"arm/segment-200mbar.c3d", 600, segment_labels, 126}, {"arm/segment-300mbar.c3d", 600, segment_labels, 284},
    {"arm/segment-400mbar.c3d", 600, segment_labels, 175}};

TEST(RealData, C3dFilesAreReadWithTheirStartsWithinTwoFrames) {
    NEED_DATA(folder, "data/mocap");
    for (const Take& take : c3d_takes) {
        const Result<Recording> read = read_c3d(folder / take.file);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->sample_count(), take.samples) << take.file;
        EXPECT_EQ(read->labels, take.labels) << take.file;
        EXPECT_DOUBLE_EQ(read->rate_Hz, 100.0);
        for (const MarkerGaps& marker : gap_map(*read)) EXPECT_TRUE(marker.gaps.empty()) << take.file;
        for (const Eigen::VectorXd& residual : read->residual_m) EXPECT_LT(residual.maxCoeff(), 2e-3) << take.file;
        const StartOfMotion start = find_motion_start(*read);
        EXPECT_TRUE(start.found) << take.file;
        EXPECT_NEAR(static_cast<double>(start.first_moving), take.first_moving, 2.0) << take.file;
        EXPECT_NEAR(start.time_s * 100.0, take.first_moving, 2.0) << take.file;
    }
}

TEST(RealData, PressureSweepStartsAndRepeats) {
    NEED_DATA(folder, "data/mocap");
    for (const char* name : {"075", "125", "175", "225", "275", "325", "375"}) {
        const Result<Recording> read = read_trace_csv(folder / "arm_pressure_sweep" / (std::string(name) + "mbar.csv"));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->sample_count(), 150);
        EXPECT_EQ(read->labels.size(), 7U);
        EXPECT_DOUBLE_EQ(read->rate_Hz, 100.0);
        const auto repeats = static_cast<double>(repeated_samples(*read).size());
        EXPECT_GT(repeats / 150.0, 0.1) << name;  // about one in five
        EXPECT_LT(repeats / 150.0, 0.3) << name;
        const StartOfMotion start = find_motion_start(*read);
        EXPECT_TRUE(start.found) << name;
        EXPECT_GE(start.first_moving, 6) << name;
        EXPECT_LE(start.first_moving, 12) << name;
    }
}

TEST(RealData, FishHasNoHeaderAndMovesFromRowTwo) {
    NEED_DATA(folder, "data/mocap");
    const Result<Recording> read = read_columns(folder / "fish/soft_fish_data.csv",
                                                {{"spine", "base_1", "base_2", "base_3"}, 1e-3, ';', 100.0});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sample_count(), 198);
    const StartOfMotion start = find_motion_start(*read);
    EXPECT_TRUE(start.found);
    EXPECT_NEAR(static_cast<double>(start.first_moving), 2.0, 2.0);
    EXPECT_EQ(start.movers, std::vector<std::string>{"spine"});
}

TEST(RealData, BeamRestPoseFitsTheNominalOne) {
    NEED_DATA(folder, "data/mocap");
    Eigen::Matrix3Xd nominal(3, 6);
    nominal.transpose() << 0, 15, 36, 0, -6, 24, 0, 36, 6, -94, -10, -1, -94, 40, 27.5, -94, 40, 0;
    nominal *= 1e-3;
    for (const Take& take : c3d_takes) {
        if (take.labels != beam_labels) continue;
        const Result<Recording> read = read_c3d(folder / take.file);
        ASSERT_TRUE(read);
        const StartOfMotion start = find_motion_start(*read);
        const Result<RestPose> pose = rest_pose(*read, start.first_moving);
        ASSERT_TRUE(pose);
        EXPECT_LT(pose->deviation_m.maxCoeff(), 5e-5) << "the transient of Base - 2 is left out";
        const Result<Registration> fit = rigid_registration(pose->positions_m, nominal);
        ASSERT_TRUE(fit);
        // README: 0.8 mm without load to 1.3 mm with 101 g; placed by hand.
        EXPECT_GT(fit->rms_m, 0.4e-3) << take.file;
        EXPECT_LT(fit->rms_m, 1.6e-3) << take.file;
        // Roughly beam x = lab z and beam z = lab x.
        EXPECT_GT(fit->motion.rotation(0, 2), 0.98);
        EXPECT_LT(fit->motion.rotation(1, 1), -0.98);
        EXPECT_GT(fit->motion.rotation(2, 0), 0.98);
    }
}

TEST(RealData, BeamNoiseIsThatOfTheReadme) {
    NEED_DATA(folder, "data/mocap");
    const Result<Recording> read = read_c3d(folder / "beam/beam_gravity_V2_a.c3d");
    ASSERT_TRUE(read);
    for (const NoiseEstimate& estimate : estimate_noise(*read)) {
        EXPECT_GT(estimate.sigma_m, 2e-6) << estimate.label;  // 3 to 6 um, the white part of it
        EXPECT_LT(estimate.sigma_m, 8e-6) << estimate.label;
    }
}

TEST(RealData, ExampleTracesAreReadAndTheirNoiseIsTheTrueOne) {
    NEED_DATA(folder, "experiments");
    int traces = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::filesystem::path& path = entry.path();
        const std::string name = path.filename().string();
        if (name.ends_with("_actuation.csv")) {
            const Result<ActuationTable> table = read_actuation_csv(path);
            ASSERT_TRUE(table) << table.error().text();
            EXPECT_GT(table->muscles.size(), 0U);
            continue;
        }
        if (path.extension() != ".csv" && path.extension() != ".tsv") continue;
        const Result<Recording> read = path.extension() == ".csv" ? read_trace_csv(path) : read_qtm_tsv(path);
        ASSERT_TRUE(read) << read.error().text();
        ++traces;
        // Examples have white noise of 0.1 mm, one of 0.08 mm (their truth files).
        const double truth = path.string().find("quadratic_drag") != std::string::npos ? 8e-5 : 1e-4;
        const bool example = path.string().find("example_") != std::string::npos;
        if (example) {
            EXPECT_NEAR(mean_noise(estimate_noise(*read)), truth, 0.1 * truth) << path;
        }
        // Where a trial is there in both forms they hold the same samples; the tsv has three decimals of a millimetre.
        std::filesystem::path twin = path;
        twin.replace_extension(".csv");
        if (path.extension() == ".tsv" && std::filesystem::exists(twin)) {
            const Result<Recording> other = read_trace_csv(twin);
            ASSERT_TRUE(other);
            EXPECT_EQ(read->labels, other->labels);
            EXPECT_LT(test::largest_difference(*read, *other), 1.01e-6) << path;
        }
    }
    EXPECT_GT(traces, 0);
}

}  // namespace
}  // namespace myo::measurement
