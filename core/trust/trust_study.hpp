#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "trust/case_record.hpp"
#include "trust/study_folder.hpp"

namespace myo {

/// Which cases of a choice are taken, and how.
struct TrustStudyOptions {
    CaseChoice choice;
    CaseRange range;
    DiagnoseSettings diagnose;          // `without` and `fits` are the case's own
};

/// Makes the experiment of a case in `folder`, reads and diagnoses it as any other, and judges the answer. A cancelled one has the failure
/// "cancelled". Beside the experiment it leaves truth.json, which nothing reads, and the diagnosis's report.json.
CaseRecord run_case(const TrustStudyOptions& options, int number, const std::filesystem::path& folder, const Progress& progress = {});

/// Runs the cases that `out`/cases.jsonl does not have yet, and adds them to it; experiments are in `out`/cases/. What is finished stays when
/// it is cancelled. done: called with each new record, one at a time; may be null.
/// Errors: the folder cannot be written, or holds a study of another choice.
Result<void> run_trust_study(const TrustStudyOptions& options, const std::filesystem::path& out, const Progress& progress = {},
                             const std::function<void(const CaseRecord&)>& done = {});

/// All records that a folder holds. Error: a line of it cannot be read.
Result<std::vector<CaseRecord>> trust_records(const std::filesystem::path& out);

}  // namespace myo
