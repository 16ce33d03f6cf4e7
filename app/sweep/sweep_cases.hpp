#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sweep/sweep_file.hpp"

namespace myo::sweep {

/// One case of a sweep, ready to run.
struct SweepCase {
    int number = 1;                         // from 1 on; the last axis changes fastest
    std::vector<std::size_t> choice = {};   // index of the value of every varied quantity
    std::string text = {};                  // experiment.toml with the values, as it reads in the experiment's folder
    std::vector<std::string> options = {};  // arguments of the sweep and options of the case
    std::uint64_t fingerprint = 0;  // of text, options, command, version and the files that the experiment reads
};

/// A sweep whose cases were all checked.
struct PreparedSweep {
    Sweep sweep;
    std::filesystem::path home;        // folder of the experiment, against which its text names files
    std::string experiment_name = {};  // as declared
    std::vector<SweepCase> cases = {};
};

/// Whether the command takes these arguments, else the parser's message; made by the program, which knows its options.
using CheckArguments = std::function<Result<void>(const std::string& command, const std::vector<std::string>&)>;

/// Makes all cases of a sweep: edits the declaration and reads every one as the command will.
///
/// @param version  of the program, for the fingerprints
/// Errors: the experiment cannot be read; a key or value that it does not know or allow, at the place in the sweep file
/// and with the case; arguments that the command refuses; a file that the experiment names cannot be read.
Result<PreparedSweep> prepare_sweep(const Sweep& sweep, const CheckArguments& check, const std::string& version);

/// Value of a varied quantity in a case, as it stands in the table: "320000", "tet10", "[0.0, 0.0, -9.81]".
std::string value_words(const Varied& varied, std::size_t index);

/// Values of a case: "material.youngs_modulus_Pa = 320000, --resolution = 0.01".
std::string case_words(const Sweep& sweep, const SweepCase& sweep_case);

}  // namespace myo::sweep
