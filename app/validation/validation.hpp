#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "validation/case_record.hpp"
#include "validation/validation_folder.hpp"

namespace myo::validation {

/// Which cases are validated, and with which settings of the diagnosis.
struct ValidationOptions {
    CaseChoice choice;
    cases::CaseRange range;
    diagnosis::DiagnoseSettings diagnose;  // `without` and `fits` are set per case
};

/// Makes the experiment of a case in `folder`, reads and diagnoses it like any other, and compares the answer with the
/// truth.
///
/// The folder also receives truth.json, which no reader uses, and report.json of the diagnosis.
/// Errors: none; see CaseRecord::failure, "cancelled" after cancellation.
CaseRecord run_case(const ValidationOptions& options, int number, const std::filesystem::path& folder,
                    const Progress& progress = {});

/// Runs the cases that have no record in `out`/cases.jsonl and appends theirs; experiments are in `out`/cases/.
/// Finished cases are kept after cancellation.
///
/// @param done  called with each new record, one at a time; may be null
/// Errors: the folder cannot be written, or holds a validation of another choice.
Result<void> run_validation(const ValidationOptions& options, const std::filesystem::path& out,
                            const Progress& progress = {}, const std::function<void(const CaseRecord&)>& done = {});

/// All records of a folder. Errors: a line cannot be read.
Result<std::vector<CaseRecord>> validation_records(const std::filesystem::path& out);

}  // namespace myo::validation
