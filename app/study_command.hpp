#pragma once

#include <filesystem>
#include <string>

#include "base/stopwatch.hpp"
#include "console.hpp"
#include "options.hpp"
#include "project/output_json.hpp"
#include "project/study.hpp"

// What the commands on an experiment folder have in common.

namespace myo {

struct StudyCall {
    std::filesystem::path experiment;
    std::filesystem::path out;
    bool writes_folder = true;   // false: the command has no --out
    WorkOptions work;
    StudyOptions study;
};
void declare_study_call(CLI::App& app, StudyCall& call);

/// Reads the experiment and makes sure that results can be written; nothing long yet.
/// Errors: the call's, the input's, or those of the output folder.
Result<Experiment> open_experiment(const StudyCall& call);

/// prepare_study() with limits that keep a slip of the keyboard from filling the memory, and with check_integration().
/// Errors: the input's; --resolution or --dt that would make more than the memory holds.
Result<Study> open_study(const StudyCall& call, const Experiment& experiment, const Progress& progress);

RunFacts run_facts(const StudyCall& call, double setup_s);

/// "damping 3 ms is assumed, for none is declared", or empty.
std::string assumed_damping(const Study& study);

/// "  0.312" for 3.12e-4 m; "-" when there is no number.
std::string in_millimetres(double metres);

}  // namespace myo
