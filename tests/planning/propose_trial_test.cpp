#include "planning/propose_trial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/files.hpp"
#include "experiment/read_experiment.hpp"
#include "planning/planned_beam.hpp"
#include "planning/proposal_output.hpp"
#include "planning/reported_rivals.hpp"
#include "planning/round_numbers.hpp"
#include "planning/trial_family.hpp"

// The next experiment of a swung beam, and what the family of trials holds.

namespace myo::planning::propose_trial_test {
namespace {

using ::testing::HasSubstr;

/// Two laws of drag, which one swing from straight hardly tells apart.
Proposal proposal_in(const test::Folder& folder, const setup::Setup& setup, const std::string& declaration,
                     std::array<RivalStart, 2> starts = {RivalStart{{"linear_drag"}}, RivalStart{{"quadratic_drag"}}}) {
    const Result<FittedRivals> fitted = fitted_rivals(setup, starts, {});
    EXPECT_TRUE(fitted) << fitted.error().text();
    const std::filesystem::path file = folder.path() / "experiment.toml";
    const Result<Proposal> proposal = propose_trial({fitted->setup, fitted->rivals, declaration, file, {}, {}, {}, {}},
                                                    {});
    EXPECT_TRUE(proposal) << proposal.error().text();
    return *proposal;
}

TEST(ProposeTrial, SeparatesTwoDragsBetterThanTheMedianOfTheFamily) {
    const test::Folder folder("propose_drags");
    const setup::Setup setup = test::planned_beam(folder);
    const Proposal proposal = proposal_in(folder, setup, test::planned_beam_toml());
    ASSERT_NE(proposal.best(), nullptr);
    std::vector<double> values;
    for (const RatedTrial& rated : proposal.trials) {
        ASSERT_EQ(rated.failure, "") << rated.trial.name;
        values.push_back(rated.noncentrality);
        // Drag does nothing at rest.
        if (rated.trial.keys.find("hold = true") != std::string::npos) {
            EXPECT_LT(rated.noncentrality, 0.1);
            EXPECT_LT(rated.probability, 2.0 * proposal.alpha);
        }
    }
    ASSERT_GT(values.size(), 6u);
    EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend()));
    EXPECT_GT(values.front(), 2.0 * values[values.size() / 2]);
    EXPECT_GT(proposal.best()->probability, 0.8);
    EXPECT_THAT(proposal_lines(proposal, {}), HasSubstr("linear_drag / quadratic_drag"));
    const report::Json json = next_experiment_json(proposal);
    EXPECT_EQ(json.at("separates"), report::Json({"linear_drag", "quadratic_drag"}));
    EXPECT_GT(json.at("probability").get<double>(), 0.8);

    // The text is a trial of this experiment.
    const Result<experiment::Experiment> read = experiment::read_experiment_text(
        test::planned_beam_toml() + json.at("trial").get<std::string>(), folder.path() / "experiment.toml");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->trials.back().name, proposal.best()->trial.name);
    EXPECT_EQ(read->trials.back().role, experiment::TrialRole::simulate);
}

/// What the existing trials know of the wrong rival's parameters limits its recalibration.
TEST(ProposeTrial, KnownParametersContradictMore) {
    Eigen::MatrixXd J(4, 1), known(2, 1);
    J << 1.0, 1.0, 1.0, 1.0;
    known << 5.0, -5.0;
    const Eigen::Vector4d d(1.0, 1.2, 0.8, 1.0);
    double free_left = 0.0, known_left = 0.0;
    const double free = contradiction(Eigen::MatrixXd(0, 1), {}, J, d, {}, 0.0, free_left),
                 bound = contradiction(known, {}, J, d, {}, 0.0, known_left);
    EXPECT_NEAR(free, 0.08, 1e-12);
    // min over s of |d - s|^2 + 50 s^2: s = sum d / 54.
    const double s = 4.0 / 54.0;
    EXPECT_NEAR(bound, (d.array() - s).matrix().squaredNorm() + 50.0 * s * s, 1e-12);
    EXPECT_GT(bound, free);
    EXPECT_GT(known_left, free_left);
}

TEST(TrialFamily, StaysWithinLimits) {
    const test::Folder folder("family_limits");
    folder.write("experiment.toml", test::planned_beam_toml() + R"([[trial]]
name = "pulled"
role = "simulate"
duration_s = 0.8
start = "equilibrium"
[[trial.load]]
kind = "force"
box_m = [[0.0995, -0.001, -0.001], [0.1005, 0.031, 0.031]]
force_N = [0.0, 0.2, 0.0]
until_s = 0.0
)");
    const setup::Setup setup = test::setup_in(folder);
    const auto forces_of = [&](const experiment::LimitsDeclaration& limits) {
        std::string text = *read_file(folder.path() / "experiment.toml");
        for (const PossibleTrial& trial : trial_family(setup, limits, {})) text += trial_text(trial);
        const Result<experiment::Experiment> read = experiment::read_experiment_text(text,
                                                                                     folder.path() / "experiment.toml");
        EXPECT_TRUE(read) << read.error().text();
        return *read;
    };
    experiment::LimitsDeclaration low;
    low.force_N = 0.1;
    low.duration_s = 0.5;
    const experiment::Experiment usual = forces_of({}), less = forces_of(low);
    double most = 0.0;
    for (std::size_t t = 2; t < usual.trials.size(); ++t)
        for (const experiment::LoadDeclaration& load : usual.trials[t].loads)
            most = std::max(most, load.force_N.norm());
    EXPECT_NEAR(most, 0.3, 1e-9);  // 1.5 times the largest
    for (std::size_t t = 2; t < less.trials.size(); ++t) {
        EXPECT_LE(less.trials[t].duration_s, 0.5 + 1e-9);
        for (const experiment::LoadDeclaration& load : less.trials[t].loads) EXPECT_LE(load.force_N.norm(), 0.1 + 1e-9);
    }
}

/// A body whose length has three digits: rounded to two, the box of its free end would miss the face.
TEST(TrialFamily, LoadsTheFreeEndOfABodyOfAnyLength) {
    const test::Folder folder("family_free_end");
    std::string text = test::planned_beam_toml();
    const std::string size = "size_m = [0.1,";
    folder.write("experiment.toml", text.replace(text.find(size), size.size(), "size_m = [0.112,"));
    const setup::Setup setup = test::setup_in(folder);
    for (const PossibleTrial& trial : trial_family(setup, {}, {})) text += trial_text(trial);
    const Result<experiment::Experiment> read = experiment::read_experiment_text(text,
                                                                                 folder.path() / "experiment.toml");
    ASSERT_TRUE(read) << read.error().text();
    int loads = 0;
    for (const experiment::TrialDeclaration& trial : read->trials)
        for (const experiment::LoadDeclaration& load : trial.loads) {
            ++loads;
            EXPECT_LT(load.box_m.lowest.x(), 0.112) << trial.name;
            EXPECT_GT(load.box_m.highest.x(), 0.112) << trial.name;
        }
    EXPECT_GT(loads, 3);
}

/// Numbers of a box keep the digits of its margin: a face at 0.112 m lies in it, one at 0.11 m would not.
TEST(TrialFamily, BoxesHoldTheirFaces) {
    for (const double face : {0.112, 0.1234, -0.0871, 0.0, 1.0}) {
        const double margin = 0.0006, lowest = rounded_down_to(face - margin, margin),
                     highest = -rounded_down_to(-face - margin, margin);
        EXPECT_LE(lowest, face - 0.99 * margin);
        EXPECT_GE(highest, face + 0.99 * margin);
        EXPECT_LT(highest - lowest, 4.0 * margin);
    }
    EXPECT_EQ(rounded_down_to(0.1128, 0.001), 0.112) << "the decimal number itself";
}

const char* const muscles = R"([[muscle]]
name = "upper"
box_m = [[0.0, -0.001, 0.02], [0.1, 0.031, 0.031]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 1.0e5
[[muscle]]
name = "lower"
box_m = [[0.0, -0.001, -0.001], [0.1, 0.031, 0.01]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 1.0e5
follows = { muscle = "upper", ratio = -0.5 }
)";

/// Signals of muscles are files, which a trial reads.
TEST(TrialFamily, DrivesMusclesByFiles) {
    const test::Folder folder("family_muscles");
    std::string text = test::planned_beam_toml();
    text.insert(text.find("[markers]"), muscles);
    text.replace(text.find("start = \"straight\""), 18, "start = \"equilibrium\"\nactuation_step = { upper = 0.85 }");
    folder.write("experiment.toml", text);
    const setup::Setup setup = test::setup_in(folder);
    int with_file = 0;
    for (const PossibleTrial& trial : trial_family(setup, {}, {})) {
        if (trial.signal) {
            ++with_file;
            EXPECT_THAT(trial.signal->muscles, ::testing::ElementsAre("upper"));
            EXPECT_NEAR(trial.signal->values.minCoeff(), 0.85, 1e-9);
            EXPECT_NEAR(trial.signal->values.maxCoeff(), 1.0, 1e-9);
            EXPECT_TRUE(measurement::write_actuation_csv(folder.path() / signal_file, *trial.signal));
        }
        const Result<experiment::Experiment> read = experiment::read_experiment_text(text + trial_text(trial),
                                                                                     folder.path() / "experiment.toml");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->trials.back().name, trial.name);
    }
    EXPECT_EQ(with_file, 2);
    const Proposal proposal = proposal_in(folder, setup, text,
                                          {RivalStart{{"actuation_lag"}}, RivalStart{{"actuation_gain"}}});
    ASSERT_NE(proposal.best(), nullptr);
    EXPECT_GT(proposal.best()->probability, 0.9);
    EXPECT_FALSE(folder.has("next_ramp_upper.csv"));
}

diagnosis::JudgedFit made_fit(const std::string& id, double weight) {
    diagnosis::JudgedFit fit;
    fit.fit.effects = {{id, {}, false}};
    fit.fit.residual.setZero(3);
    fit.fit.jacobian.setOnes(3, 1);
    fit.weight = weight;
    return fit;
}

diagnosis::Candidate candidate(const std::string& id, double weight) {
    diagnosis::Candidate made;
    made.score.id = id;
    made.judged = made_fit(id, weight);
    return made;
}

TEST(DiagnosedRivals, AreTheEffectsThatWereNotToldApart) {
    diagnosis::Diagnosis d;
    d.candidates = {candidate("linear_drag", 0.5), candidate("quadratic_drag", 0.4), candidate("gravity_tilt", 0.1)};
    EXPECT_FALSE(diagnosed_rivals(d));
    d.confusions = {{"linear_drag", "quadratic_drag", 0.99, ""}};
    const auto rivals = diagnosed_rivals(d);
    ASSERT_TRUE(rivals);
    EXPECT_EQ((*rivals)[0].ids, std::vector<std::string>{"linear_drag"});
    EXPECT_EQ((*rivals)[1].ids, std::vector<std::string>{"quadratic_drag"});
    EXPECT_EQ((*rivals)[0].slopes.rows(), 3);
    // The fits decide.
    d.verdict.kind = diagnosis::VerdictKind::effects;
    d.verdict.effects = {{"linear_drag", {}, false}};
    d.candidates[1].judged->weight = 0.0;
    EXPECT_FALSE(diagnosed_rivals(d));
}

class Reports : public ::testing::Test {
protected:
    std::string said_of(const std::string& text) const {
        folder_.write("report.json", text);
        const Result<std::array<RivalStart, 2>> read = reported_rivals(folder_.path() / "report.json");
        return read ? "" : read.error().text();
    }
    test::Folder folder_{"reported_rivals"};
};

const std::string reported = R"({"verdict": {"not_told_apart": GROUPS},
"details": {"declared": {"weight": 0.0, "parameters": {}, "effects": []},
"candidates": [
{"id": "linear_drag", "fit": {"weight": 0.3, "parameters": {"youngs_modulus_Pa": 2.7e5, "coefficient_kg_m2_s": 20.0},
  "effects": [{"id": "linear_drag", "parameters": {"coefficient_kg_m2_s": 20.0}}]}},
{"id": "quadratic_drag", "fit": {"weight": 0.4, "parameters": {"youngs_modulus_Pa": 2.6e5}}},
{"id": "gravity_tilt", "fit": {"weight": 0.2, "parameters": {},
  "effects": [{"id": "gravity_tilt", "parameters": {"tilt_deg": 1.0, "axis": [0.0, 1.0, 0.0]}}]}}],
"sets": []}})";

std::string with_groups(const std::string& groups) {
    std::string text = reported;
    return text.replace(text.find("GROUPS"), 6, groups);
}

TEST_F(Reports, NameTheRivals) {
    folder_.write("report.json", with_groups(R"([["linear_drag", "gravity_tilt"]])"));
    const auto rivals = reported_rivals(folder_.path() / "report.json");
    ASSERT_TRUE(rivals) << rivals.error().text();
    EXPECT_EQ((*rivals)[0].ids, std::vector<std::string>{"linear_drag"});
    EXPECT_EQ((*rivals)[0].parameters.at("youngs_modulus_Pa"), 2.7e5);
    ASSERT_EQ((*rivals)[1].effects.size(), 1u);
    EXPECT_EQ(effect::vector((*rivals)[1].effects[0].parameters, "axis"), Eigen::Vector3d::UnitY());

    folder_.write("report.json", with_groups("[]"));
    const auto heaviest = reported_rivals(folder_.path() / "report.json");
    ASSERT_TRUE(heaviest);
    EXPECT_EQ((*heaviest)[0].ids, std::vector<std::string>{"quadratic_drag"});
    EXPECT_TRUE((*heaviest)[0].effects.empty());  // to be fitted again
    EXPECT_EQ((*heaviest)[1].ids, std::vector<std::string>{"linear_drag"});
}

TEST_F(Reports, ThatAreNoneAreToldInOneSentence) {
    EXPECT_THAT(said_of("{}"), HasSubstr("report.json: is no report of a diagnosis"));
    EXPECT_THAT(said_of("[1]"), HasSubstr("is no report of a diagnosis"));
    EXPECT_THAT(said_of("{"), HasSubstr("report.json"));
    EXPECT_THAT(said_of(with_groups(R"([["linear_drag", "magic"]])")), HasSubstr("\"magic\""));
    EXPECT_THAT(reported_rivals(folder_.path() / "absent.json").error().text(), HasSubstr("absent.json"));
}

}  // namespace
}  // namespace myo::planning::propose_trial_test
