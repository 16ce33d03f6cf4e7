#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "validation/case_record.hpp"
#include "validation/validation_folder.hpp"

namespace myo::validation {

/// Which cases of a choice are taken, and how.
struct ValidationOptions {
    CaseChoice choice;
    CaseRange range;
    diagnosis::DiagnoseSettings diagnose;  // `without` and `fits` are the case's own
};

/// Makes the experiment of a case in `folder`, reads and diagnoses it as any other, and judges the answer. A cancelled
/// one has the failure "cancelled". Beside the experiment it leaves truth.json, which nothing reads, and the
/// diagnosis's report.json.
CaseRecord run_case(const ValidationOptions& options, int number, const std::filesystem::path& folder,
                    const Progress& progress = {});

/// Runs the cases that `out`/cases.jsonl does not have yet, and adds them to it; experiments are in `out`/cases/. What
/// is finished stays when it is cancelled. done: called with each new record, one at a time; may be null. Errors: the
/// folder cannot be written, or holds a study of another choice.
Result<void> run_validation(const ValidationOptions& options, const std::filesystem::path& out,
                            const Progress& progress = {}, const std::function<void(const CaseRecord&)>& done = {});

/// All records that a folder holds. Error: a line of it cannot be read.
Result<std::vector<CaseRecord>> validation_records(const std::filesystem::path& out);

}  // namespace myo::validation
