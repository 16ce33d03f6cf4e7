#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "toml/toml_value.hpp"

namespace myo::sweep {

/// Limits of a sweep.
struct SweepPolicy {
    std::size_t most_cases = 10000;  // each is a folder; more is a typing error
    std::size_t most_curves = 8;     // in a figure; the colours of a chart end there
    double grace_s = 30.0;           // for a cancelled case to end by itself; Slurm waits as long before it kills
    int value_digits = 12;           // of the values between `from` and `to`, so that they read well
};

/// Command that is run on every case.
enum class CaseCommand { simulate, calibrate, diagnose, optimize };
/// Word of the command line.
std::string to_string(CaseCommand command);

/// Something that a sweep varies: a key of the experiment, or an option of the command.
struct Varied {
    std::string name;                     // "material.youngs_modulus_Pa", "--resolution"
    std::vector<toml::TomlValue> values;  // at least one
    bool logarithmic = false;             // values are spaced by a factor
    bool together = false;                // takes its k-th value where the one before it does
    std::string where;                    // "sweep.toml:7"
    bool is_option() const { return name.starts_with("--"); }
};

/// Content of a sweep file.
struct Sweep {
    std::filesystem::path file;
    std::filesystem::path experiment;  // folder or .toml file
    CaseCommand command = CaseCommand::simulate;
    std::vector<std::string> arguments;  // of the command, in every case
    std::vector<Varied> varied;          // the first changes slowest; seeds are the last, as option --seed
};

/// Reads a sweep file (schema sweep/1).
///
/// Errors, with file, line and key: unknown keys, an axis without values or with values that no file can hold, values
/// that move together but differ in number, options that the sweep sets itself, too many cases.
Result<Sweep> read_sweep(const std::filesystem::path& file, const SweepPolicy& policy = {});

/// Numbers of values of the axes of the grid, the slowest first: quantities that move together are one axis.
std::vector<std::size_t> axis_sizes(const Sweep& sweep);

/// Number of cases: the product of the axes; 1 without any.
std::size_t case_count(const Sweep& sweep);

}  // namespace myo::sweep
