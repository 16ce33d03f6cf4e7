#pragma once

#include <optional>
#include <string>
#include <vector>

namespace myo::cases {

/// Every n-th of many cases, for n processes on one folder.
struct Share {
    int part = 0, parts = 1;  // cases with number % parts == part
};

/// Parses "1/4", the first of four shares, to part 0 of 4; empty if the text is no share.
std::optional<Share> parse_share(const std::string& text);

/// Cases that this process runs, and how many at a time.
struct CaseRange {
    int first = 0, cases = 24;  // numbers first ... first + cases - 1
    Share share;                // of these
    int threads = 1;            // cases in parallel, one thread each
};

/// Failure of a case that was cancelled; it counts as not run.
inline const std::string cancelled_words = "cancelled";

/// Numbers of the cases of a range, ascending. Shares interleave, so that processes started together finish together.
std::vector<int> numbers_of(const CaseRange& range);

}  // namespace myo::cases
