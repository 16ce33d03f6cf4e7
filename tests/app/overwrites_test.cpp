#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

// No option of a command that writes replaces a file that the command reads.

namespace myo::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// One sentence with the option and the file, exit status 2, and the file as it was.
void expect_refused(const std::vector<std::string>& arguments, const std::string& option, const fs::path& file) {
    const std::string before = content_of(file);
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("myoloop: " + option + ": "));
    EXPECT_THAT(run.err, HasSubstr(file.filename().string() + " is read as input"));
    EXPECT_EQ(content_of(file), before);
}

/// The experiment of small_experiment.hpp with its trace under another name, which a command would give to a result.
void write_with_trace(const Folder& folder, const std::string& trace) {
    folder.write("exp/experiment.toml", std::regex_replace(small_toml(), std::regex("drop\\.csv"), trace));
    folder.write("exp/" + trace, small_trace());
}

struct Writes {
    const char* command;
    std::vector<std::string> options;
    std::vector<std::string> results;  // names in --out, as the command gives them
};

class ResultsInAFolder : public ::testing::TestWithParam<Writes> {};

TEST_P(ResultsInAFolder, ReplaceNoInput) {
    for (const std::string& result : GetParam().results) {
        const Folder folder("overwrites_" + std::string(GetParam().command));
        write_with_trace(folder, result);
        std::vector<std::string> arguments{GetParam().command, folder.str("exp"), "--out", folder.str("exp")};
        arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
        expect_refused(arguments, "--out", folder.path() / "exp" / result);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, ResultsInAFolder,
    ::testing::Values(Writes{"simulate",
                             {"--vtu"},
                             {"drop.csv", "drop_again.csv", "simulate.json", "drop.pvd", "drop_frames/0003.vtu"}},
                      Writes{"calibrate", {}, {"drop.csv", "calibrate.json", "report.html"}},
                      Writes{"optimize", {}, {"drop.csv", "optimize.json", "report.html", "drop_actuation.csv"}},
                      Writes{"diagnose",
                             {},
                             {"drop.csv", "report.json", "exp.json", "report.html", "experiment_augmented.toml",
                              "diagnose_fits.json"}}),
    [](const auto& one) { return std::string(one.param.command); });

TEST(Overwrites, TheDeclarationThatIsReadStays) {
    const Folder folder("overwrites_declared");
    write_with_trace(folder, "traces/measured.csv");
    fs::copy_file(folder.path() / "exp/experiment.toml", folder.path() / "exp/experiment_augmented.toml");
    fs::create_directories(folder.path() / "out");
    fs::create_symlink(folder.path() / "exp/experiment.toml", folder.path() / "out/simulate.json");
    const std::string augmented = folder.str("exp/experiment_augmented.toml");
    expect_refused({"diagnose", augmented, "--out", folder.str("exp")}, "--out", augmented);
    expect_refused({"simulate", folder.str("exp"), "--out", folder.str("out")}, "--out",
                   folder.path() / "out/simulate.json");
}

/// Told before the diagnosis, which may take hours.
TEST(Overwrites, AFolderInThePlaceOfKeptFitsStays) {
    const Folder folder("overwrites_fits");
    write_small_experiment(folder);
    folder.write("out/diagnose_fits.json/notes.txt", "mine");
    const ProgramRun run = run_program(
        {"diagnose", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01", "--dt", "0.005"});
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_THAT(run.err, HasSubstr(folder.str("out/diagnose_fits.json") + ": cannot be removed: Directory not empty"));
    EXPECT_EQ(content_of(folder.path() / "out/diagnose_fits.json/notes.txt"), "mine");
}

TEST(Overwrites, GradcheckKeepsEveryFileOfTheExperiment) {
    const Folder folder("overwrites_gradcheck");
    std::string text = muscled_toml();
    text = std::regex_replace(text, std::regex("kind = \"box\"\nsize_m = .*"),
                              "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"mm\"");
    folder.write("exp/experiment.toml", text);
    folder.write("exp/body.stl", box_stl(40.0, 20.0, 20.0));
    folder.write("exp/wave.csv", small_trace());
    folder.write("exp/signals.csv", "time_s,upper\n0,1\n0.1,1.1\n");
    for (const char* const file : {"experiment.toml", "body.stl", "wave.csv", "signals.csv"})
        expect_refused({"gradcheck", folder.str("exp"), "--json", folder.str(std::string("exp/../exp/") + file)},
                       "--json", folder.path() / "exp" / file);
}

TEST(Overwrites, MeshKeepsItsMesh) {
    const Folder folder("overwrites_mesh");
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    ASSERT_EQ(run_program({"mesh", folder.str("box.stl"), "--unit", "mm", "--type", "tet4", "--resolution", "0.01",
                           "--out", folder.str("box.vtu"), "--quiet"})
                  .status,
              0);
    fs::create_symlink("box.vtu", folder.path() / "link.vtu");
    expect_refused({"mesh", folder.str("box.vtu"), "--unit", "m", "--out", folder.str("box.vtu")}, "--out",
                   folder.path() / "box.vtu");
    expect_refused({"mesh", folder.str("box.vtu"), "--unit", "m", "--out", folder.str("link.vtu")}, "--out",
                   folder.path() / "link.vtu");
}

TEST(Overwrites, ScreenshotKeepsWhatItDraws) {
    const Folder folder("overwrites_screenshot");
    write_small_experiment(folder);
    folder.write("recording.csv", small_trace());
    for (const char* const file : {"exp/experiment.toml", "exp/drop.csv", "recording.csv"}) {
        fs::remove(folder.path() / "x.png");
        fs::create_symlink(file, folder.path() / "x.png");
        expect_refused(
            {"screenshot", folder.str("exp"), "--import", folder.str("recording.csv"), "--out", folder.str("x.png")},
            "--out", folder.path() / "x.png");
    }
}

TEST(Overwrites, BenchAndReproduceKeepTheMeasurements) {
    const Folder folder("overwrites_data");
    folder.write("design/reference/beam.csv", "t,x\n0,0\n");
    folder.write("data/mocap/beam/report.html", "a recording");
    const char* const named = std::getenv("MYOLOOP_DATA");
    const std::string before = named != nullptr ? named : "";
    ::setenv("MYOLOOP_DATA", folder.path().c_str(), 1);
    const fs::path read = folder.path() / "design/reference/beam.csv";
    for (const char* const option : {"--json", "--figure"})
        expect_refused({"bench", "release", option, read.string()}, option, read);
    const fs::path measured = folder.path() / "data/mocap/beam";
    expect_refused({"reproduce", "beam-static", "--coarse", "--out", measured.string()}, "--out",
                   measured / "report.html");
    if (named != nullptr)
        ::setenv("MYOLOOP_DATA", before.c_str(), 1);
    else
        ::unsetenv("MYOLOOP_DATA");
}

}  // namespace
}  // namespace myo::test
