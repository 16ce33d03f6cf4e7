#include "support/corpus.hpp"

#include <gtest/gtest.h>

#include "support/folder.hpp"
#include "validation/validation.hpp"
#include "validation/validation_summary.hpp"

namespace myo::validation {
namespace {

/// A folder of `myoloop study` is continued: its choice is recognised, and finished cases are not repeated.
TEST(Corpus, FolderOfAStudyIsContinued) {
    const test::Folder folder("former_study");
    for (const char* file : {"choice.json", "cases.jsonl"})
        std::filesystem::copy(test::corpus("study") / file, folder.path());
    ValidationOptions options;
    options.choice = {.seed = 2, .families = {BodyFamily::beam}, .effects = {"quadratic_drag", "point_mass"}};
    options.range.first = 1;
    options.range.cases = 2;
    int done = 0;
    const Result<void> run = run_validation(options, folder.path(), {}, [&](const CaseRecord&) { ++done; });
    ASSERT_TRUE(run) << run.error().text();
    EXPECT_EQ(done, 0);

    const Result<std::vector<CaseRecord>> records = validation_records(folder.path());
    ASSERT_TRUE(records) << records.error().text();
    ASSERT_EQ(records->size(), 2u);
    std::istringstream lines(*read_file(test::corpus("study/cases.jsonl")));
    std::string line;
    for (int k = 0; std::getline(lines, line); ++k) {
        const nlohmann::json held = nlohmann::json::parse(line);
        const CaseRecord& record = (*records)[static_cast<std::size_t>(held.at("case").get<int>() - 1)];
        // Written again, the record has the same keys and values.
        const nlohmann::json again = nlohmann::json::parse(report::json_line(record_json(record)));
        for (const auto& [key, value] : held.items()) EXPECT_EQ(again.at(key), value) << key;
    }
    // Figures of the summary, which `study.json` held.
    const nlohmann::json summary = nlohmann::json::parse(report::json_line(summary_json(validation_summary(*records))));
    test::expect_keys_of(summary, "study/study.json");
    EXPECT_EQ(summary.at("cases"), test::corpus_json("study/study.json").at("cases"));
}

}  // namespace
}  // namespace myo::validation
