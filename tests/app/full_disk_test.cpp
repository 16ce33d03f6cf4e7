#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

// A disk that fills keeps what was found, and says why.

namespace myo::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* full = "No space left on device";

/// Runs through a shell, with its standard output where `redirection` leads.
ProgramRun run_redirected(const Folder& folder, const std::string& arguments, const std::string& redirection) {
    const std::string program = (fs::path(MYOLOOP_BINARY_DIR) / "myoloop").string();
    const std::string command = "'" + program + "' " + arguments + " 2>'" + folder.str("err") + "' " + redirection;
    ProgramRun run;
    const int status = std::system(command.c_str());
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.err = content_of(folder.path() / "err");
    return run;
}

TEST(FullDisk, StandardOutputThatCannotBeWrittenFailsEveryCommand) {
    const Folder folder("full_output");
    write_small_experiment(folder);
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    const std::string coarse = " --resolution 0.01 --dt 0.005", exp = "'" + folder.str("exp") + "'",
                      out = "'" + folder.str("out") + "'";
    for (const std::string& arguments :
         {std::string("info"), std::string("effects"), std::string("--help"), std::string("--version"),
          std::string("reproduce"), "gradcheck " + exp + " --steps 2" + coarse,
          "simulate " + exp + " --out " + out + coarse,
          "mesh '" + folder.str("box.stl") + "' --unit mm --type hex8 --resolution 0.01",
          "mesh '" + folder.str("box.stl") + "' --unit mm --type hex8 --resolution 0.01 --json"}) {
        const ProgramRun run = run_redirected(folder, arguments, ">/dev/full");
        EXPECT_EQ(run.status, 1) << arguments << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr("myoloop: standard output cannot be written: No space left on device\n"))
            << arguments;
        const ProgramRun closed = run_redirected(folder, arguments, ">&-");
        EXPECT_EQ(closed.status, 1) << arguments << "\n" << closed.err;
        EXPECT_THAT(closed.err, HasSubstr("myoloop: standard output cannot be written: Bad file descriptor\n"))
            << arguments;
    }
    // The files of a run are whole all the same, with nothing of what was printed in them.
    EXPECT_TRUE(nlohmann::json::accept(content_of(folder.path() / "out/simulate.json")));
}

struct Fills {
    const char* command;
    const char* first;    // the file that is written first
    const char* second;   // which does not fit any more
    const char* printed;  // a value found, on standard output
};

class FilledFolder : public ::testing::TestWithParam<Fills> {};

/// The second file leads to a device that is full; the first is there by then, and the values are printed.
TEST_P(FilledFolder, KeepsWhatWasFound) {
    const Folder folder("full_" + std::string(GetParam().command));
    const bool muscled = GetParam().command == std::string("optimize");
    if (!muscled) write_small_experiment(folder);
    if (muscled) {
        folder.write("exp/experiment.toml", muscled_toml());
        folder.write("exp/wave.csv", small_trace());
        folder.write("exp/signals.csv", "time_s,upper\n0,1\n0.1,1.1\n");
    }
    fs::create_directories(folder.path() / "out");
    fs::create_symlink("/dev/full", folder.path() / "out" / GetParam().second);
    std::vector<std::string> arguments{
        GetParam().command, folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01", "--dt", "0.005"};
    if (muscled) arguments.insert(arguments.end(), {"--max-evaluations", "3"});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(std::string(GetParam().second) + ": cannot be written: " + full));
    EXPECT_THAT(run.out, HasSubstr(GetParam().printed));
    EXPECT_TRUE(nlohmann::json::accept(content_of(folder.path() / "out" / GetParam().first)));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "out" / GetParam().second));
}

INSTANTIATE_TEST_SUITE_P(All, FilledFolder,
                         ::testing::Values(Fills{"simulate", "simulate.json", "drop.csv", "rms [mm]"},
                                           Fills{"calibrate", "calibrate.json", "drop.csv", "youngs_modulus"},
                                           Fills{"optimize", "optimize.json", "wave_actuation.csv", "signal upper"}),
                         [](const auto& one) { return std::string(one.param.command); });

TEST(FullDisk, OptionsThatNameAFileFailAsWell) {
    const Folder folder("full_file");
    write_small_experiment(folder);
    const ProgramRun check = run_program(
        {"gradcheck", folder.str("exp"), "--resolution", "0.01", "--steps", "2", "--json", "/dev/full"});
    EXPECT_EQ(check.status, 1);
    EXPECT_THAT(check.err, HasSubstr(std::string("/dev/full: cannot be written: ") + full));
    EXPECT_THAT(check.out, HasSubstr("Young's modulus"));
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    fs::create_symlink("/dev/full", folder.path() / "box.vtu");
    const ProgramRun mesh = run_program({"mesh", folder.str("box.stl"), "--unit", "mm", "--type", "hex8",
                                         "--resolution", "0.01", "--out", folder.str("box.vtu")});
    EXPECT_EQ(mesh.status, 1);
    EXPECT_THAT(mesh.err, HasSubstr(std::string("box.vtu: cannot be written: ") + full));
    EXPECT_THAT(mesh.out, HasSubstr("8 hex8 elements"));
}

}  // namespace
}  // namespace myo::test
