#include "check/checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "prediction/run_trials.hpp"
#include "prediction/time_step.hpp"
#include "results/finding_output.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::check {
namespace {

using testing::HasSubstr;

std::string with(std::string text, const std::string& old, const std::string& other) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), other);
}

/// The swung beam with another declaration.
setup::Setup setup_of(const std::string& toml) {
    const test::Folder folder("checks");
    test::swung_beam(folder, 0.3);
    folder.write("experiment.toml", toml);
    return test::setup_in(folder);
}

CheckLevel worst(const std::vector<Finding>& findings) {
    CheckLevel level = CheckLevel::passed;
    for (const Finding& finding : findings) level = std::max(level, finding.level);
    return level;
}

TEST(CheckCatalogue, NamesEveryCheckOnceWithAQuestionAndASource) {
    std::set<std::string> ids;
    for (const Check& check : check_catalogue()) {
        EXPECT_TRUE(ids.insert(check.id).second) << check.id;
        EXPECT_FALSE(check.source.empty()) << check.id;
        EXPECT_EQ(check.question.back(), '?') << check.id;
        EXPECT_EQ(find_check(check.id), &check);
    }
    EXPECT_EQ(find_check("no such check"), nullptr);
}

/// Under a body's weight no more than stiffness in proportion is lost; heights and critical loads by Greenhill 1881,
/// q L^3 = 7.837 E I, which a stub of length to thickness 3.3 keeps to a sixth.
TEST(CheckPose, KnowsColumnsThatBuckleUnderTheirWeight) {
    const double weight_N_m = 1070.0 * 9.81 * 9e-4, inertia_m4 = std::pow(0.03, 4) / 12.0;
    const double critical_Pa = weight_N_m * 1e-3 / (7.837 * inertia_m4);
    const auto findings = [&](double modulus_Pa, const std::string& gravity) {
        const std::string soft = with(test::swung_beam_toml(), "2.6e5", std::to_string(modulus_Pa));
        return check_pose({setup_of(soft + "[environment]\ngravity_m_s2 = " + gravity + "\n")});
    };
    const std::string down = "[-9.81, 0, 0]";
    const std::vector<Finding> buckled = findings(0.7 * critical_Pa, down), stands = findings(2.0 * critical_Pa, down);
    ASSERT_EQ(buckled.size(), 1u);
    EXPECT_EQ(buckled[0].level, CheckLevel::wrong) << buckled[0].figure;
    EXPECT_THAT(buckled[0].sentence, HasSubstr("the undeformed pose is unstable"));
    ASSERT_EQ(stands.size(), 1u);
    EXPECT_EQ(stands[0].level, CheckLevel::passed);
    EXPECT_NEAR(stands[0].figure, 0.5, 0.5 / 6.0);
    const std::vector<Finding> lies = findings(0.7 * critical_Pa, "[0, 0, -9.81]");
    ASSERT_EQ(lies.size(), 1u);
    EXPECT_EQ(lies[0].level, CheckLevel::passed);
    EXPECT_LT(std::abs(lies[0].figure), 0.2);
}

TEST(CheckSupport, KnowsAHinge) {
    EXPECT_EQ(worst(check_support({setup_of(test::swung_beam_toml())})), CheckLevel::passed);
    const std::string hinged = with(test::swung_beam_toml(), "[0.0005, 0.031, 0.031]", "[0.0005, 0.031, 0.001]");
    const std::vector<Finding> found = check_support({setup_of(hinged)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].level, CheckLevel::wrong);
    EXPECT_THAT(found[0].sentence, HasSubstr("is a line, so that the body turns freely about it"));
}

TEST(CheckUnits, KnowsLikelySlips) {
    EXPECT_EQ(worst(check_units({setup_of(test::swung_beam_toml())})), CheckLevel::passed);
    const std::vector<std::pair<std::string, std::string>> slips{{"2.6e5", "0.26"},
                                                                 {"1070", "1.07"},
                                                                 {"damping_s = 0.004", "damping_s = 4"},
                                                                 {"noise_m = 1e-4", "noise_m = 0.1"}};
    for (const auto& [right, slip] : slips) {
        const std::vector<Finding> found = check_units({setup_of(with(test::swung_beam_toml(), right, slip))});
        EXPECT_EQ(std::count_if(found.begin(), found.end(),
                                [](const Finding& finding) { return finding.level == CheckLevel::doubtful; }),
                  1)
            << slip;
    }
}

/// One range for a quantity, however it is told.
TEST(CheckUnits, TellsTheLimitsThatItJudgesBy) {
    const std::vector<Finding> found = check_units({setup_of(with(test::swung_beam_toml(), "2.6e5", "0.26"))});
    const auto soft = std::find_if(found.begin(), found.end(),
                                   [](const Finding& finding) { return finding.level == CheckLevel::doubtful; });
    ASSERT_NE(soft, found.end());
    EXPECT_EQ(soft->sentence, "material.youngs_modulus_Pa = 0.26 Pa, below what soft robots have, 500 to 5e+09 Pa");
    EXPECT_EQ(soft->threshold, 500.0);
    EXPECT_EQ(find_check("units")->source.find_first_of("0123456789"), std::string::npos);
}

/// A body that is declared a thousand times too light swings thirty times as fast as the true one.
TEST(DeclaredSteps, AreNotChosenForUnitsInDoubt) {
    setup::Setup right = setup_of(test::swung_beam_toml());
    choose_declared_steps(right, findings_on_units(right));
    EXPECT_EQ(right.steps.size(), right.trials.size());
    EXPECT_LT(right.trials.front().options.h_s, 0.005);

    setup::Setup slip = setup_of(with(test::swung_beam_toml(), "1070", "1.07"));
    choose_declared_steps(slip, findings_on_units(slip));
    EXPECT_TRUE(slip.steps.empty());
    EXPECT_EQ(slip.trials.front().options.h_s, 0.005);
    EXPECT_FALSE(prediction::choosable(slip.settings)) << "nor after a fit";
}

TEST(CheckMarkers, KnowsThoseThatTheMeshTakesForOne) {
    EXPECT_EQ(worst(check_markers({setup_of(test::swung_beam_toml())})), CheckLevel::passed);
    const std::string near = with(test::swung_beam_toml(), "middle = [0.05, 0.015, 0.03]",
                                  "middle = [0.1, 0.001, 0.03]");
    const std::vector<Finding> found = check_markers({setup_of(near)});
    EXPECT_EQ(worst(found), CheckLevel::doubtful);
    EXPECT_THAT(found[0].sentence, HasSubstr("markers tip_left and middle are 1.00 mm apart"));
    EXPECT_THAT(found[0].way_out, HasSubstr("(--resolution, or Edge length of Mesh in the window)"));
}

TEST(CheckMarkers, WarnsOfThoseThatTheMeshLeavesInTheAir) {
    setup::Setup setup = setup_of(test::swung_beam_toml());
    const std::size_t before = check_markers({setup}).size();
    // A mesh that ends before the body does, as that of coarse cells around a thin fin.
    setup.mesh.mesh.nodes.row(0) *= 0.9;
    const std::vector<Finding> found = check_markers({setup});
    ASSERT_GT(found.size(), before);
    EXPECT_EQ(found.back().level, CheckLevel::doubtful);
    EXPECT_THAT(found.back().sentence, HasSubstr("off the mesh, whose cells do not follow the body"));
    EXPECT_THAT(found.back().way_out, HasSubstr("choose shorter edges"));
}

TEST(CheckAfter, TakesOverWhatWasAskedBefore) {
    const test::Folder folder("taken_over");  // whose traces are compared
    const setup::Setup setup = test::swung_beam(folder, 0.3);
    const std::vector<Finding> before = check_before(setup);
    prediction::SetupRun run = prediction::run_trials(setup, prediction::declared_values(setup));
    std::vector<Finding> marked = before;
    marked.front().sentence = "asked before";
    const std::vector<Finding> taken = check_after({setup, &run}, marked), asked = check_after({setup, &run});
    EXPECT_EQ(taken.front().sentence, "asked before");
    EXPECT_EQ(asked.front().sentence, before.front().sentence);
    EXPECT_EQ(taken.size(), asked.size());
    // The trial to predict has the recording of the one to fit.
    const auto shared = std::find_if(asked.begin(), asked.end(),
                                     [](const Finding& finding) { return finding.check == "recordings"; });
    ASSERT_NE(shared, asked.end());
    EXPECT_EQ(shared->level, CheckLevel::doubtful);
}

/// A recording that begins in the sag of a body that is declared straight.
TEST(CheckStart, ComparesTheFirstSampleWithTheDeclaredStart) {
    setup::Setup setup = setup_of(test::swung_beam_toml());
    EXPECT_EQ(worst(check_start({setup})), CheckLevel::passed);
    for (Eigen::Matrix3Xd& track : setup.trials[0].measured.tracks) {
        track.row(2).array() -= 0.02;
        track.row(2).rightCols(10).array() += 0.03;
    }
    const std::vector<Finding> found = check_start({setup});
    EXPECT_EQ(worst(found), CheckLevel::wrong);
    EXPECT_THAT(found[0].sentence,
                HasSubstr("trial swing: at the first sample the markers are 20.0 mm rms from where"));
    EXPECT_THAT(found[0].way_out, HasSubstr("start = \"equilibrium\""));
    // After a run its own start is compared, wherever that is.
    prediction::SetupRun run = prediction::run_trials(setup, prediction::declared_values(setup));
    EXPECT_EQ(worst(check_start({setup, &run})), CheckLevel::wrong);
    test::record(setup, 0, run.values, run.predictions[0].trace);
    run.predictions[0] = prediction::predict_trial(setup, 0, run.values);
    EXPECT_EQ(check_start({setup, &run})[0].level, CheckLevel::passed);
}

TEST(CheckInsideOut, CountsCellsAndSaysFromWhen) {
    const setup::Setup setup = setup_of(test::swung_beam_toml());
    prediction::SetupRun run;
    run.predictions.resize(setup.trials.size());
    dynamics::Trace& trace = run.predictions[0].trace;
    const Eigen::Matrix3Xd& rest = setup.mesh.mesh.nodes;
    Eigen::Matrix3Xd turned = rest;
    turned.row(0) = -rest.row(0);  // a mirror turns all of them
    trace.times_s = {0.0, 0.1, 0.2};
    trace.positions = {rest, rest, rest};
    EXPECT_EQ(worst(check_inside_out({setup, &run})), CheckLevel::passed);
    trace.positions = {rest, turned, rest};
    const std::vector<Finding> found = check_inside_out({setup, &run});
    EXPECT_EQ(worst(found), CheckLevel::wrong);
    EXPECT_EQ(found[0].figure, static_cast<double>(setup.mesh.mesh.cell_count()));
    EXPECT_THAT(found[0].sentence, HasSubstr("cells are inside out, the first at 0.1 s"));
}

/// 26 times the stiffness: 37 Hz, of which ten steps of 2.5 ms make 1.9 % less. By the vibration's own measured error.
TEST(CheckStep, SaysWhatAStepMakesOfTheVibrationThatIsSeen) {
    setup::Setup setup = setup_of(
        with(with(test::swung_beam_toml(), "2.6e5", "6.8e6"), "damping_s = 0.004", "damping_s = 1e-4"));
    prediction::SetupRun run;
    run.values = prediction::declared_values(setup);
    const auto level_at = [&](double h_s) {
        run.predictions.clear();
        for (std::size_t t = 0; t < setup.trials.size(); ++t) {
            setup::set_step(setup.trials[t], h_s);
            run.predictions.push_back(prediction::predict_trial(setup, t, run.values));
        }
        return check_step({setup, &run});
    };
    const std::vector<Finding> coarse = level_at(2.5e-3), fine = level_at(5e-4);
    EXPECT_EQ(worst(coarse), CheckLevel::wrong);
    EXPECT_THAT(coarse[0].sentence, HasSubstr("so that a modulus fitted on it is"));
    EXPECT_THAT(coarse[0].way_out, HasSubstr(" s (--dt, or Step h of Run in the window)"));
    EXPECT_EQ(worst(fine), CheckLevel::passed);
    EXPECT_NEAR(coarse[0].figure / fine[0].figure, 25.0, 3.0);  // second order
}

/// Who has looked for it hands it on: natural modes are not asked for twice.
TEST(CheckStep, TakesOverWhatWasSeen) {
    setup::Setup setup = setup_of(test::swung_beam_toml());
    prediction::SetupRun run = prediction::run_trials(setup, prediction::declared_values(setup));
    run.predictions[1].status = dynamics::RunStatus::failed;
    std::vector<setup::TrialStep> seen = prediction::steps_seen_in(setup, run);
    ASSERT_EQ(seen.size(), setup.trials.size());
    EXPECT_GT(seen[0].vibration_Hz, 0.0);
    EXPECT_EQ(seen[1].h_s, 0.0);
    const std::vector<Finding> looked_for = check_step({setup, &run}),
                               taken = check_step({.setup = setup, .run = &run, .seen = &seen});
    ASSERT_EQ(taken.size(), 1u);  // a trial that did not complete shows nothing
    EXPECT_EQ(taken[0].figure, looked_for[0].figure);
    seen[0].frequency_error = 0.5;
    EXPECT_EQ(check_step({.setup = setup, .run = &run, .seen = &seen})[0].figure, 0.5);
}

/// Nobody has looked for the step of a run such as simulate's: every trial is judged, also one without a vibration.
TEST(CheckStep, JudgesTrialsWithoutAVibration) {
    setup::Setup setup = setup_of(test::swung_beam_toml());
    for (setup::PreparedTrial& trial : setup.trials) {
        trial.model.gravity_m_s2.setZero();
        setup::set_step(trial, 0.1);
    }
    const prediction::SetupRun run = prediction::run_trials(setup, prediction::declared_values(setup));
    const std::vector<Finding> found = check_step({setup, &run});
    ASSERT_EQ(found.size(), setup.trials.size());
    EXPECT_EQ(found[0].level, CheckLevel::passed);
    EXPECT_THAT(found[0].sentence, HasSubstr("steps of 100 ms, and no vibration is seen"));
    EXPECT_THAT(found[0].sentence, HasSubstr("they damp away the first one, of "));
}

TEST(CheckResidual, NamesWhatIsSuspectedInOrder) {
    const setup::Setup setup = setup_of(test::swung_beam_toml());
    calibration::Calibration calibration;
    prediction::SetupRun run;
    std::vector<Finding> earlier{passed_finding("", "a mesh"), passed_finding("a", "a step"),
                                 passed_finding("b", "a start")};
    earlier[0].check = "mesh";
    earlier[1].check = "step";
    earlier[2].check = "start";
    const auto judged = [&](double ratio) {
        run.fit_rms_m = ratio * setup::mean_noise(setup);
        return check_residual({setup, &run, &calibration, &earlier}).front();
    };
    EXPECT_EQ(judged(1.02).level, CheckLevel::passed);
    EXPECT_EQ(judged(3.0).level, CheckLevel::doubtful);
    EXPECT_THAT(judged(3.0).sentence, HasSubstr("is 3 times the noise"));
    EXPECT_THAT(judged(3.0).way_out, HasSubstr("no check explains it: diagnose names"));
    earlier[1].level = CheckLevel::doubtful;
    earlier[2].level = CheckLevel::wrong;
    EXPECT_EQ(judged(30.0).level, CheckLevel::wrong);
    EXPECT_THAT(judged(30.0).way_out,
                HasSubstr("suspected, in this order: the start of the recording (b), the time step (a)"));
    // What mesh and step make is nothing that the model lacks.
    calibration.numerical.motion_noise_levels = 2.5;
    EXPECT_EQ(judged(3.0).level, CheckLevel::passed);
    EXPECT_THAT(judged(3.0).sentence, HasSubstr("is 3 times the noise, of which mesh and step make about 2.5"));
    EXPECT_EQ(judged(5.0).level, CheckLevel::doubtful);
}

/// simulate fits nothing: what it leaves is for a fit to mend, not for a diagnosis.
TEST(CheckResidual, OfDeclaredValuesPointsToTheFit) {
    setup::Setup setup = setup_of(test::swung_beam_toml());
    prediction::SetupRun run = prediction::run_trials(setup, prediction::declared_values(setup));
    std::vector<Finding> earlier{passed_finding("", "a step")};
    earlier[0].check = "step";
    EXPECT_TRUE(check_residual({setup, &run, nullptr, &earlier}).empty());  // nor of a diagnosis
    const auto judged = [&] {
        return check_residual({.setup = setup, .run = &run, .earlier = &earlier, .as_declared = true}).front();
    };
    // The recording is of a body at rest, which is not where the beam swings.
    EXPECT_EQ(judged().level, CheckLevel::wrong);
    EXPECT_THAT(judged().sentence, HasSubstr("with the declared values, "));
    EXPECT_THAT(judged().sentence, HasSubstr("times the noise: nothing was fitted"));
    EXPECT_THAT(judged().way_out, HasSubstr("calibrate finds the values that fit"));
    EXPECT_THAT(judged().way_out, testing::Not(HasSubstr("diagnose")));
    earlier[0].level = CheckLevel::doubtful;
    EXPECT_THAT(judged().way_out,
                testing::StartsWith("suspected, in this order: the time step; once these are settled, "));
    setup.experiment.material.calibrate.clear();
    EXPECT_THAT(judged().way_out,
                HasSubstr("name the unknown parameters (material.calibrate, or Unknown in the window), and calibrate"));
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        test::record(setup, t, run.values, run.predictions[t].trace);
        run.predictions[t] = prediction::predict_trial(setup, t, run.values);
    }
    EXPECT_EQ(judged().level, CheckLevel::passed);
    EXPECT_NEAR(judged().figure, 1.0, 0.1);
}

TEST(Findings, AreToldWorstFirstAndOnce) {
    std::vector<Finding> findings{passed_finding("", "all is well"), passed_finding("", "some"),
                                  passed_finding("", "much"), passed_finding("", "known")};
    findings[0].check = "mesh";
    findings[1].check = findings[3].check = "step";
    findings[2].check = "start";
    findings[1].level = findings[3].level = CheckLevel::doubtful;
    findings[2].level = CheckLevel::wrong;
    findings[2].way_out = "a way";
    findings[3].warned = true;
    EXPECT_EQ(results::sentences_to_report(findings), (std::vector<std::string>{"much; a way", "some"}));
    EXPECT_EQ(results::findings_line(findings), "checks: 1 green, 2 amber (step), 1 red (start)");
    const report::Json json = results::findings_json(findings);
    EXPECT_EQ(json[2]["level"], "red");
    EXPECT_FALSE(json[2].contains("figure"));
}

}  // namespace
}  // namespace myo::check
