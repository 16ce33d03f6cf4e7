#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "app/sweep_texts.hpp"

// A signal that asks to stop, from the keyboard or from a queue, ends a command with the documented status and leaves
// every file as it was or whole.

namespace myo::app::signals_test {
namespace {

using test::axis;
using test::content_of;
using test::Folder;
using test::ProgramRun;
using test::run_program;
using test::small_trace;
using test::write_small_experiment;
using test::write_sweep;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Contents of the files of a folder, by their path in it.
std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    return files;
}

/// No temporary file, no lock, and no file that ends in its middle.
void expect_whole(const std::map<std::string, std::string>& files) {
    for (const auto& [name, content] : files) {
        EXPECT_NE(fs::path(name).filename().string()[0], '.') << name;
        if (name.ends_with(".json")) EXPECT_TRUE(nlohmann::json::accept(content)) << name;
        if (name.ends_with(".csv")) EXPECT_TRUE(content.ends_with('\n')) << name;
        if (name.ends_with(".html")) EXPECT_TRUE(content.ends_with("</html>\n")) << name;
    }
}

struct Stopped {
    const char* command;
    const char* task;  // of the progress during which the signal comes
    int signal;
};

class StoppedRuns : public ::testing::TestWithParam<Stopped> {};

/// A run of 2000 steps and more, which starts at once because its step is given, over the results of a short one.
TEST_P(StoppedRuns, EndWithTheirStatusAndKeepTheResultsBeforeThem) {
    const std::string command = GetParam().command;
    const Folder folder("stopped_" + command + std::to_string(GetParam().signal));
    write_small_experiment(folder);
    const auto words = [&](const char* resolution, const char* step) {
        return std::vector<std::string>{command,          folder.str("exp"), "--out", folder.str("out"),
                                        "--resolution",   resolution,        "--dt",  step,
                                        "--json-progress"};
    };
    // The short run may end in any way: its files are those before the next one.
    run_program(words("0.01", "0.005"));
    const std::map<std::string, std::string> before = files_in(folder.path() / "out");
    ASSERT_TRUE(before.contains(command + ".json"));
    expect_whole(before);
    folder.write("exp/drop.csv", small_trace(4.0));
    const ProgramRun run = run_program(words("0.005", "0.001"), "\"task\":\"" + std::string(GetParam().task) + "\"",
                                       60.0, GetParam().signal);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_LT(run.seconds_after_signal, 2.0);
    EXPECT_THAT(run.err, HasSubstr("myoloop: stopped"));
    EXPECT_THAT(run.err, HasSubstr("nothing was written"));
    EXPECT_EQ(files_in(folder.path() / "out"), before);
}

INSTANTIATE_TEST_SUITE_P(All, StoppedRuns,
                         ::testing::Values(Stopped{"simulate", "simulate", SIGINT},
                                           Stopped{"simulate", "simulate", SIGTERM},
                                           Stopped{"calibrate", "fit", SIGTERM}),
                         [](const auto& one) {
                             return std::string(one.param.command) + (one.param.signal == SIGINT ? "_int" : "_term");
                         });

/// The library that orders the unknowns (METIS) catches SIGTERM while it runs, and its handler crashes in a thread that
/// is not in it. So only one thread, which waits for the signal, may receive it.
TEST(Signals, ATerminationReachesOneThreadOnly) {
    const Folder folder("one_thread");
    write_small_experiment(folder, 4.0);
    const ProgramRun run = run_program({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resolution",
                                        "0.005", "--dt", "0.001", "--json-progress"},
                                       "\"task\":\"fit\"", 60.0, SIGTERM);
    EXPECT_EQ(run.open_threads, 1);
    EXPECT_EQ(run.status, 130) << run.err;
}

/// A hang-up is not caught: the program ends by the signal. What it may leave are a lock, which the system has
/// released, and no result.
TEST(Signals, ASignalThatIsNotCaughtLeavesNoResult) {
    const Folder folder("killed");
    write_small_experiment(folder, 4.0);
    const std::vector<std::string> words{"simulate",       folder.str("exp"), "--out", folder.str("out"),
                                         "--resolution",   "0.005",           "--dt",  "0.001",
                                         "--json-progress"};
    const ProgramRun killed = run_program(words, "\"task\":\"simulate\"", 60.0, SIGKILL);
    EXPECT_EQ(killed.status, 128 + SIGKILL);
    for (const auto& [name, content] : files_in(folder.path() / "out"))
        EXPECT_EQ(fs::path(name).filename().string()[0], '.') << name;
    // The next run takes the lock of the one that is gone, and removes it.
    folder.write("exp/drop.csv", small_trace(0.05));
    const ProgramRun next = run_program(
        {"simulate", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01", "--dt", "0.005"});
    EXPECT_EQ(next.status, 0) << next.err;
    EXPECT_FALSE(folder.has("out/.myoloop.lock"));
    EXPECT_TRUE(folder.has("out/simulate.json"));
}

/// A command that writes nothing stops as well.
TEST(Signals, ACheckOfGradientsStops) {
    const Folder folder("stopped_gradcheck");
    write_small_experiment(folder, 4.0);
    const ProgramRun run = run_program({"gradcheck", folder.str("exp"), "--steps", "400", "--resolution", "0.004",
                                        "--json-progress", "--json", folder.str("check.json")},
                                       "\"event\":\"progress\"", 60.0, SIGTERM);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_LT(run.seconds_after_signal, 2.0);
    EXPECT_FALSE(folder.has("check.json"));
}

/// A sweep passes the signal on to its cases, whose folders disappear.
TEST(Signals, ASweepEndsItsCasesWithIt) {
    const Folder folder("stopped_sweep");
    write_sweep(folder,
                "schema = \"sweep/1\"\nexperiment = \"exp\"\ncommand = \"simulate\"\n"
                "arguments = [\"--resolution\", \"0.005\", \"--dt\", \"0.001\"]\n" +
                    axis("material.youngs_modulus_Pa", "[2.0e4, 3.0e4]"),
                4.0);
    const ProgramRun run = run_program(
        {"sweep", folder.str("sweep.toml"), "--out", folder.str("out"), "--jobs", "2", "--json-progress"},
        "\"task\":\"sweep\"", 60.0, SIGTERM);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("stopped; finished cases are kept in " + folder.str("out")));
    EXPECT_TRUE(fs::is_empty(folder.path() / "out/cases"));
    EXPECT_FALSE(folder.has("out/sweep.json"));
}

}  // namespace
}  // namespace myo::app::signals_test
