#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "cases/case_range.hpp"
#include "report/json.hpp"

namespace myo::validation {

/// A folder that several processes fill with the records of one validation: one JSON line each in cases.jsonl, in the
/// order of completion. Finished cases are kept after an interruption and are not repeated.
class ValidationFolder {
public:
    explicit ValidationFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Checks that the folder belongs to this validation: its choice.json is equal, or is written now.
    ///
    /// @param choice  whatever decides which case a number means
    ///
    /// Errors: it holds another validation; it cannot be written.
    Result<void> claim(const report::Json& choice) const;

    /// Records by case number; of repeated numbers the last. An incomplete line of a killed process is skipped.
    ///
    /// Errors: a line is JSON, but not an object with such a number.
    Result<std::vector<report::Json>> records() const;

    /// Folder of a case, "cases/case_0007".
    std::filesystem::path case_folder(int number) const;

    /// Runs the cases of a range that have no record yet and stores theirs.
    ///
    /// @param run_case  returns the record, or null if it was cancelled; may be called from several threads
    /// @param done      called with each new record, one at a time; may be null
    /// Errors: those of records(); a record cannot be written.
    Result<void> run(const cases::CaseRange& range, const std::function<report::Json(int number)>& run_case,
                     const Progress& progress, const std::function<void(const report::Json&)>& done = {});

private:
    // Appends a record to cases.jsonl. Errors: it cannot be written completely.
    Result<void> add(const report::Json& record) const;

    std::filesystem::path folder_;
};

}  // namespace myo::validation
