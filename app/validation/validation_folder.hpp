#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "report/json.hpp"

namespace myo::validation {

/// Which of the numbered cases of a study are run by this process, and how many at a time.
struct CaseRange {
    int first = 0, cases = 24;  // numbers first ... first + cases - 1
    int share = 0, shares = 1;  // of these the ones with number % shares == share
    int threads = 1;            // cases side by side, one thread each
};

/// A folder that several processes fill with the records of one study, one JSON line each in cases.jsonl, in the order
/// in which they were finished. What is finished stays when a study is stopped, and is not repeated.
class ValidationFolder {
public:
    explicit ValidationFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Sees that the folder is this study's: its choice.json says the same, or is written now.
    /// Errors: it holds another study; it cannot be written.
    Result<void> claim(const report::Json& choice) const;

    /// The records there, by their "case", the last of a number counting. A line that a killed process left unfinished
    /// is passed over. Error: a line is JSON, but not an object with such a number.
    Result<std::vector<report::Json>> records() const;

    /// "case_0007" in its folder of cases.
    std::filesystem::path case_folder(int number) const;

    /// Runs the cases of a range that have no record yet, and keeps theirs. A case that was cancelled gives a null
    /// record, which is not kept.
    /// @param done  called with each new record, one at a time; may be null
    /// Errors: of records(); a record cannot be written.
    Result<void> run(const CaseRange& range, const std::function<report::Json(int number)>& run_case,
                     const Progress& progress, const std::function<void(const report::Json&)>& done = {});

private:
    Result<void> add(const report::Json& record) const;

    std::filesystem::path folder_;
};

}  // namespace myo::validation
