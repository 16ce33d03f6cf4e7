#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/markup.hpp"
#include "fibre/painted_mask.hpp"
#include "results/calibration_report.hpp"
#include "results/finding_output.hpp"
#include "results/marker_places.hpp"
#include "results/optimized_experiment.hpp"
#include "results/output_json.hpp"
#include "support/folder.hpp"
#include "support/not_finite.hpp"

namespace myo::results::result_words_test {
namespace {

using check::CheckLevel;
using check::Finding;
using testing::ElementsAre;

Finding finding(CheckLevel level, const std::string& id, const std::string& sentence) {
    Finding made = check::passed_finding("", sentence);
    made.level = level;
    made.check = id;
    return made;
}

std::vector<Finding> all_levels() {
    std::vector<Finding> findings{
        finding(CheckLevel::doubtful, "step", "first"), finding(CheckLevel::passed, "mesh", "second"),
        finding(CheckLevel::wrong, "start", "third"),   finding(CheckLevel::doubtful, "step", "fourth"),
        finding(CheckLevel::passed, "units", "fifth"),  finding(CheckLevel::doubtful, "bounds", "sixth")};
    findings[3].way_out = "do this";
    findings[5].warned = true;
    return findings;
}

TEST(FindingWords, StandInTheTableByLevelAndThenInTheirOrder) {
    const report::Section section = findings_section(all_levels());
    std::vector<std::string> order;
    for (const std::vector<report::Cell>& row : std::get<report::Table>(section.blocks.at(0).content).rows)
        order.push_back(std::get<std::string>(row.at(2).content));
    EXPECT_THAT(order, ElementsAre("third", "first", "fourth; do this", "sixth", "second", "fifth"));
    EXPECT_EQ(findings_line({finding(CheckLevel::wrong, "pose", "x")}), "checks: 1 red (pose)");
    EXPECT_TRUE(sentences_to_report({finding(CheckLevel::passed, "mesh", "x")}).empty());
}

TEST(FindingWords, HaveKeysForTheNumbersThatAreThere) {
    Finding bare = finding(CheckLevel::doubtful, "step", "words");
    bare.figure = test::infinity;
    const report::Json json = findings_json({bare});
    EXPECT_EQ(json[0]["level"], "amber");
    EXPECT_EQ(json[0]["sentence"], "words");
    for (const char* key : {"figure", "threshold", "unit"}) EXPECT_FALSE(json[0].contains(key)) << key;
    bare.figure = 0.0;
    bare.unit = "m";
    EXPECT_EQ(findings_json({bare})[0]["figure"], 0.0) << "zero is a number";
    EXPECT_EQ(findings_json({bare})[0]["unit"], "m");
    EXPECT_EQ(report::json_line(findings_json({})), "[]");
}

std::vector<prediction::FoundPlace> two_places() {
    return {{"tip", {3e-3, -4e-3, 0.0}, {1e-4, 2e-4, 3e-4}},
            {"a marker of a long name", {0.0, 0.0, 0.0123456}, {0.0, 0.0, 1e-3}}};
}

TEST(PlacesOfMarkers, AreInMillimetresForPeopleAndInMetresForPrograms) {
    const report::Json json = places_json(two_places());
    EXPECT_EQ(json["tip"]["shift_m"], report::Json({3e-3, -4e-3, 0.0}));
    EXPECT_EQ(json["tip"]["std_m"], report::Json({1e-4, 2e-4, 3e-4}));
    EXPECT_NEAR(json["tip"]["distance_m"].get<double>(), 5e-3, 1e-15);
    EXPECT_EQ(report::json_line(places_json({})), "{}");
    const report::Section section = places_section(two_places(), 2e-3);
    const auto& table = std::get<report::Table>(section.blocks.at(0).content);
    EXPECT_NE(table.caption.find("2.00 mm"), std::string::npos) << table.caption;
    ASSERT_EQ(table.rows.size(), 2u);
    ASSERT_EQ(table.rows[0].size(), table.columns.size());
    const std::vector<double> numbers = {3.0, 0.1, -4.0, 0.2, 0.0, 0.3};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        EXPECT_NEAR(std::get<double>(table.rows[0][i + 1].content), numbers[i], 1e-12) << i;
        EXPECT_EQ(table.columns[i + 1].unit, "mm");
    }
}

TEST(PlacesOfMarkers, StandInLinesOfOneWidth) {
    EXPECT_EQ(place_lines({}), "");
    const std::string text = place_lines(two_places());
    ASSERT_TRUE(text.starts_with("\nmarker off by [mm]"));
    ASSERT_TRUE(text.ends_with("\n"));
    std::vector<std::string> lines;
    for (std::size_t at = 1; at < text.size(); at = text.find('\n', at) + 1)
        lines.push_back(text.substr(at, text.find('\n', at) - at));
    ASSERT_EQ(lines.size(), 3u);
    for (const std::string& line : lines) EXPECT_EQ(character_count(line), character_count(lines[0])) << line;
    EXPECT_NE(lines[1].find("3.000 ±  0.100"), std::string::npos) << lines[1];
    EXPECT_NE(lines[1].find("-4.000 ±  0.200"), std::string::npos) << lines[1];
    EXPECT_NE(lines[2].find("12.346 ±  1.000"), std::string::npos) << lines[2];
}

TEST(SensorWords, HaveALinePerSensorAndTrial) {
    prediction::SetupRun run;
    EXPECT_EQ(sensor_lines(run), "");
    run.scores.resize(2);
    run.scores[0].name = "pull";
    run.scores[0].sensors = {{"load_N", "N", 5e-3, 0.0123456}, {"motor_m", "m", 1e-4, 2e-3}};
    run.scores[1].name = "hold";
    EXPECT_EQ(
        sensor_lines(run),
        "\nsensor load_N in pull: 0.0123 N rms, noise 0.005 N\nsensor motor_m in pull: 0.002 m rms, noise 0.0001 m");
    run.scores[0].sensors.pop_back();
    EXPECT_EQ(sensor_lines(run, "before"), "\nsensor load_N in pull, before: 0.0123 N rms, noise 0.005 N");
    run.scores[0].sensors[0].rms = test::nan;
    const report::Json json = sensor_scores_json(run.scores[0]);
    EXPECT_TRUE(json[0]["rms"].is_null());
    EXPECT_EQ(json[0]["noise"], 5e-3);
    EXPECT_EQ(find_score(run, "hold"), &run.scores[1]);
    EXPECT_EQ(find_score(run, "none"), nullptr);
}

TEST(EstimateWords, TurnToPowersOfTenWhereDecimalsEnd) {
    struct Shown {
        double value, deviation;
        const char *text, *error;
    };
    for (const Shown& one : {Shown{1.234567e-5, 1.2e-5, "0.000012", "0.000012"},
                             {3.0e-8, 1.2e-8, "3.0000 × 10⁻⁸", "1.2 × 10⁻⁸"},
                             {9.96, 0.096, "9.960", "0.096"},
                             {123456.7, 1234.4, "123457", "1234"},
                             {test::nan, 1.0, "–", ""},
                             {test::infinity, 1.0, "–", ""}}) {
        const ReadableEstimate estimate = readable_estimate(one.value, one.deviation);
        EXPECT_EQ(estimate.value, one.text) << one.value;
        EXPECT_EQ(estimate.deviation, one.error) << one.value;
    }
}

/// Muscles whose names give one file name, the first of which is a box.
experiment::Experiment painted_muscles(const std::shared_ptr<const fibre::PaintedMask>& mask) {
    experiment::Experiment experiment;
    experiment.muscles.resize(3);
    experiment.muscles[0].name = "a b";
    experiment.muscles[1].name = "a/b";
    experiment.muscles[1].part = experiment::MuscleMask{mask, {}};
    experiment.muscles[2].name = "c";
    experiment.muscles[2].part = experiment::MuscleMask{mask, {}};
    return experiment;
}

TEST(MaskFiles, AreThoseOfPaintedMusclesThatAreSought) {
    using calibration::SoughtKind;
    const experiment::Experiment experiment = painted_muscles(std::make_shared<fibre::PaintedMask>());
    EXPECT_THAT(mask_files(experiment, {{SoughtKind::direction, "a/b"}, {SoughtKind::weights, "a/b"}}),
                ElementsAre("a_b_2_mask.csv"))
        << "the name belongs to the muscle, whatever is sought of the others";
    EXPECT_THAT(mask_files(experiment, {{SoughtKind::weights, "c"}, {SoughtKind::direction, "a b"}}),
                ElementsAre("c_mask.csv"));
    EXPECT_TRUE(mask_files(experiment, {{SoughtKind::modulus, "c"}, {SoughtKind::signals, ""}}).empty());
    EXPECT_TRUE(mask_files(experiment, {}).empty());
}

TEST(MaskFiles, HoldWhatWasFound) {
    auto mask = std::make_shared<fibre::PaintedMask>();
    mask->cell_size_m = 0.005;
    mask->centroids_m = Eigen::Matrix3Xd(3, 2);
    mask->centroids_m << 0.0, 0.1, 1.0 / 3.0, 0.2, -0.25, 0.0;
    mask->weights = Eigen::Vector2d(0.25, 1.0);
    mask->directions = Eigen::Matrix3Xd(3, 2);
    mask->directions << 0.6, 0.0, 0.8, 0.0, 0.0, -1.0;
    const experiment::Experiment experiment = painted_muscles(mask);
    const test::Folder folder("mask_files");
    std::vector<calibration::FoundItem> found(2);
    found[0].index = 1;
    found[0].mask = mask;
    found[1].index = 2;  // a direction alone, without paint
    ASSERT_TRUE(write_masks(folder.path(), experiment, found));
    EXPECT_FALSE(folder.has("c_mask.csv"));
    const Result<fibre::PaintedMask> read = fibre::read_painted_mask(folder.path() / "a_b_2_mask.csv");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(read->cell_size_m, 0.005, 1e-12);
    EXPECT_LT((read->centroids_m - mask->centroids_m).norm(), 1e-6);
    EXPECT_LT((read->weights - mask->weights).norm(), 1e-6);
    EXPECT_LT((read->directions - mask->directions).norm(), 1e-6);
    EXPECT_FALSE(write_masks(folder.path() / "a_b_2_mask.csv", experiment, found)) << "a file is no folder";
}

}  // namespace
}  // namespace myo::results::result_words_test
