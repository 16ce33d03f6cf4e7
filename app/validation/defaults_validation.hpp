#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "validation/defaults_record.hpp"
#include "validation/validation_folder.hpp"

namespace myo::validation {

/// Validation of the defaults: experiments of all sizes, moduli and cameras, a third of them with a declaration error.
struct DefaultsValidationOptions {
    std::uint64_t seed = 1;
    // Cases that this process runs.
    cases::CaseRange range;
};

/// Makes the experiment of a case in `folder`, reads it and calibrates it with default options.
///
/// The folder also receives truth.json, which no reader uses.
/// Errors: none; see DefaultsRecord::failure, "cancelled" after cancellation.
DefaultsRecord run_defaults_case(std::uint64_t seed, int number, const std::filesystem::path& folder,
                                 const Progress& progress = {});

/// Runs all cases of the range that have no record in `out`.
///
/// @param done  called with each new record, one at a time; may be null
/// Errors: the folder cannot be written, or holds another validation.
Result<void> run_defaults_validation(const DefaultsValidationOptions& options, const std::filesystem::path& out,
                                     const Progress& progress = {},
                                     const std::function<void(const DefaultsRecord&)>& done = {});

/// All records of a folder, by case number. Errors: one cannot be read.
Result<std::vector<DefaultsRecord>> defaults_records(const std::filesystem::path& out);

}  // namespace myo::validation
