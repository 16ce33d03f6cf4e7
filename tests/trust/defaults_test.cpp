#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "project/read_experiment.hpp"
#include "support/folder.hpp"
#include "trust/converged_truth.hpp"
#include "trust/defaults_case.hpp"
#include "trust/defaults_study.hpp"
#include "trust/defaults_summary.hpp"
#include "trust/synthetic_folder.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;

TEST(DefaultsCase, IsTheSameForItsNumberAndOneInThreeHasASlip) {
    std::set<std::string> shapes, seen_slips;
    int with_slip = 0;
    for (int number = 0; number < 90; ++number) {
        const DefaultsCase d = drawn_defaults_case(3, number), again = drawn_defaults_case(3, number);
        EXPECT_EQ(experiment_text(d.declared), experiment_text(again.declared));
        shapes.insert(d.shape);
        with_slip += d.slip != nullptr ? 1 : 0;
        if (d.slip != nullptr) seen_slips.insert(d.slip->id);
        else EXPECT_EQ(experiment_text(d.declared), experiment_text(d.truth));
        const double length = d.truth.body.length_m(), E = d.truth.material.youngs_modulus_Pa;
        EXPECT_TRUE(length >= defaults_policy.least_length_m && length <= defaults_policy.most_length_m) << length;
        EXPECT_TRUE(E >= defaults_policy.least_modulus_Pa && E <= defaults_policy.most_modulus_Pa) << E;
        const double samples = d.truth.trials.front().end_s * d.truth.rate_Hz;
        EXPECT_TRUE(samples > 8.0 && samples < defaults_policy.most_samples + 1.5) << samples;
    }
    EXPECT_EQ(shapes.size(), 5u);
    EXPECT_EQ(with_slip, 30);
    EXPECT_EQ(seen_slips.size(), slips().size());
    EXPECT_NE(experiment_text(drawn_defaults_case(3, 7).truth), experiment_text(drawn_defaults_case(4, 7).truth));
}

/// Of a slender bar without a Poisson ratio: what Euler and Bernoulli say, less what shear and end effects take.
TEST(ConvergedTruth, HasTheFrequencyOfBeamTheory) {
    DefaultsCase d;
    int number = 0;
    do d = drawn_defaults_case(1, number++);
    while (d.shape != "column" || d.truth.body.length_m() < 12.0 * d.truth.body.thickness_m);
    d.truth.gravity_m_s2.setZero();
    d.truth.material.poissons_ratio = 0.001;
    const Folder folder("converged_truth");
    ASSERT_TRUE(write_still_experiment(d.truth, folder.path()));
    const Result<Experiment> experiment = read_experiment(folder.path());
    ASSERT_TRUE(experiment) << experiment.error().text();
    const Result<ConvergedTruth> truth = converged_truth(d.truth, *experiment);
    ASSERT_TRUE(truth) << truth.error().text();
    EXPECT_NEAR(truth->frequency_Hz / d.frequency_Hz, 0.995, 0.006);
    EXPECT_LT(truth->frequency_change, convergence_policy.most_change);
    EXPECT_LT(truth->path_change, convergence_policy.most_path_change);
    EXPECT_EQ(truth->positions_m.front().size(), d.truth.markers.size());
}

DefaultsRecord record_with(double error, double deviation, const std::string& slip = {},
                           const std::vector<std::string>& checks = {}) {
    DefaultsRecord r;
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
    EXPECT_EQ(judged(record_with(0.019, 0.0)), DefaultsAnswer::right);
    EXPECT_EQ(judged(record_with(-0.049, 0.01)), DefaultsAnswer::right);
    EXPECT_EQ(judged(record_with(0.051, 0.01)), DefaultsAnswer::silent);
    EXPECT_EQ(judged(record_with(0.051, 0.01, {}, {"step"})), DefaultsAnswer::cause_named);
    EXPECT_EQ(judged(record_with(0.051, 0.01, {}, {"residual"})), DefaultsAnswer::other_warning);
    EXPECT_EQ(judged(record_with(0.051, 0.01, "straight_for_sagging", {"start"})), DefaultsAnswer::cause_named);
    EXPECT_EQ(judged(record_with(0.051, 0.01, "straight_for_sagging", {"step"})), DefaultsAnswer::other_warning);
    // What the data do not determine has to be named.
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judged(record_with(0.3, none)), DefaultsAnswer::silent);
    EXPECT_EQ(judged(record_with(0.3, none, {}, {"influence"})), DefaultsAnswer::right);
    EXPECT_FALSE(is_false_alarm(record_with(0.3, none, {}, {"influence"})));
    EXPECT_TRUE(is_false_alarm(record_with(0.01, 0.01, {}, {"mesh"})));
    DefaultsRecord refused = record_with(0.0, 0.0, "trace_in_another_clock");
    refused.numbers.clear();
    refused.refusal = "trial[0].trace: set start_s";
    EXPECT_EQ(judged(refused), DefaultsAnswer::cause_named);
    refused.refusal = "something else";
    EXPECT_EQ(judged(refused), DefaultsAnswer::other_warning);
}

TEST(DefaultsRecord, KeepsAllInItsLine) {
    DefaultsRecord record = record_with(0.01, std::numeric_limits<double>::quiet_NaN(), "held_on_a_line", {"support"});
    record.facts = "10 x 1 x 1 mm";
    record.number = 17;
    const Result<DefaultsRecord> read = defaults_record_from_json(record_json(record));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(json_line(record_json(*read)), json_line(record_json(record)));
    EXPECT_TRUE(std::isnan(read->numbers.front().deviation));
    EXPECT_FALSE(defaults_record_from_json(Json{{"case", 3}}));
}

TEST(DefaultsSummary, CountsWhatTheRecordsSay) {
    std::vector<DefaultsRecord> records{record_with(0.01, 0.01), record_with(-0.02, 0.01),
                                        record_with(0.2, 0.01), record_with(0.0, 0.01, {}, {"mesh"}),
                                        record_with(0.5, 0.01, "straight_for_sagging", {"start"})};
    records[2].with_half_interval_s = 1.0;
    const DefaultsSummary s = defaults_summary(records);
    EXPECT_EQ(s.right.count, 4);
    EXPECT_EQ(s.right.of, 5);
    EXPECT_EQ(s.silent.count, 1);
    EXPECT_EQ(s.false_alarms.count, 1);
    EXPECT_EQ(s.false_alarms.of, 4);
    EXPECT_NEAR(s.normalised_rms.at("youngs_modulus_Pa"), std::sqrt((1.0 + 4.0 + 400.0 + 0.0) / 4.0), 1e-9);
    EXPECT_NEAR(s.median_time_ratio, 1.5, 1e-12);
    EXPECT_EQ(s.twice_the_time_at_most.of, 3);   // where half an interval was right
    EXPECT_THAT(summary_text(s), HasSubstr("wrong without a word"));
    const std::string page = html(defaults_report(records, "myoloop study --defaults"));
    for (const char* text : {"false alarm", "silent", "straight_for_sagging"}) EXPECT_THAT(page, HasSubstr(text));
}

/// A damping of 0.003 s with a deviation of 0.03 is within three of anything.
TEST(DefaultsSummary, TakesNoAnswerThatSaysNothingForRight) {
    DefaultsRecord vague = record_with(0.01, 0.01);
    vague.with_half_interval[1].deviation = 0.03;
    const DefaultsSummary s = defaults_summary({record_with(0.01, 0.01), vague});
    EXPECT_EQ(s.half_interval_right.count, 1);
    EXPECT_EQ(s.twice_the_time_at_most.of, 1);
}

TEST(StudyFolder, KeepsRecordsAndPassesOverAnUnfinishedLine) {
    const Folder folder("study_folder");
    StudyFolder study(folder.path());
    int runs = 0;
    const auto run = [&](int number) { return ++runs, Json{{"case", number}}; };
    ASSERT_TRUE(study.run({.first = 2, .cases = 6, .share = 1, .shares = 2}, run, {}));
    EXPECT_EQ(runs, 3);   // 3, 5, 7
    std::ofstream(folder.path() / "cases.jsonl", std::ios::app) << "{\"case\": 11, \"ki";
    ASSERT_TRUE(study.run({.first = 3, .cases = 2}, run, {}));
    EXPECT_EQ(runs, 4);   // 4
    const Result<std::vector<Json>> read = study.records();
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->size(), 4u);
    folder.write("cases.jsonl", "{\"case\": 1}\n{}\n{\"case\": 2}\n");
    const Result<std::vector<Json>> broken = study.records();
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().where, HasSubstr("cases.jsonl:2"));
    ASSERT_TRUE(study.claim({{"seed", 1}}));
    EXPECT_TRUE(study.claim({{"seed", 1}}));
    EXPECT_FALSE(study.claim({{"seed", 2}}));
}

}  // namespace
}  // namespace myo::test
