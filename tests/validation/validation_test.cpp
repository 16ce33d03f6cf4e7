#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"
#include "validation/synthetic_effects.hpp"
#include "validation/truth_model.hpp"
#include "validation/validation.hpp"
#include "validation/validation_summary.hpp"

namespace myo::test {
namespace {

/// A case without an effect and one with drag.
validation::ValidationOptions small_validation() {
    validation::ValidationOptions options;
    options.choice = {.seed = 1, .families = {validation::BodyFamily::beam}, .effects = {"quadratic_drag"}};
    options.range.cases = 2;
    options.range.threads = 2;
    options.diagnose.refits = 3;
    options.diagnose.extensions = 0;
    return options;
}

void expect_another_model(const validation::CaseChoice& choice, int number, const std::filesystem::path& folder) {
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder);
    ASSERT_TRUE(experiment) << experiment.error().text();
    const Result<setup::Setup> diagnosed = setup::prepare_setup(*experiment, {}),
                               truth = validation::truth_setup(validation::drawn_case(choice, number), *experiment);
    ASSERT_TRUE(diagnosed && truth);
    EXPECT_NE(diagnosed->mesh.element, truth->mesh.element);
    EXPECT_GT(truth->body->dofs(), 2 * diagnosed->body->dofs());
    EXPECT_LT(truth->trials.front().options.h_s, 0.51 * diagnosed->trials.front().options.h_s);
    EXPECT_NE(truth->settings.integrator, diagnosed->settings.integrator);
    EXPECT_EQ(truth->trials.size(), diagnosed->trials.size());
}

TEST(Validation, ASmallOneIsAnsweredRightAndNotRepeated) {
    const Folder folder("validation");
    const validation::ValidationOptions options = small_validation();
    int done = 0;
    const Result<void> run = validation::run_validation(options, folder.path(), {},
                                                        [&](const validation::CaseRecord&) { ++done; });
    ASSERT_TRUE(run) << run.error().text();
    EXPECT_EQ(done, 2);
    const Result<std::vector<validation::CaseRecord>> records = validation::validation_records(folder.path());
    ASSERT_TRUE(records) << records.error().text();
    ASSERT_EQ(records->size(), 2u);
    for (const validation::CaseRecord& record : *records) {
        const std::string what = record.truth + ": " + report::json_line(validation::record_json(record));
        ASSERT_TRUE(record.answered()) << what;
        EXPECT_TRUE(record.right()) << what;
        EXPECT_GT(record.confidence, 0.5) << what;
        EXPECT_LT(record.after_over_noise, 1.5) << what;  // another simulator, and a trial that was not fitted
        if (record.kind != validation::CaseKind::named) continue;
        EXPECT_GT(record.level, validation::min_fitted) << what;
        EXPECT_LT(record.level, validation::max_level) << what;
        EXPECT_GT(record.before_over_noise, record.after_over_noise) << what;
        for (const validation::ParameterError& error : record.errors)
            EXPECT_LT(error.relative, 0.2) << error.name << " " << what;
        RecordProperty(record.truth + "_diagnose_s", std::to_string(record.diagnose_s));
    }
    expect_another_model(options.choice, 0, folder.path() / "cases" / "case_0000");
    // All is there: nothing is done again.
    ASSERT_TRUE(validation::run_validation(options, folder.path(), {}, [&](const validation::CaseRecord&) { ++done; }));
    EXPECT_EQ(done, 2);
    // Another seed does not belong in this folder.
    validation::ValidationOptions other = options;
    other.choice.seed = 2;
    const Result<void> refused = validation::run_validation(other, folder.path());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("\"seed\":1"), std::string::npos) << refused.error().what;
}

TEST(Validation, OneThatIsCancelledKeepsNothingUnfinished) {
    const Folder folder("validation_cancelled");
    std::atomic<bool> cancel{true};
    ASSERT_TRUE(validation::run_validation(small_validation(), folder.path(), Progress({}, &cancel)));
    const Result<std::vector<validation::CaseRecord>> records = validation::validation_records(folder.path());
    ASSERT_TRUE(records);
    EXPECT_TRUE(records->empty());
}

}  // namespace
}  // namespace myo::test
