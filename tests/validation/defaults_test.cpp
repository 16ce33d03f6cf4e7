#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"
#include "validation/converged_truth.hpp"
#include "validation/defaults_case.hpp"
#include "validation/defaults_summary.hpp"
#include "validation/defaults_validation.hpp"
#include "validation/synthetic_folder.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;

TEST(DefaultsCase, IsTheSameForItsNumberAndOneInThreeHasASlip) {
    std::set<std::string> shapes, seen_slips;
    int with_slip = 0;
    for (int number = 0; number < 90; ++number) {
        const validation::DefaultsCase d = validation::drawn_defaults_case(3, number),
                                       again = validation::drawn_defaults_case(3, number);
        EXPECT_EQ(validation::experiment_text(d.declared), validation::experiment_text(again.declared));
        shapes.insert(d.shape);
        with_slip += d.slip != nullptr ? 1 : 0;
        if (d.slip != nullptr)
            seen_slips.insert(d.slip->id);
        else
            EXPECT_EQ(validation::experiment_text(d.declared), validation::experiment_text(d.truth));
        const double length = d.truth.body.length_m(), E = d.truth.material.youngs_modulus_Pa;
        EXPECT_TRUE(length >= validation::defaults_policy.min_length_m &&
                    length <= validation::defaults_policy.max_length_m)
            << length;
        EXPECT_TRUE(E >= validation::defaults_policy.min_modulus_Pa && E <= validation::defaults_policy.max_modulus_Pa)
            << E;
        const double samples = d.truth.trials.front().end_s * d.truth.rate_Hz;
        EXPECT_TRUE(samples > 8.0 && samples < validation::defaults_policy.max_samples + 1.5) << samples;
    }
    EXPECT_EQ(shapes.size(), 5u);
    EXPECT_EQ(with_slip, 30);
    EXPECT_EQ(seen_slips.size(), validation::slips().size());
    EXPECT_NE(validation::experiment_text(validation::drawn_defaults_case(3, 7).truth),
              validation::experiment_text(validation::drawn_defaults_case(4, 7).truth));
}

/// Of a slender bar without a Poisson ratio: what Euler and Bernoulli say, less what shear and end effects take.
TEST(ConvergedTruth, HasTheFrequencyOfBeamTheory) {
    validation::DefaultsCase d;
    int number = 0;
    do d = validation::drawn_defaults_case(1, number++);
    while (d.shape != "column" || d.truth.body.length_m() < 12.0 * d.truth.body.thickness_m);
    d.truth.gravity_m_s2.setZero();
    d.truth.material.poissons_ratio = 0.001;
    const Folder folder("converged_truth");
    ASSERT_TRUE(validation::write_still_experiment(d.truth, folder.path()));
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    ASSERT_TRUE(experiment) << experiment.error().text();
    const Result<validation::ConvergedTruth> truth = validation::converged_truth(d.truth, *experiment);
    ASSERT_TRUE(truth) << truth.error().text();
    EXPECT_NEAR(truth->frequency_Hz / d.frequency_Hz, 0.995, 0.006);
    EXPECT_LT(truth->frequency_change, validation::convergence_policy.max_change);
    EXPECT_LT(truth->path_change, validation::convergence_policy.max_path_change);
    EXPECT_EQ(truth->positions_m.front().size(), d.truth.markers.size());
}

validation::DefaultsRecord record_with(double error, double deviation, const std::string& slip = {},
                                       const std::vector<std::string>& checks = {}) {
    validation::DefaultsRecord r;
    r.slip = slip;
    r.shape = "bar";
    r.truth_dofs = 300;
    r.numbers = {{"youngs_modulus_Pa", 1e6, 1e6 * (1.0 + error), 1e6 * deviation}, {"damping_s", 0.003, 0.003, 1e-5}};
    r.with_half_interval = r.numbers;
    r.fit_s = 3.0;
    r.with_half_interval_s = 2.0;
    for (const std::string& check : checks) r.remarks.push_back({check, "", "", false});
    return r;
}

TEST(DefaultsRecord, IsRightWithinTwoPercentAndThreeDeviations) {
    EXPECT_EQ(validation::judged(record_with(0.019, 0.0)), validation::DefaultsAnswer::right);
    EXPECT_EQ(validation::judged(record_with(-0.049, 0.01)), validation::DefaultsAnswer::right);
    EXPECT_EQ(validation::judged(record_with(0.051, 0.01)), validation::DefaultsAnswer::silent);
    EXPECT_EQ(validation::judged(record_with(0.051, 0.01, {}, {"step"})), validation::DefaultsAnswer::cause_named);
    EXPECT_EQ(validation::judged(record_with(0.051, 0.01, {}, {"residual"})),
              validation::DefaultsAnswer::other_warning);
    EXPECT_EQ(validation::judged(record_with(0.051, 0.01, "straight_for_sagging", {"start"})),
              validation::DefaultsAnswer::cause_named);
    EXPECT_EQ(validation::judged(record_with(0.051, 0.01, "straight_for_sagging", {"step"})),
              validation::DefaultsAnswer::other_warning);
    // What the data do not determine has to be named.
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(validation::judged(record_with(0.3, none)), validation::DefaultsAnswer::silent);
    EXPECT_EQ(validation::judged(record_with(0.3, none, {}, {"influence"})), validation::DefaultsAnswer::right);
    EXPECT_FALSE(validation::is_false_alarm(record_with(0.3, none, {}, {"influence"})));
    EXPECT_TRUE(validation::is_false_alarm(record_with(0.01, 0.01, {}, {"mesh"})));
    validation::DefaultsRecord refused = record_with(0.0, 0.0, "trace_in_another_clock");
    refused.numbers.clear();
    refused.refusal = "trial[0].trace: set start_s";
    EXPECT_EQ(validation::judged(refused), validation::DefaultsAnswer::cause_named);
    refused.refusal = "something else";
    EXPECT_EQ(validation::judged(refused), validation::DefaultsAnswer::other_warning);
}

TEST(DefaultsRecord, KeepsAllInItsLine) {
    validation::DefaultsRecord record = record_with(0.01, std::numeric_limits<double>::quiet_NaN(), "held_on_a_line",
                                                    {"support"});
    record.facts = "10 x 1 x 1 mm";
    record.number = 17;
    const Result<validation::DefaultsRecord> read = validation::defaults_record_from_json(
        validation::record_json(record));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(report::json_line(validation::record_json(*read)), report::json_line(validation::record_json(record)));
    EXPECT_TRUE(std::isnan(read->numbers.front().deviation));
    EXPECT_FALSE(validation::defaults_record_from_json(report::Json{{"case", 3}}));
}

TEST(DefaultsSummary, CountsWhatTheRecordsSay) {
    std::vector<validation::DefaultsRecord> records{record_with(0.01, 0.01), record_with(-0.02, 0.01),
                                                    record_with(0.2, 0.01), record_with(0.0, 0.01, {}, {"mesh"}),
                                                    record_with(0.5, 0.01, "straight_for_sagging", {"start"})};
    records[2].with_half_interval_s = 1.0;
    const validation::DefaultsSummary s = validation::defaults_summary(records);
    EXPECT_EQ(s.right.count, 4);
    EXPECT_EQ(s.right.of, 5);
    EXPECT_EQ(s.silent.count, 1);
    EXPECT_EQ(s.false_alarms.count, 1);
    EXPECT_EQ(s.false_alarms.of, 4);
    EXPECT_NEAR(s.normalised_rms.at("youngs_modulus_Pa"), std::sqrt((1.0 + 4.0 + 400.0 + 0.0) / 4.0), 1e-9);
    EXPECT_NEAR(s.median_time_ratio, 1.5, 1e-12);
    EXPECT_EQ(s.twice_the_time_at_most.of, 3);  // where half an interval was right
    EXPECT_THAT(validation::summary_text(s), HasSubstr("wrong without a warning"));
    const std::string page = report::html(validation::defaults_report(records, "myoloop validate --defaults"));
    for (const char* text : {"false alarm", "silent", "straight_for_sagging"}) EXPECT_THAT(page, HasSubstr(text));
}

/// A damping of 0.003 s with a deviation of 0.03 is within three of anything.
TEST(DefaultsSummary, TakesNoAnswerThatSaysNothingForRight) {
    validation::DefaultsRecord vague = record_with(0.01, 0.01);
    vague.with_half_interval[1].deviation = 0.03;
    const validation::DefaultsSummary s = validation::defaults_summary({record_with(0.01, 0.01), vague});
    EXPECT_EQ(s.half_interval_right.count, 1);
    EXPECT_EQ(s.twice_the_time_at_most.of, 1);
}

TEST(ValidationFolder, KeepsRecordsAndPassesOverAnUnfinishedLine) {
    const Folder folder("study_folder");
    validation::ValidationFolder setup(folder.path());
    int runs = 0;
    const auto run = [&](int number) { return ++runs, report::Json{{"case", number}}; };
    ASSERT_TRUE(setup.run({.first = 2, .cases = 6, .share = {1, 2}}, run, {}));
    EXPECT_EQ(runs, 3);  // 3, 5, 7
    std::ofstream(folder.path() / "cases.jsonl", std::ios::app) << "{\"case\": 11, \"ki";
    ASSERT_TRUE(setup.run({.first = 3, .cases = 2}, run, {}));
    EXPECT_EQ(runs, 4);  // 4
    const Result<std::vector<report::Json>> read = setup.records();
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->size(), 4u);
    folder.write("cases.jsonl", "{\"case\": 1}\n{}\n{\"case\": 2}\n");
    const Result<std::vector<report::Json>> broken = setup.records();
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().where, HasSubstr("cases.jsonl:2"));
    ASSERT_TRUE(setup.claim({{"seed", 1}}));
    EXPECT_TRUE(setup.claim({{"seed", 1}}));
    EXPECT_FALSE(setup.claim({{"seed", 2}}));
}

}  // namespace
}  // namespace myo::test
