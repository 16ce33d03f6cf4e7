#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "cases/case_range.hpp"
#include "setup/setup.hpp"

namespace myo::app {

/// Options of every command that computes for a while.
struct WorkOptions {
    int threads = 0;                    // 0: all hardware threads
    std::optional<std::uint64_t> seed;  // of random starts; recorded in results
    bool quiet = false;
    bool json_progress = false;  // progress as JSON lines on standard error
};
/// Adds --quiet and --json-progress.
void add_console_options(CLI::App& app, WorkOptions& options);
/// Adds --threads, --seed and the options of add_console_options().
void add_work_options(CLI::App& app, WorkOptions& options);

/// Options on how an experiment is simulated.
struct SetupOptions {
    setup::SetupSettings settings;  // threads and spectral radius are set by setup_settings()
    // Spectral radius of generalised-alpha at infinite frequency, 0 ... 1; empty: the default.
    std::optional<double> spectral_radius;
    std::vector<std::pair<std::string, std::string>> overrides;  // keys and values of --set
};
/// Adds options of mesh, material and time integration, --as-published and --set.
void add_setup_options(CLI::App& app, SetupOptions& options);
/// Settings of the core from all parsed options, with the number of threads resolved.
setup::SetupSettings setup_settings(const SetupOptions& options, const WorkOptions& work);

// Options whose values are checked with a single sentence that names the option: "--dt: 'x' is not a number". The
// target must outlive parsing.

/// A number > 0.
CLI::Option* add_positive_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help);
/// A finite number; add_optional_number() leaves its target empty without the option.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& help);
CLI::Option* add_optional_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help);
/// A whole number >= 1.
CLI::Option* add_count(CLI::App& app, const std::string& name, int& target, const std::string& help);
/// An element by its id.
CLI::Option* add_element(CLI::App& app, const std::string& name, std::optional<fem::ElementKind>& target);

/// Ids of effects of the catalogue out of "A,B". Throws CLI::ValidationError under the name of the option for an
/// unknown one; laws of an experiment are unknown here, see add_named_effects().
std::vector<std::string> effect_list(const std::string& option, const std::string& text);
/// A list of effects of the catalogue, "A,B".
CLI::Option* add_effect_list(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                             const std::string& help);

/// --share I/N: the I-th (from 1) of N disjoint shares of the cases, see cases::Share.
CLI::Option* add_share(CLI::App& app, cases::Share& share);

/// --unit mm|m, stored as metres per unit.
CLI::Option* add_unit(CLI::App& app, std::optional<double>& metres_per_unit);

/// Message "'voxel' is not known; did you mean 'x'? Known: a, b, c".
std::string unknown_word(const std::string& word, const std::vector<std::string>& known);

/// Message for arguments that a command leaves over: an unknown option, or one argument too many. There is at least one
/// such argument.
std::string surplus_arguments(const CLI::App& app);

/// Splits at commas: "a,b" -> {"a", "b"}; surrounding blanks are removed, empty words are kept.
std::vector<std::string> split_words(const std::string& text);

}  // namespace myo::app
