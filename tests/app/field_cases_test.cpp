#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/experiment_calls.hpp"
#include "support/shared_data.hpp"

namespace myo::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What the program says of an input of a kind that users' files hit.
struct FieldCase {
    std::string file;
    std::string format;              // of a recording
    std::vector<std::string> words;  // of the warnings, or of the only sentence if the file is refused
    bool refused = false;
};

void PrintTo(const FieldCase& field_case, std::ostream* stream) { *stream << field_case.file; }

std::string named(const testing::TestParamInfo<FieldCase>& info) {
    std::string name;
    for (const char c : info.param.file) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

void expect_words(const FieldCase& field_case, const std::string& text) {
    for (const std::string& word : field_case.words) EXPECT_THAT(text, HasSubstr(word));
}

/// A refusal is one sentence and leaves no result.
void expect_refusal(const ProgramRun& run, const Folder& folder) {
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_FALSE(folder.has("out/simulate.json"));
}

/// Rms of the trial gravity_release of the recordings with the trace of a file [m]; the run is in `run`.
std::optional<double> rms_with(const FieldCase& field_case, const Folder& folder, ProgramRun& run) {
    run = run_program({"simulate", shared_data("field_cases/recordings").string(), "--trial", "gravity_release",
                       "--resolution", "0.02", "--dt", "0.01", "--set",
                       "trial.gravity_release.trace=\"" + field_case.file + "\"", "--set",
                       "trial.gravity_release.format=\"" + field_case.format + "\"", "--out", folder.str("out")});
    if (run.status != 0) return {};
    return json_of(folder, "simulate")["trials"][0]["rms_m"].get<double>();
}

class FieldRecording : public testing::TestWithParam<FieldCase> {};

/// The model of the same recording without a fault leaves as much, because nothing false is compared.
TEST_P(FieldRecording, IsToldAndComparedWithoutItsFault) {
    if (shared_data("field_cases/recordings").empty()) GTEST_SKIP() << "skipped: no data";
    const FieldCase& field_case = GetParam();
    const Folder folder("field_recording"), sound("sound_recording");
    ProgramRun run;
    const std::optional<double> rms_m = rms_with(field_case, folder, run);
    expect_words(field_case, run.err);
    if (field_case.refused) return expect_refusal(run, folder);
    ASSERT_EQ(run.status, 0) << run.err;
    ProgramRun plain;
    const std::optional<double> sound_m = rms_with({"gravity_release.csv", "csv", {}}, sound, plain);
    ASSERT_TRUE(rms_m && sound_m) << plain.err;
    EXPECT_NEAR(*rms_m, *sound_m, 0.05 * *sound_m);
}

INSTANTIATE_TEST_SUITE_P(
    , FieldRecording,
    testing::Values(
        FieldCase{"frozen_marker.csv", "csv", {"\"tip_right\"", "repeats one position", "0.3 s to 0.69 s"}},
        FieldCase{"ghost_after_gap1.csv", "csv", {"\"tip_right\"", "these 20 samples are left out"}},
        FieldCase{"zeros_in_gap.csv", "csv", {"\"tip_right\"", "exactly 0, 0, 0 in 20 samples", "gap"}},
        FieldCase{"crossed_after_gap.csv", "csv", {"\"tip_left\", \"tip_right\"", "exchanged names from 0.4 s"}},
        FieldCase{"coordinates_in_mm_says_m.csv", "csv", {"1000 times as far apart", "look like mm", "unit"}, true},
        FieldCase{"time_in_ms_says_s.csv", "csv", {"look like milliseconds", "time_unit = \"ms\""}, true},
        FieldCase{"decimal_comma_semicolon.csv", "csv", {}}, FieldCase{"nexus_trajectories.csv", "vicon_csv", {}},
        FieldCase{"trajectories.trc", "trc", {}}, FieldCase{"plain.c3d", "c3d", {}},
        FieldCase{"unit_mete.c3d", "c3d", {"'mete'", "no known unit of length", "the trial's key unit"}, true},
        FieldCase{"frames_parameter_one_more.c3d", "c3d", {"says 82 frames", "hold 81, which are read"}},
        FieldCase{"parameters_without_end_mark.c3d", "c3d", {}},
        FieldCase{"model_outputs_among_points.c3d", "c3d", {}}),
    named);

/// Motive's y points upwards: the program names the key that turns it and keeps what the file says.
TEST(FieldRecordings, OfAnUpwardYNameTheKeyThatTurnsThem) {
    if (shared_data("field_cases/recordings").empty()) GTEST_SKIP() << "skipped: no data";
    const Folder folder("motive"), turned("motive_turned"), sound("motive_sound");
    const FieldCase motive{"motive_1.23_y_up.csv", "motive_csv", {}};
    ProgramRun run;
    ASSERT_TRUE(rms_with(motive, folder, run)) << run.err;
    EXPECT_THAT(run.err, HasSubstr("axes = [\"x\", \"-z\", \"y\"]"));
    run = run_program({"simulate", shared_data("field_cases/recordings").string(), "--trial", "gravity_release",
                       "--resolution", "0.02", "--dt", "0.01", "--set",
                       "trial.gravity_release.trace=\"" + motive.file + "\"", "--set",
                       "trial.gravity_release.format=\"motive_csv\"", "--set",
                       "trial.gravity_release.axes=[\"x\", \"-z\", \"y\"]", "--out", turned.str("out")});
    ASSERT_EQ(run.status, 0) << run.err;
    ProgramRun plain;
    const std::optional<double> sound_m = rms_with({"gravity_release.csv", "csv", {}}, sound, plain);
    ASSERT_TRUE(sound_m);
    EXPECT_NEAR(json_of(turned, "simulate")["trials"][0]["rms_m"].get<double>(), *sound_m, 0.05 * *sound_m);
}

class FieldMesh : public testing::TestWithParam<FieldCase> {};

/// The same words for hexahedra and tetrahedra, because both begin with the surface.
TEST_P(FieldMesh, IsToldForHexahedraAndTetrahedra) {
    if (shared_data("field_cases/meshes").empty()) GTEST_SKIP() << "skipped: no data";
    const FieldCase& field_case = GetParam();
    for (const char* type : {"hex8", "tet10"}) {
        const Folder folder("field_mesh");
        const ProgramRun run = run_program({"mesh", (shared_data("field_cases/meshes") / field_case.file).string(),
                                            "--type", type, "--resolution", "0.01", "--unit", "mm", "--out",
                                            folder.str("out.vtu")});
        expect_words(field_case, run.err);
        EXPECT_EQ(run.status, field_case.refused ? 2 : 0) << run.err;
        EXPECT_EQ(folder.has("out.vtu"), !field_case.refused);
    }
}

INSTANTIATE_TEST_SUITE_P(
    , FieldMesh,
    testing::Values(FieldCase{"sphere_150_bytes_more.stl", "", {"150 bytes more than its 528 triangles need"}},
                    FieldCase{"sphere_more_numbers_than_declared.ply", "", {"312 lines", "first line 10"}},
                    FieldCase{"chamber_outward.stl", "", {"part 2", "faces outward", "was turned"}},
                    FieldCase{"overlapping_boxes.stl", "", {"overlap", "part 1", "part 2", "unite them"}, true}),
    named);

TEST(FieldMeshes, OfFineTrianglesKeepTheEdgeAskedFor) {
    const fs::path sphere = shared_data("field_cases/meshes/sphere_14k_triangles.stl");
    if (sphere.empty()) GTEST_SKIP() << "skipped: no data";
    const Folder folder("fine_sphere");
    const ProgramRun run = run_program({"mesh", sphere.string(), "--type", "tet10", "--resolution", "0.01", "--unit",
                                        "mm", "--json", "--out", folder.str("out.vtu")});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("it was remeshed"));
    const nlohmann::json figures = nlohmann::json::parse(run.out);
    EXPECT_LT(figures.at("elements").get<int>(), 3000);
}

TEST(FieldMeshes, OfSliversAreCountedWithTheirPlace) {
    const fs::path bar = shared_data("field_cases/meshes/bar_with_slivers.msh");
    if (bar.empty()) GTEST_SKIP() << "skipped: no data";
    const ProgramRun run = run_program({"mesh", bar.string(), "--unit", "mm"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("almost flat"));
}

/// Robots with chambers, tendons and holds: each declared model runs and comes nearer to its recordings than a body
/// that stays at rest.
TEST(FieldRobots, RunAsDeclared) {
    const std::vector<fs::path> robots = shared_entries(
        "robots", [](const fs::path& path) { return fs::exists(path / "experiment.toml"); });
    if (robots.empty()) GTEST_SKIP() << "skipped: no data";
    for (const fs::path& robot : robots) {
        const Folder folder("field_robot");
        const ProgramRun run = run_program(
            {"simulate", robot.string(), "--element", "hex8", "--resolution", "0.008", "--out", folder.str("out")});
        ASSERT_EQ(run.status, 0) << robot << run.err;
        const nlohmann::json result = json_of(folder, "simulate");
        for (const nlohmann::json& trial : result.at("trials")) {
            const double rms_m = trial.at("rms_m").get<double>();
            EXPECT_TRUE(std::isfinite(rms_m)) << robot << trial.at("name");
            // A body of 10 to 40 cm whose bending is of the order of its length.
            EXPECT_LT(rms_m, 0.04) << robot << trial.at("name");
        }
        expect_clean(folder);
    }
}

}  // namespace
}  // namespace myo::test
