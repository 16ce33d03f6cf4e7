#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "validation/defaults_record.hpp"
#include "validation/validation_folder.hpp"

namespace myo::validation {

/// Experiments of all sizes, moduli and cameras, a third of them declared with a slip, calibrated with the defaults.
struct DefaultsValidationOptions {
    std::uint64_t seed = 1;
    CaseRange range;
};

/// Makes the experiment of a case in `folder`, reads and calibrates it as any other with nothing but defaults. A
/// cancelled one has the failure "cancelled". Beside the experiment it leaves truth.json, which nothing reads.
DefaultsRecord run_defaults_case(std::uint64_t seed, int number, const std::filesystem::path& folder,
                                 const Progress& progress = {});

/// Runs the cases that `out` has no record of yet. done: called with each new record, one at a time; may be null.
/// Errors: the folder cannot be written, or holds another study.
Result<void> run_defaults_validation(const DefaultsValidationOptions& options, const std::filesystem::path& out,
                                     const Progress& progress = {},
                                     const std::function<void(const DefaultsRecord&)>& done = {});

/// All records that a folder holds. Error: one cannot be read.
Result<std::vector<DefaultsRecord>> defaults_records(const std::filesystem::path& out);

}  // namespace myo::validation
