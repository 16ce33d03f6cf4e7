#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "calibration/body_design.hpp"
#include "calibration/optimize.hpp"
#include "calibration/sought_signals.hpp"
#include "prediction/trial_goals.hpp"
#include "results/optimized_experiment.hpp"
#include "support/experiment_folder.hpp"
#include "support/figures.hpp"
#include "support/muscle_beam.hpp"

// The design of the body as what `optimize` seeks, and its result as an experiment.

namespace myo::calibration {
namespace {

using Eigen::Index;
using testing::HasSubstr;
using testing_support::replaced;

/// The beam with a muscle, planned for 0.3 s. `muscle`: what says where it is; `more`: further tables.
std::string planned_toml(const std::string& muscle, const std::string& more = "") {
    std::string toml = test::muscle_beam_toml();
    toml = replaced(toml, "box_m = [[0.0, 0.0, 0.02], [0.1, 0.03, 0.03]]\nfibre = [1, 0, 0]\n", muscle);
    toml = replaced(toml, "calibrate = [\"youngs_modulus\"]\n", "calibrate = []\n");
    return toml.substr(0, toml.find("[[trial]]")) + more +
           "[[trial]]\nname = \"reach\"\nrole = \"simulate\"\nduration_s = 0.3\nstart = \"equilibrium\"\n"
           "actuation = \"s.csv\"\n";
}

const std::string contraction = "time_s,up\n0,1\n0.1,0.85\n0.3,0.85\n";
const std::string box = "box_m = [[0.0, 0.0, 0.02], [0.1, 0.03, 0.03]]\nfibre = [1, 0, 0]\n";

/// Places of all markers at two times of the run of a setup, as goals.
std::vector<experiment::GoalDeclaration> goals_of_run(const setup::Setup& setup) {
    const prediction::TrialPrediction run = prediction::predict_trial(setup, 0, prediction::declared_values(setup));
    EXPECT_TRUE(run.ok()) << run.message;
    std::vector<experiment::GoalDeclaration> goals;
    for (const Index sample : {15, 29})
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            experiment::GoalDeclaration goal;
            goal.marker = setup.marker_names[m];
            goal.times_s = Eigen::VectorXd::Constant(1, setup.trials[0].measured.time_s(sample));
            goal.places_m = run.positions_m[m].col(sample);
            goals.push_back(goal);
        }
    return goals;
}

/// A setup whose goals are the places that another experiment reaches with the same signal.
setup::Setup towards(const test::Folder& folder, const std::string& toml, const std::string& of) {
    Result<setup::Setup> truth = test::muscle_beam_setup(folder, of, contraction);
    EXPECT_TRUE(truth) << truth.error().text();
    Result<setup::Setup> setup = test::muscle_beam_setup(folder, toml, contraction);
    EXPECT_TRUE(setup) << setup.error().text();
    setup->experiment.trials[0].goals = goals_of_run(*truth);
    Result<setup::Setup> target = prediction::with_goals(*std::move(setup));
    EXPECT_TRUE(target) << target.error().text();
    return *std::move(target);
}

struct Found {
    BodyDesign design;
    Optimization result;
};
Found sought(setup::Setup& setup, const std::vector<SoughtItem>& seek) {
    OptimizeSettings settings;
    settings.seek = seek;
    settings.max_evaluations = 60;
    Result<BodyDesign> design = body_design(setup, seek);
    EXPECT_TRUE(design) << design.error().text();
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings, design->variables);
    EXPECT_TRUE(problem) << problem.error().text();
    Found found{*design, search_signals(setup, *problem, settings, first_values(setup, problem->sought))};
    EXPECT_TRUE(found.result.usable()) << found.result.fit.message;
    judge_signals(setup, found.result);
    found.result.found = found_items(setup, found.design, found.result.fit.design);
    return found;
}

/// Largest distance of the markers at the goals after the experiment was written and opened again [m].
double reopened_error(const test::Folder& folder, const setup::Setup& setup, const Optimization& result) {
    const std::filesystem::path out = folder.path() / "out";
    std::filesystem::create_directories(out);
    const Result<std::string> text = results::optimized_experiment(folder.path() / "experiment.toml", out, setup,
                                                                   result, 0);
    EXPECT_TRUE(text) << text.error().text();
    EXPECT_TRUE(results::write_masks(out, setup.experiment, result.found));
    test::record("experiment_optimized", static_cast<double>(text->size()));
    const Result<experiment::Experiment> read = experiment::read_experiment_text(*text, out / "experiment.toml");
    EXPECT_TRUE(read) << read.error().text() << *text;
    if (!read) return 1.0;
    const Result<setup::Setup> again = setup::prepare_setup(*read, setup.settings);
    EXPECT_TRUE(again) << again.error().text();
    const prediction::TrialPrediction run = prediction::predict_trial(*again, 0, prediction::declared_values(*again));
    double worst = 0.0;
    for (const experiment::GoalDeclaration& goal : setup.experiment.trials[0].goals)
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            if (setup.marker_names[m] != goal.marker) continue;
            Index sample = 0;
            (again->trials[0].measured.time_s.array() - goal.times_s(0)).abs().minCoeff(&sample);
            worst = std::max(worst, (run.positions_m[m].col(sample) - goal.places_m.col(0)).norm());
        }
    return worst;
}

TEST(OptimizeDesign, FindsTheDirectionOfABoxedMuscleAndWritesIt) {
    const test::Folder folder("design_direction");
    const double angle = 25.0 * std::numbers::pi / 180.0;
    const std::string turned = replaced(
        box, "[1, 0, 0]", "[" + std::to_string(std::cos(angle)) + ", " + std::to_string(std::sin(angle)) + ", 0]");
    setup::Setup setup = towards(folder, planned_toml(box), planned_toml(turned));
    const Found found = sought(setup, {{SoughtKind::direction, "up"}});
    test::record("rms_m", std::vector<double>{found.result.before.fit_rms_m, found.result.after.fit_rms_m});
    EXPECT_LT(found.result.after.fit_rms_m, 0.05 * found.result.before.fit_rms_m);
    ASSERT_EQ(found.result.found.size(), 1u);
    ASSERT_TRUE(found.result.found[0].fibre);
    EXPECT_NEAR(std::abs(found.result.found[0].fibre->y() / found.result.found[0].fibre->x()), std::tan(angle), 0.03);
    EXPECT_THAT(found.result.found[0].change, HasSubstr("turned by 2"));
    EXPECT_LT(reopened_error(folder, setup, found.result), 0.1 * found.result.before.fit_rms_m);
}

TEST(OptimizeDesign, FindsTheModulusOfAPart) {
    const test::Folder folder("design_modulus");
    const auto part = [](const std::string& modulus) {
        return "[[part]]\nname = \"tip\"\nbox_m = [[0.06, 0, 0], [0.1, 0.03, 0.03]]\nyoungs_modulus_Pa = " + modulus +
               "\n\n";
    };
    setup::Setup setup = towards(folder, planned_toml(box, part("2.0e5")), planned_toml(box, part("4.0e5")));
    const Found found = sought(setup, {{SoughtKind::modulus, "tip"}});
    ASSERT_EQ(found.result.found.size(), 1u);
    EXPECT_NEAR(found.result.found[0].youngs_modulus_Pa, 4e5, 0.02 * 4e5);
    EXPECT_THAT(found.result.found[0].change, HasSubstr("from 200 to "));
    EXPECT_LT(reopened_error(folder, setup, found.result), 0.1 * found.result.before.fit_rms_m);
}

/// A painted muscle: a field of directions and the weights at once; the mask that is written gives the same run.
TEST(OptimizeDesign, PaintThatReachesGoalsIsWrittenAsAMask) {
    const test::Folder folder("design_paint");
    Result<setup::Setup> boxed = test::muscle_beam_setup(folder, planned_toml(box), contraction);
    ASSERT_TRUE(boxed) << boxed.error().text();
    const mesh::VolumeMesh& mesh = boxed->mesh.mesh;
    const fibre::CellPaint paint = fibre::paint_of_group(mesh, boxed->trials[0].model.fibres->front());
    ASSERT_TRUE(fibre::write_painted_mask(folder.path() / "up.csv", fibre::mask_of_cells(mesh, paint)));
    const std::string shifted = replaced(box, "[0.1, 0.03, 0.03]", "[0.1, 0.015, 0.03]");
    setup::Setup setup = towards(folder, planned_toml("mask = \"up.csv\"\n"), planned_toml(shifted));
    const Found found = sought(setup, {{SoughtKind::direction, "up"}, {SoughtKind::weights, "up"}});
    test::record("rms_m", std::vector<double>{found.result.before.fit_rms_m, found.result.after.fit_rms_m});
    EXPECT_LT(found.result.after.fit_rms_m, 0.3 * found.result.before.fit_rms_m);
    ASSERT_EQ(found.result.found.size(), 2u);
    ASSERT_TRUE(found.result.found[1].mask);
    EXPECT_LE(found.result.found[1].mask->weights.maxCoeff(), 1.0);
    const double reopened = reopened_error(folder, setup, found.result);
    test::record("reopened_m", reopened);
    EXPECT_LT(reopened, 3.0 * found.result.after.fit_rms_m);
}

TEST(OptimizeDesign, SaysWhatCannotBeSought) {
    const test::Folder folder("design_words");
    const Result<setup::Setup> setup = test::muscle_beam_setup(folder, planned_toml(box), contraction);
    ASSERT_TRUE(setup) << setup.error().text();
    const auto refusal = [&](const std::string& word) {
        const Result<std::vector<SoughtItem>> items = sought_items({word}, setup->experiment);
        return items ? std::string("accepted") : items.error().what;
    };
    EXPECT_THAT(refusal("weights:up"), HasSubstr("is not painted"));
    EXPECT_THAT(refusal("direction:down"), HasSubstr("no muscle is called \"down\""));
    EXPECT_THAT(refusal("modulus:tip"), HasSubstr("no part is called"));
    EXPECT_THAT(refusal("colour"), HasSubstr("is none of signals"));
    EXPECT_EQ(refusal("direction:up"), "accepted");
    for (const SoughtItem& item : seekable_items(setup->experiment)) EXPECT_EQ(refusal(to_string(item)), "accepted");
}

}  // namespace
}  // namespace myo::calibration
