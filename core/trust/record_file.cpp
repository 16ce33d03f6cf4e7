#include "trust/record_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <sstream>

#include "base/files.hpp"

namespace myo {

Result<std::vector<CaseRecord>> RecordFile::read() const {
    std::vector<CaseRecord> records;
    if (!std::filesystem::exists(file_)) return records;
    const Result<std::string> text = read_file(file_);
    if (!text) return text.error();
    std::map<int, CaseRecord> by_number;
    std::istringstream lines(*text);
    std::string line;
    for (int count = 1; std::getline(lines, line); ++count) {
        if (line.empty()) continue;
        const Json json = Json::parse(line, nullptr, false);
        const bool unfinished = lines.eof();
        Result<CaseRecord> record = json.is_discarded() ? Result<CaseRecord>(Error{"not a JSON line", ""}) : record_from_json(json);
        if (record) by_number[record->number] = std::move(*record);
        else if (!unfinished) return Error{record.error().what, file_.string() + ":" + std::to_string(count)};
    }
    for (auto& [number, record] : by_number) records.push_back(std::move(record));
    return records;
}

Result<void> RecordFile::add(const CaseRecord& record) {
    const std::string line = json_line(record_json(record)) + "\n";
    const std::lock_guard<std::mutex> lock(mutex_);
    // One write of the whole line in append mode: lines of other processes stay whole, too.
    const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    if (file < 0) return not_written(file_, errno);
    const ssize_t written = ::write(file, line.data(), line.size());
    const int reason = written < 0 ? errno : written < static_cast<ssize_t>(line.size()) ? ENOSPC : 0;
    ::close(file);
    return reason == 0 ? Result<void>() : not_written(file_, reason);
}

}  // namespace myo
