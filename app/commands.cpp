#include "commands.hpp"

#include <filesystem>

namespace myo::app {
namespace {

// Global because result files record the call; written once, before any command runs.
std::vector<std::string> remembered;

}  // namespace

const std::vector<Subcommand>& commands() {
    static const std::vector<Subcommand> table{
        {"simulate", "Runs the trials of an experiment folder with its declared model", declare_simulate},
        {"calibrate", "Fits the declared unknowns of an experiment folder and reports", declare_calibrate},
        {"diagnose", "Finds the physical effect that the declared model lacks, with its parameters", declare_diagnose},
        {"power", "Tells which effects of which size an experiment could reveal, before it is made", declare_power},
        {"propose", "Proposes the trial that best tells two sets of effects apart", declare_propose},
        {"validate", "Diagnoses synthetic experiments with known answers: how reliable diagnose is", declare_validate,
         "study"},
        {"sweep", "Runs a command on many variants of an experiment; one table and figures at the end", declare_sweep},
        {"optimize", "Finds the actuation that makes the markers follow a trial's trace", declare_optimize},
        {"gradcheck", "Compares the gradient of a trial's run with differences, for every parameter",
         declare_gradcheck},
        {"mesh", "Meshes a surface, or checks a volume mesh; prints counts and quality", declare_mesh},
        {"screenshot", "Draws the workbench into a picture, without a display", declare_screenshot},
        {"reproduce", "Repeats an experiment of the paper and compares the numbers", declare_reproduce},
        {"bench", "Measures speed and memory of the solver; prints a table", declare_bench},
        {"frames", "Measures how long the workbench takes for a frame, drawn without a display", declare_frames},
        {"effects", "Lists the vocabulary of missing effects", declare_effects},
        {"info", "Prints version, libraries, threads, elements, integrators, materials", declare_info},
    };
    return table;
}

std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const Subcommand& command : commands()) names.push_back(command.name);
    return names;
}

const std::vector<std::string>& command_line() { return remembered; }

void remember_command_line(int argc, const char* const* argv) {
    remembered.assign(argv, argv + argc);
    if (!remembered.empty()) remembered.front() = std::filesystem::path(remembered.front()).filename().string();
}

}  // namespace myo::app
