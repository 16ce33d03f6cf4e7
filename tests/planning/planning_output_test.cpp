#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "planning/power_output.hpp"
#include "planning/proposal_output.hpp"

// What files, pages and the terminal say of a power map and of a proposed trial, from values made by hand.

namespace myo::planning::planning_output_test {
namespace {

using report::Json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Four effects: seen in its range, seen below it, not seen, and without a size.
PowerMap made_map() {
    PowerMap map;
    map.alpha = 0.01;
    map.wanted = 0.8;
    map.noise_m = 1e-4;
    map.numerical_error_m = 1.2e-5;
    map.trials = {"swing", "hold"};
    map.samples = 24;
    map.runs = 7;
    map.seconds = 2.0;
    map.effects.resize(4);
    EffectPower &drag = map.effects[0], &mass = map.effects[1], &lag = map.effects[2], &swap = map.effects[3];
    drag.id = "drag";
    drag.amount = "coefficient_kg_m3";
    drag.sizes = {{2.0, 1e-5, 0.1, 0.0099}, {20.0, 1e-4, 9.0, 0.47}, {200.0, 1e-3, 900.0, 0.991}};
    drag.detected = 31.4159;
    drag.kept = 0.5;
    drag.confused_with = "mass";
    drag.cosine = 0.98765;
    drag.example = {{"coefficient_kg_m3", 20.0}};
    mass.id = "mass";
    mass.amount = "mass_kg";
    mass.sizes = {{0.1, 1e-3, 80.0, 0.99}};
    mass.detected = 0.01;
    mass.beyond_range = true;
    lag.id = "lag";
    lag.unseen = "the experiment lacks a muscle";
    swap.id = "swap";
    swap.sizes = {{std::nan(""), 1e-5, 0.3, 0.01}};
    swap.unseen = "no plausible size is detected";
    return map;
}

/// The line of a text that begins with a word.
std::string line_with(const std::string& text, const std::string& word) {
    const std::size_t at = text.find("\n" + word);
    EXPECT_NE(at, std::string::npos) << word;
    return at == std::string::npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

TEST(PowerOutput, SaysProbabilitiesWithoutFalsePrecision) {
    const std::string text = power_lines(made_map());
    const std::string drag = line_with(text, "drag"), mass = line_with(text, "mass");
    EXPECT_THAT(drag, HasSubstr("2 <1 %,  20 47 %,  2e+02 >99 %"));
    EXPECT_THAT(drag, HasSubstr("31 "));
    EXPECT_THAT(drag, HasSubstr("mass (0.988)"));
    EXPECT_THAT(mass, HasSubstr("0.1 99 %")) << "99 % is still said";
    EXPECT_THAT(mass, HasSubstr("0.01 *"));
    EXPECT_THAT(text, HasSubstr("from (80 %)"));
    EXPECT_THAT(text, HasSubstr("tests of level 0.01; noise 0.100 mm, numerical error 0.0120 mm (1 sigma); calibrated "
                                "with it: nothing; trials: swing, hold"));
    EXPECT_THAT(text, HasSubstr("\n* weaker than the plausible range"));
    EXPECT_EQ(line_with(text, "lag"), "lag: the experiment lacks a muscle");
    EXPECT_EQ(line_with(text, "swap"), "swap: no plausible size is detected (1 %)") << "without a size";
    // The note stands only where a size has its mark.
    PowerMap plain = made_map();
    plain.effects[1].beyond_range = false;
    EXPECT_THAT(power_lines(plain), Not(HasSubstr("*")));
    plain.effects.resize(2);
    EXPECT_THAT(power_lines(plain), Not(HasSubstr("not to be seen")));
}

TEST(PowerOutput, WritesOnlyKeysThatHaveAValue) {
    results::RunFacts facts;
    facts.version = "1.2";
    facts.command = {"myoloop", "power"};
    const Json json = power_json(made_map(), "beam", facts);
    EXPECT_EQ(json.at("schema"), "power/1");
    EXPECT_EQ(json.at("samples"), 24);
    EXPECT_EQ(json.at("calibrated"), Json::array());
    EXPECT_EQ(json.at("command"), Json::array({"myoloop", "power"}));
    const Json &drag = json.at("effects")[0], &mass = json.at("effects")[1], &lag = json.at("effects")[2],
               &swap = json.at("effects")[3];
    EXPECT_EQ(drag.at("detected_from"), 31.4159) << "all digits, unlike the text";
    EXPECT_EQ(drag.at("below_plausible_range"), false);
    EXPECT_EQ(drag.at("most_like"), (Json{{"id", "mass"}, {"cosine", 0.98765}}));
    EXPECT_EQ(drag.at("sizes")[2].at("probability"), 0.991);
    EXPECT_EQ(drag.at("sizes")[2].at("change_rms_m"), 1e-3);
    EXPECT_EQ(drag.at("example").at("coefficient_kg_m3"), 20.0);
    EXPECT_EQ(mass.at("below_plausible_range"), true);
    EXPECT_FALSE(mass.contains("most_like"));
    EXPECT_FALSE(mass.contains("example"));
    EXPECT_EQ(lag, (Json{{"id", "lag"}, {"seen", false}, {"reason", "the experiment lacks a muscle"}}));
    EXPECT_FALSE(swap.at("sizes")[0].contains("size"));
    EXPECT_FALSE(swap.contains("detected_from"));
    // Read back, the text has the same values.
    EXPECT_EQ(Json::parse(json.dump()), json);
}

TEST(PowerOutput, PutsEveryEffectIntoOneOfTwoTables) {
    report::HtmlReport page = power_report(made_map(), "beam", {});
    ASSERT_EQ(page.sections.size(), 2u);
    const auto& seen = std::get<report::Table>(page.sections[0].blocks[0].content);
    const auto& unseen = std::get<report::Table>(page.sections[1].blocks[0].content);
    EXPECT_EQ(seen.rows.size(), 2u);
    EXPECT_EQ(unseen.rows.size(), 2u);
    for (const report::Table& table : {seen, unseen})
        for (const std::vector<report::Cell>& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(page.key_figures[0].value, "2");
    EXPECT_EQ(page.sections[0].blocks.size(), 2u) << "the table and its note";
    PowerMap all_seen = made_map();
    all_seen.effects.resize(1);
    page = power_report(all_seen, "beam", {});
    ASSERT_EQ(page.sections.size(), 1u);
    EXPECT_EQ(page.sections[0].blocks.size(), 1u);
}

RatedTrial rated(const std::string& name, double probability) {
    return {{name, "words of " + name, "duration_s = 1.0\n"}, 2e-4, 12.0, probability, {}};
}

Proposal made_proposal() {
    Proposal proposal;
    proposal.rivals = {{{"linear_drag"}, {}}};
    proposal.noise_m = 1e-4;
    proposal.numerical_error_m = 1e-5;
    proposal.trials = {rated("best", 0.996), rated("second", 0.99), rated("third", 0.004)};
    proposal.trials.push_back({{"bad", "words of bad", ""}, 0.0, 0.0, 0.0, "it diverged"});
    return proposal;
}

TEST(ProposalOutput, SaysTheBestTrialThenTheOthers) {
    const Proposal proposal = made_proposal();
    ProposalPolicy policy;
    const std::string text = proposal_lines(proposal, policy);
    EXPECT_THAT(text, HasSubstr("Next experiment, to tell apart linear_drag / the declared model: words of best. With "
                                "more than 99 % probability the wrong one is then rejected; after recalibration they "
                                "differ by 0.200 mm (noise 0.100 mm, numerical error 0.0100 mm)."));
    EXPECT_THAT(text, HasSubstr(trial_text(proposal.trials[0].trial)));
    EXPECT_THAT(text, HasSubstr("others of the 4 trials:\n  99 %, 0.200 mm: words of second\n  0 %, 0.200 mm: words of "
                                "third\n  not run (it diverged): words of bad"));
    policy.runners_up = 1;
    const std::string shorter = proposal_lines(proposal, policy);
    EXPECT_THAT(shorter, HasSubstr("words of second"));
    EXPECT_THAT(shorter, Not(HasSubstr("words of third")));
    const report::Section section = proposal_section(proposal, policy);
    ASSERT_EQ(section.blocks.size(), 3u);
    const auto& table = std::get<report::Table>(section.blocks[2].content);
    ASSERT_EQ(table.rows.size(), 2u) << "the best and one runner-up";
    EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][2].content), 0.2) << "in mm, as its column says";
}

TEST(ProposalOutput, SaysInOneSentenceThatNoTrialRuns) {
    Proposal proposal = made_proposal();
    const std::string sentence = "No trial of the family can be run with both linear_drag / the declared model.";
    for (const std::size_t left : {0u, 1u}) {
        proposal.trials = {made_proposal().trials.back()};
        proposal.trials.resize(left);
        EXPECT_EQ(proposal.best(), nullptr);
        EXPECT_EQ(proposal_lines(proposal, {}), sentence);
        EXPECT_EQ(proposal_section(proposal, {}).blocks.size(), 1u);
        const Json json = proposal_json(proposal, "beam", {});
        EXPECT_FALSE(json.contains("next_experiment"));
        EXPECT_EQ(json.at("trials").size(), left);
        if (left > 0) {
            EXPECT_EQ(json.at("trials")[0].at("failure"), "it diverged");
            EXPECT_FALSE(json.at("trials")[0].contains("probability"));
        }
    }
}

/// Two rivals of two effects each are two lists, not an object with one key for each.
TEST(ProposalOutput, SeparatesAListOfTwoWhateverTheRivalsAre) {
    const std::vector<std::string> none, one{"a"}, two{"a", "b"}, three{"a", "b", "c"};
    const std::vector<std::pair<std::vector<std::string>, Json>> written{
        {none, "none"}, {one, "a"}, {two, Json::array({"a", "b"})}, {three, Json::array({"a", "b", "c"})}};
    for (const auto& [first, first_json] : written)
        for (const auto& [second, second_json] : written) {
            Proposal proposal = made_proposal();
            proposal.rivals = {first, second};
            const Json whole = proposal_json(proposal, "beam", {}), next = next_experiment_json(proposal);
            for (const Json& json : {whole, next}) {
                ASSERT_TRUE(json.at("separates").is_array()) << json.dump();
                ASSERT_EQ(json.at("separates").size(), 2u);
                EXPECT_EQ(json.at("separates")[0], first_json);
                EXPECT_EQ(json.at("separates")[1], second_json);
            }
        }
}

TEST(ProposalOutput, NamesTheFileOfASignal) {
    Proposal proposal = made_proposal();
    EXPECT_FALSE(next_experiment_json(proposal).contains("signal"));
    EXPECT_THAT(trial_text(proposal.trials[0].trial), Not(HasSubstr("actuation =")));
    proposal.trials[0].trial.signal.emplace();
    EXPECT_EQ(next_experiment_json(proposal).at("signal"), signal_file);
    EXPECT_THAT(trial_text(proposal.trials[0].trial), HasSubstr("\nactuation = \"next_trial_signal.csv\"\nduration_s"));
    EXPECT_EQ(rival_words({}), "the declared model");
    EXPECT_EQ(rival_words({"a", "b", "c"}), "a and b and c");
}

}  // namespace
}  // namespace myo::planning::planning_output_test
