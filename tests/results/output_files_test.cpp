#include "results/output_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "base/files.hpp"
#include "measurement/trace_csv.hpp"
#include "mesh/volume_reader.hpp"
#include "support/known_run.hpp"
#include "support/swung_beam.hpp"

namespace myo::results {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Names = std::vector<std::string>;

TEST(TrialFileNames, AreSafeAndDistinct) {
    EXPECT_THAT(trial_file_names(Names{"release", "a b", "a/b", "a_b", "../x", "", ".hidden", "März-1.5"}),
                ElementsAre("release", "a_b", "a_b_2", "a_b_3", "_.._x", "_", "_.hidden", "März-1.5"));
    EXPECT_THAT(trial_file_names(Names{"x", "x_2", "x"}), ElementsAre("x", "x_2", "x_3"));
    EXPECT_EQ(trial_file_names(Names{std::string(400, 'a')}).front().size(), 150u);
    std::string letters = "a";
    for (int i = 0; i < 100; ++i) letters += "ä";
    EXPECT_EQ(trial_file_names(Names{letters}).front(), letters.substr(0, 149)) << "no half of a letter";
}

class OutputFiles : public testing::Test {
protected:
    OutputFiles()
        : folder_("output_files"),
          setup_(test::swung_beam(folder_, 0.1)),
          run_(test::run_missed_by(setup_, {{1e-3 / 3.0, 0.0, -2e-3}, {0.0, 1e-3, 0.0}})) {}

    std::string content(const std::string& file) const {
        const Result<std::string> text = read_file(out() / file);
        EXPECT_TRUE(text) << file;
        return text ? *text : std::string();
    }
    bool there(const std::string& file) const { return fs::exists(out() / file); }
    fs::path out() const { return folder_.path() / "out"; }

    test::Folder folder_;
    setup::Setup setup_;
    prediction::SetupRun run_;
};

/// A trace that is written and read is the same to the last bit.
TEST_F(OutputFiles, TracesReadBackExactly) {
    fs::create_directories(out());
    ASSERT_TRUE(write_traces(out(), setup_, run_));
    for (std::size_t t = 0; t < 2; ++t) {
        const Result<measurement::Recording> read = measurement::read_trace_csv(
            out() / (t == 0 ? "swing.csv" : "swing_again.csv"));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->labels, setup_.marker_names);
        EXPECT_EQ(read->time_s, setup_.trials[t].measured.time_s);
        EXPECT_EQ(read->tracks, run_.predictions[t].positions_m);
    }
    EXPECT_THAT(trace_files(out(), setup_.experiment), ElementsAre(out() / "swing.csv", out() / "swing_again.csv"));
}

TEST_F(OutputFiles, OfAFailedTrialAreNotWritten) {
    fs::create_directories(out());
    const prediction::SetupRun failed = test::with_failure(setup_, run_, 0, "it broke");
    ASSERT_TRUE(write_traces(out(), setup_, failed));
    EXPECT_FALSE(there("swing.csv"));
    EXPECT_TRUE(there("swing_again.csv"));
    ASSERT_TRUE(write_series(out(), setup_, failed, 2));
    EXPECT_FALSE(there("swing.pvd"));
    EXPECT_TRUE(there("swing_again.pvd"));
}

TEST_F(OutputFiles, SeriesShowsTheMotionAtEquallySpacedTimes) {
    fs::create_directories(out());
    // States lie at 0, 0.02, ..., 0.1 s: three frames are those at 0, 0.04 (of two equally near, the earlier) and 0.1.
    ASSERT_TRUE(write_series(out(), setup_, run_, 3));
    const std::string index = content("swing.pvd");
    EXPECT_THAT(index, HasSubstr("<DataSet timestep=\"0\" part=\"0\" file=\"swing_frames/0000.vtu\"/>"));
    EXPECT_THAT(index, HasSubstr("timestep=\"0.1\" part=\"0\" file=\"swing_frames/0002.vtu\"/>"));
    EXPECT_THAT(index, Not(HasSubstr("0003.vtu")));
    const Result<mesh::VolumeMesh> last = mesh::read_volume(out() / "swing_frames" / "0002.vtu", 1.0);
    ASSERT_TRUE(last) << last.error().text();
    EXPECT_EQ(last->nodes, run_.predictions[0].trace.positions.back());
    EXPECT_EQ(last->cells, setup_.mesh.mesh.cells);
    const Result<mesh::VolumeMesh> first = mesh::read_volume(out() / "swing_frames" / "0000.vtu", 1.0);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->nodes, setup_.mesh.mesh.nodes);
    const std::string frame = content("swing_frames/0001.vtu");
    EXPECT_THAT(frame, HasSubstr("Name=\"displacement\""));
    EXPECT_THAT(frame, HasSubstr("Name=\"velocity\""));
}

TEST_F(OutputFiles, SeriesHasNoMoreFramesThanStates) {
    fs::create_directories(out());
    ASSERT_TRUE(write_series(out(), setup_, run_, 50));
    EXPECT_TRUE(there("swing_frames/0005.vtu"));
    EXPECT_FALSE(there("swing_frames/0006.vtu"));
    // A shorter series replaces the longer one and nothing else.
    ASSERT_TRUE(write_file(out() / "swing_frames" / "mine.txt", "kept"));
    const std::vector<fs::path> touched = series_files(out(), setup_.experiment, 2);
    EXPECT_EQ(touched.size(), 2u + 6u + 6u);
    ASSERT_TRUE(write_series(out(), setup_, run_, 2));
    EXPECT_TRUE(there("swing_frames/0001.vtu"));
    EXPECT_FALSE(there("swing_frames/0002.vtu"));
    EXPECT_TRUE(there("swing_frames/mine.txt"));
}

TEST_F(OutputFiles, SeriesOfOneFrameShowsTheStart) {
    fs::create_directories(out());
    ASSERT_TRUE(write_series(out(), setup_, run_, 1));
    EXPECT_THAT(content("swing.pvd"), HasSubstr("timestep=\"0\""));
    EXPECT_FALSE(there("swing_frames/0001.vtu"));
}

TEST_F(OutputFiles, CancelledSeriesIsRemoved) {
    fs::create_directories(out());
    std::atomic<bool> stop{false};
    const Progress progress([&](const ProgressEvent&) { stop = true; }, &stop);
    const Result<void> written = write_series(out(), setup_, run_, 4, progress);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().what, "stopped by the user");
    EXPECT_FALSE(there("swing.pvd"));
    EXPECT_FALSE(there("swing_frames"));
}

TEST_F(OutputFiles, FilesReadAreTheDeclarationAndWhatItNames) {
    EXPECT_THAT(files_read(folder_.path(), setup_.experiment),
                ElementsAre(folder_.path() / "experiment.toml", setup_.experiment.trials[0].trace,
                            setup_.experiment.trials[1].trace));
    experiment::Experiment more = setup_.experiment;
    more.geometry = experiment::StlGeometry{};
    std::get<experiment::StlGeometry>(more.geometry).file = "body.stl";
    more.trials.pop_back();
    more.trials[0].actuation = "a.csv";
    more.muscles.resize(2);
    more.muscles[0].signal_file = "s.csv";
    more.muscles[1].part = experiment::MuscleMask{fs::path("mask.json"), {}};
    EXPECT_THAT(files_read("other.toml", more), ElementsAre("other.toml", "body.stl", setup_.experiment.trials[0].trace,
                                                            "a.csv", "s.csv", "mask.json"));
    // A mesh of TetGen is two files, whichever is named.
    for (const char* name : {"body.node", "body.ele"}) {
        more.geometry = experiment::VolumeGeometry{.file = name};
        EXPECT_THAT(files_read("other.toml", more),
                    ElementsAre("other.toml", "body.node", "body.ele", setup_.experiment.trials[0].trace, "a.csv",
                                "s.csv", "mask.json"));
    }
}

TEST_F(OutputFiles, FolderIsMadeAndTried) {
    ASSERT_TRUE(prepare_output_folder(out() / "deep" / "er"));
    EXPECT_TRUE(fs::is_directory(out() / "deep" / "er"));
    EXPECT_TRUE(fs::is_empty(out() / "deep" / "er"));
    ASSERT_TRUE(prepare_output_folder(out()));
    const Result<void> taken = prepare_output_folder(folder_.path() / "experiment.toml");
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().what, "is a file, not a folder");
    EXPECT_EQ(taken.error().where, folder_.str("experiment.toml"));
    EXPECT_FALSE(prepare_output_folder(folder_.path() / "experiment.toml" / "below"));
}

}  // namespace
}  // namespace myo::results
