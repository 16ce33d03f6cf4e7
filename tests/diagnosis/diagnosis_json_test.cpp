#include "diagnosis/report/diagnosis_json.hpp"

#include <gtest/gtest.h>

#include <set>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/made_problem.hpp"

// Keys and values of the report that its schema promises, from made-up diagnoses without a run.

namespace myo::diagnosis::diagnosis_json_test {
namespace {

using Keys = std::set<std::string>;

Keys keys_of(const report::Json& json) {
    Keys keys;
    for (const auto& [key, value] : json.items()) keys.insert(key);
    return keys;
}

setup::Setup two_trials() {
    setup::Setup setup;
    setup.marker_names = {"tip"};
    setup.noise_m = Eigen::VectorXd::Constant(1, test::noise_m);
    setup.trials.resize(2);
    setup.trials[0].name = "pull";
    setup.trials[1].name = "drop";
    setup.trials[1].role = experiment::TrialRole::validate;
    return setup;
}

prediction::SetupRun run(double rms_m) {
    prediction::SetupRun made;
    for (const char* name : {"pull", "drop"}) {
        prediction::TrialScore score;
        score.name = name;
        score.rms_m = rms_m;
        score.markers.resize(1);
        score.markers[0].rms_m = rms_m;
        made.scores.push_back(score);
    }
    made.fit_rms_m = made.validation_rms_m = rms_m;
    return made;
}

Diagnosis with_verdict(VerdictKind kind, const std::vector<effect::EffectDeclaration>& effects = {}) {
    Diagnosis d = test::with_candidate(0.3);
    for (JudgedFit* fit : {&d.declared, &*d.candidates[0].judged}) {
        fit->fit.parameters = {test::modulus_parameter()};
        fit->fit.values.youngs_modulus_Pa = 2.5e5;
    }
    d.candidates[0].judged->fit.values.effects = effects;
    d.augmented = kind == VerdictKind::none ? d.declared : *d.candidates[0].judged;
    d.before = run(5e-4);
    d.after = run(2e-4);
    d.verdict = {kind, effects, 0.9, "it falls.", {"quadratic_drag", "unknown", "none"}};
    return d;
}

report::Json json_of(const Diagnosis& d) { return diagnosis_json(two_trials(), d, "beam"); }

TEST(DiagnosisJson, HasTheKeysOfTheSchema) {
    const report::Json json = json_of(with_verdict(VerdictKind::effects, {{"quadratic_drag", {}, false}}));
    EXPECT_EQ(keys_of(json), (Keys{"schema", "experiment", "declared_fit", "noise_floor_m", "verdict", "augmented_fit",
                                   "validation", "trials", "details"}));
    EXPECT_EQ(json["schema"], "report/1");
    EXPECT_EQ(json["experiment"], "beam");
    EXPECT_EQ(json["noise_floor_m"], test::noise_m);
    for (const char* fit : {"declared_fit", "augmented_fit"})
        EXPECT_EQ(keys_of(json[fit]), (Keys{"parameters", "rms_m"})) << fit;
    EXPECT_EQ(keys_of(json["verdict"]), (Keys{"confidence", "effects", "not_told_apart", "probabilities", "ranking"}));
    EXPECT_EQ(keys_of(json["verdict"]["effects"][0]), (Keys{"id", "confidence", "intervals", "parameters"}));
    EXPECT_EQ(keys_of(json["validation"]), (Keys{"before_rms_m", "after_rms_m"}));
    for (const report::Json& trial : json["trials"])
        EXPECT_EQ(keys_of(trial), (Keys{"name", "role", "before_rms_m", "after_rms_m"}));
}

TEST(DiagnosisJson, HoldsTheValues) {
    const report::Json json = json_of(with_verdict(VerdictKind::effects, {{"quadratic_drag", {}, false}}));
    EXPECT_EQ(json["declared_fit"]["parameters"]["youngs_modulus_Pa"], 2.5e5);
    EXPECT_NEAR(json["declared_fit"]["rms_m"].get<double>(), 10.0 * test::noise_m, 1e-12);
    EXPECT_EQ(json["validation"]["before_rms_m"], 5e-4);
    EXPECT_EQ(json["validation"]["after_rms_m"], 2e-4);
    EXPECT_EQ(json["trials"][0]["role"], "fit");
    EXPECT_EQ(json["trials"][1]["role"], "validate");
    EXPECT_EQ(json["trials"][1]["name"], "drop");
    EXPECT_EQ(json["verdict"]["ranking"], (std::vector<std::string>{"quadratic_drag", "unknown", "none"}));
    EXPECT_EQ(json["details"]["markers"]["pull"]["tip"]["before_rms_m"], 5e-4);
}

/// `none` and `unknown` stand alone, as entries without parameters.
TEST(DiagnosisJson, WritesVerdictsWithoutAnEffectAsEntries) {
    for (const auto& [kind, id] : {std::pair{VerdictKind::none, "none"}, {VerdictKind::unknown, "unknown"}}) {
        const report::Json json = json_of(with_verdict(kind));
        ASSERT_EQ(json["verdict"]["effects"].size(), 1u);
        EXPECT_EQ(json["verdict"]["effects"][0]["id"], id);
        EXPECT_EQ(json["verdict"]["effects"][0]["confidence"], 0.9);
        EXPECT_TRUE(json["verdict"]["effects"][0]["parameters"].empty());
        EXPECT_EQ(json["declared_fit"] == json["augmented_fit"], kind == VerdictKind::none);
    }
}

TEST(DiagnosisJson, NamesEveryEffectOfTheVerdict) {
    const report::Json json = json_of(
        with_verdict(VerdictKind::effects, {{"linear_drag", {{"stiffness", 2.0}}, false}, {"point_mass", {}, false}}));
    ASSERT_EQ(json["verdict"]["effects"].size(), 2u);
    EXPECT_EQ(json["verdict"]["effects"][0]["id"], "linear_drag");
    EXPECT_EQ(json["verdict"]["effects"][0]["parameters"]["stiffness"], 2.0);
    EXPECT_EQ(json["verdict"]["effects"][1]["id"], "point_mass");
}

/// Two effects with a parameter of one name: the second gets the id in front.
TEST(DiagnosisJson, DistinguishesParametersOfOneName) {
    const report::Json json = json_of(with_verdict(
        VerdictKind::effects, {{"linear_drag", {{"rate", 2.0}}, false}, {"extra_damping", {{"rate", 3.0}}, false}}));
    EXPECT_EQ(json["augmented_fit"]["parameters"]["rate"], 2.0);
    EXPECT_EQ(json["augmented_fit"]["parameters"]["extra_damping.rate"], 3.0);
}

TEST(DiagnosisJson, WritesParametersByTheirType) {
    const report::Json json = effect_parameters_json({{"axis", 2.0},
                                                      {"mass_kg", 0.25},
                                                      {"open", std::nan("")},
                                                      {"place_m", Eigen::VectorXd(Eigen::Vector2d(1.0, 2.0))},
                                                      {"marker", std::string("tip")},
                                                      {"markers", std::vector<std::string>{"a", "b"}}});
    EXPECT_TRUE(json["axis"].is_number_integer());
    EXPECT_EQ(json["axis"], 2);
    EXPECT_EQ(json["mass_kg"], 0.25);
    EXPECT_TRUE(json["open"].is_null()) << "JSON has no NaN";
    EXPECT_EQ(json["place_m"], (std::vector<double>{1.0, 2.0}));
    EXPECT_EQ(json["marker"], "tip");
    EXPECT_EQ(json["markers"], (std::vector<std::string>{"a", "b"}));
}

TEST(DiagnosisJson, ListsTheEvidence) {
    Diagnosis d = with_verdict(VerdictKind::effects, {{"quadratic_drag", {}, false}});
    d.candidates[0].confounded_with = {"linear_drag"};
    d.candidates.emplace_back();
    d.candidates[1].score.id = "point_mass";
    d.candidates[1].score.failure = "the run failed";
    d.sets = {test::pair_that_leaves(0.2)};
    d.confusions = {{"quadratic_drag", "linear_drag", 0.99, "a slow release"}};
    d.cost = {{"score", 1.5, 12}};
    const report::Json details = json_of(d)["details"];
    EXPECT_EQ(details["verdict"], "effects");
    EXPECT_EQ(details["because"], "it falls.");
    EXPECT_EQ(details["candidates"][0]["indistinguishable_from"], std::vector<std::string>{"linear_drag"});
    EXPECT_FALSE(details["candidates"][0].contains("failure"));
    EXPECT_EQ(details["candidates"][1]["failure"], "the run failed");
    EXPECT_FALSE(details["candidates"][1].contains("fit"));
    EXPECT_EQ(details["sets"][0]["ids"], (std::vector<std::string>{"quadratic_drag", "cable_tug"}));
    EXPECT_EQ(details["not_to_be_told_apart"][0]["ids"], (std::vector<std::string>{"quadratic_drag", "linear_drag"}));
    EXPECT_EQ(details["not_to_be_told_apart"][0]["next_experiment"], "a slow release");
    EXPECT_EQ(details["cost"][0]["phase"], "score");
    EXPECT_EQ(details["cost"][0]["runs"], 12);
    EXPECT_FALSE(details.contains("missing_force"));
}

/// Trials that could not be run have no error.
TEST(DiagnosisJson, WritesMissingErrorsAsNull) {
    Diagnosis d = with_verdict(VerdictKind::none);
    d.after.scores.pop_back();
    d.after.validation_rms_m = std::nan("");
    const report::Json json = json_of(d);
    EXPECT_TRUE(json["trials"][1]["after_rms_m"].is_null());
    EXPECT_TRUE(json["validation"]["after_rms_m"].is_null());
    EXPECT_EQ(json["trials"][0]["after_rms_m"], 2e-4);
}

}  // namespace
}  // namespace myo::diagnosis::diagnosis_json_test
