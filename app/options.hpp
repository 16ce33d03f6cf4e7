#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "setup/setup.hpp"

namespace myo::app {

/// What every command that works for a while takes.
struct WorkOptions {
    int threads = 0;                    // 0: all that the hardware has
    std::optional<std::uint64_t> seed;  // of random starts; recorded
    bool quiet = false;
    bool json_progress = false;
};
void add_work_options(CLI::App& app, WorkOptions& options);

/// How an experiment is simulated.
struct SetupOptions {
    setup::SetupSettings settings;  // threads and the spectral radius are set by setup_settings()
    std::optional<double> spectral_radius;
    std::vector<std::pair<std::string, std::string>> overrides;  // --set
};
void add_setup_options(CLI::App& app, SetupOptions& options);
setup::SetupSettings setup_settings(const SetupOptions& options, const WorkOptions& work);

/// Options whose values are checked with one sentence that names the option: "--dt: 'x' is not a number".
CLI::Option* add_positive_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& help);
CLI::Option* add_optional_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help);
CLI::Option* add_count(CLI::App& app, const std::string& name, int& target, const std::string& help);
CLI::Option* add_element(CLI::App& app, const std::string& name, std::optional<fem::ElementKind>& target);

/// --unit mm|m, as the length in metres.
CLI::Option* add_unit(CLI::App& app, std::optional<double>& metres_per_unit);

/// "'voxel' is not known; did you mean 'x'? Known: a, b, c"
std::string unknown_word(const std::string& word, const std::vector<std::string>& known);

/// "a,b" -> {"a", "b"}; blanks around the words are dropped, empty words stay.
std::vector<std::string> split_words(const std::string& text);

}  // namespace myo::app
