#include "validation/validation_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/files.hpp"
#include "base/parallel.hpp"

namespace myo::validation {
namespace {

const char* const records_name = "cases.jsonl";
const char* const choice_name = "choice.json";

/// Whether the file does not end with a newline, because a process was killed while writing.
bool ends_unfinished(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file || file.tellg() == 0) return false;
    file.seekg(-1, std::ios::end);
    return file.get() != '\n';
}

}  // namespace

Result<void> ValidationFolder::claim(const report::Json& choice) const {
    const std::filesystem::path file = folder_ / choice_name;
    if (!std::filesystem::exists(file)) return report::write_json(file, choice);
    const Result<report::Json> there = report::read_json(file);
    if (!there) return there.error();
    if (*there == choice) return {};
    return Error{"holds cases of another choice, " + report::json_line(*there) +
                     "; choose another folder, or the same study, seed, geometry and effects",
                 folder_.string()};
}

Result<std::vector<report::Json>> ValidationFolder::records() const {
    std::vector<report::Json> records;
    const std::filesystem::path file = folder_ / records_name;
    if (!std::filesystem::exists(file)) return records;
    const Result<std::string> text = read_file(file);
    if (!text) return text.error();
    std::map<int, report::Json> by_number;
    std::istringstream lines(*text);
    std::string line;
    for (int count = 1; std::getline(lines, line); ++count) {
        if (line.empty()) continue;
        report::Json json = report::Json::parse(line, nullptr, false);
        if (json.is_discarded()) continue;  // incomplete line
        if (!json.is_object() || !json.contains("case") || !json.at("case").is_number_integer())
            return Error{"is not the record of a case", file.string() + ":" + std::to_string(count)};
        const int number = json.at("case").get<int>();
        // A repeated number replaces the earlier record.
        by_number[number] = std::move(json);
    }
    for (auto& [number, record] : by_number) records.push_back(std::move(record));
    return records;
}

std::filesystem::path ValidationFolder::case_folder(int number) const {
    char name[24];
    std::snprintf(name, sizeof name, "case_%04d", number);
    return folder_ / "cases" / name;
}

Result<void> ValidationFolder::run(const cases::CaseRange& range,
                                   const std::function<report::Json(int number)>& run_case, const Progress& progress,
                                   const std::function<void(const report::Json&)>& done) {
    const Result<std::vector<report::Json>> there = records();
    if (!there) return there.error();
    std::set<int> finished;
    for (const report::Json& record : *there) finished.insert(record.at("case").get<int>());
    std::vector<int> numbers;
    for (const int number : cases::numbers_of(range))
        if (finished.count(number) == 0) numbers.push_back(number);

    std::mutex mutex;
    int count = 0;
    // After a failed write the other cases are still run; the error is returned at the end.
    Result<void> trouble;
    const auto total = static_cast<double>(numbers.size());
    progress.report({"study", 0.0, total, "cases", {}});
    parallel_tasks(static_cast<int>(numbers.size()), range.threads, [&](int task) {
        if (progress.cancelled()) return;
        const report::Json record = run_case(numbers[static_cast<std::size_t>(task)]);
        if (record.is_null()) return;
        // Lines, progress and `done` come one at a time.
        const std::lock_guard<std::mutex> lock(mutex);
        if (const Result<void> kept = add(record); !kept) trouble = kept;
        progress.report({"study", static_cast<double>(++count), total, "cases", {}});
        if (done) done(record);
    });
    return trouble;
}

Result<void> ValidationFolder::add(const report::Json& record) const {
    const std::filesystem::path path = folder_ / records_name;
    const std::string line = (ends_unfinished(path) ? "\n" : "") + report::json_line(record) + "\n";
    // A single write in append mode keeps lines of concurrent processes intact.
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    if (file < 0) return not_written(path, errno);
    const ssize_t written = ::write(file, line.data(), line.size());
    const int reason = written < 0 ? errno : written < static_cast<ssize_t>(line.size()) ? ENOSPC : 0;
    ::close(file);
    return reason == 0 ? Result<void>() : not_written(path, reason);
}

}  // namespace myo::validation
