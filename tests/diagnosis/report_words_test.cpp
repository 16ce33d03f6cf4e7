#include <gtest/gtest.h>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/made_fits.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "diagnosis/report/effect_words.hpp"
#include "support/swung_beam.hpp"

// Words and small tables of the report, and the settings of a diagnosis.

namespace myo::diagnosis::report_words_test {
namespace {

TEST(EffectWords, HoldValuesOfEveryType) {
    EXPECT_EQ(parameter_words({{"a", 1.0 / 3.0}, {"b", std::string("tip")}}), "a = 0.333333, b = tip");
    EXPECT_EQ(parameter_words(
                  {{"m", std::vector<std::string>{"x", "y"}}, {"v", Eigen::VectorXd(Eigen::Vector2d(0.5, -2.0))}}),
              "m = [x, y], v = [0.5, -2]");
    EXPECT_EQ(effect_words({"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false}),
              "quadratic_drag (coefficient_kg_m3 = 900)");
}

TEST(ReportWords, JoinNamesAsInASentence) {
    EXPECT_EQ(names_of({}), "");
    EXPECT_EQ(names_of({{"quadratic_drag", {}}}), "quadratic drag");
    EXPECT_EQ(names_of({{"quadratic_drag", {}}, {"point_mass", {}}}), "quadratic drag and point mass");
    EXPECT_EQ(names_of({{"a", {}}, {"b", {}}, {"c", {}}}), "a, b and c");
}

TEST(ReportWords, WritePValuesReadably) {
    EXPECT_EQ(p_words(std::nan("")), "–");
    EXPECT_EQ(p_words(0.9e-12), "< 10⁻¹²");
    EXPECT_NE(p_words(1.1e-12), "< 10⁻¹²");
    EXPECT_EQ(p_words(7.0), p_words(1.0)) << "bounds of probabilities may exceed one";
}

TEST(ReportWords, WriteEstimatesWithTheirUnit) {
    EXPECT_EQ(estimate_words({"Drag", "903", "12", "kg/m³"}), "903 ± 12\u00a0kg/m³");
    EXPECT_EQ(estimate_words({"Ratio", "0.5", "", ""}), "0.5");
}

TEST(ReportWords, SayWhichFitIsCompared) {
    Diagnosis d = test::with_candidate(0.3);
    d.augmented = *d.candidates[0].judged;
    d.verdict.kind = VerdictKind::effects;
    EXPECT_TRUE(has_two_fits(d));
    EXPECT_EQ(after_words(d), "with quadratic drag");
    d.verdict.kind = VerdictKind::unknown;
    EXPECT_EQ(after_words(d), "best attempt, quadratic drag");
    EXPECT_TRUE(has_two_fits(d));
    d.augmented = d.declared;
    EXPECT_FALSE(has_two_fits(d));
    EXPECT_EQ(after_words(d), "declared model, fitted again");
    d.augmented = *d.candidates[0].judged;
    d.verdict.kind = VerdictKind::none;
    EXPECT_FALSE(has_two_fits(d));
}

/// First paragraph of the section about a force that goes with a quantity.
std::string force_words(const std::string& name, double correlation, double p = 1e-6, double steady = 0.0) {
    Diagnosis d;
    d.missing_force.emplace();
    MissingForce& force = *d.missing_force;
    force.trial = "swing";
    force.time_s = Eigen::Vector2d(0.0, 1.0);
    force.before_over_noise = 10.0;
    force.after_over_noise = 5.0;
    ForceMode mode;
    mode.amplitude_N = Eigen::Vector2d(0.25, -0.5);
    mode.where = "at the free end, along +z";
    mode.steady = steady;
    mode.correlates = {{name, correlation, 12.0, p}};
    force.modes = {mode};
    return std::get<report::Paragraph>(force_section(d).blocks.front().content).text;
}

TEST(ReportWords, InterpretTheCourseOfAForce) {
    for (const auto& [name, correlation, words] : {std::tuple{"position", -0.9, "like a spring."},
                                                   {"position", 0.9, "a spring that is softer than declared"},
                                                   {"velocity", -0.9, "it brakes, like a drag"},
                                                   {"|v| v", 0.9, "less damping than declared"},
                                                   {"acceleration", -0.9, "a mass that is not in the model"},
                                                   {"acceleration", 0.9, "as if there were less mass"},
                                                   {"strain rate", 0.9, "like damping in the material"},
                                                   {"time", 0.9, "it drifts with time"},
                                                   {"activation of left", 0.9, "it goes with the activation of left"}})
        EXPECT_NE(force_words(name, correlation).find(words), std::string::npos) << force_words(name, correlation);
    EXPECT_NE(force_words("time", 0.9).find("up to 0.50 N"), std::string::npos);
    EXPECT_NE(force_words("time", 0.9).find("75.0 %"), std::string::npos) << force_words("time", 0.9);
}

TEST(ReportWords, InterpretOnlyClearCourses) {
    const DiagnosisReportPolicy policy;
    const std::string none = "follows none of the tested quantities";
    EXPECT_EQ(force_words("time", 1.01 * policy.min_correlation).find(none), std::string::npos);
    EXPECT_NE(force_words("time", 0.99 * policy.min_correlation).find(none), std::string::npos);
    EXPECT_EQ(force_words("time", 0.9, 0.99 * policy.max_p).find(none), std::string::npos);
    EXPECT_NE(force_words("time", 0.9, 1.01 * policy.max_p).find(none), std::string::npos);
    EXPECT_NE(force_words("time", 0.9, 1e-6, 0.9).find("nearly constant"), std::string::npos);
}

TEST(ReportTables, SumTheCostOfThePhases) {
    Diagnosis d;
    d.cost = {{"score", 1.5, 12}, {"refit", 2.5, 30}};
    d.seconds = 4.5;
    const auto table = std::get<report::Table>(cost_section(d).blocks.front().content);
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(std::get<std::string>(table.rows[1][0].content), "refit");
    EXPECT_EQ(std::get<double>(table.rows[2][1].content), 4.5);
    EXPECT_EQ(std::get<double>(table.rows[2][2].content), 42.0);
}

TEST(ReportTables, SayWhetherTheDataDecideBetweenConfoundedEffects) {
    Diagnosis d = test::with_candidate(0.3);
    d.candidates.emplace_back();
    d.candidates[1].score.id = "linear_drag";
    d.verdict.effects = {{"quadratic_drag", {}, false}};
    d.confusions = {{"quadratic_drag", "linear_drag", 0.99, "a slow release"}};
    const auto decides = [&] {
        const auto table = std::get<report::Table>(confusion_section(d).blocks.back().content);
        return std::get<std::string>(table.rows.at(0).at(3).content);
    };
    EXPECT_EQ(decides(), "no") << "the rival was not fitted";
    d.candidates[1].judged = test::fit_that_leaves(5.0, "linear_drag");
    d.candidates[1].judged->weight = 0.99 * ConfusionPolicy{}.comparable_weight;
    EXPECT_EQ(decides(), "yes, by the fits");
    d.candidates[1].judged->weight = 1.01 * ConfusionPolicy{}.comparable_weight;
    EXPECT_EQ(decides(), "no");
}

TEST(DiagnoseSettings, NameWhatIsNotExcluded) {
    DiagnoseSettings settings;
    settings.without = {"point_mass"};
    EXPECT_FALSE(may_be_named(settings, "point_mass"));
    EXPECT_TRUE(may_be_named(settings, "quadratic_drag"));
}

/// Tolerances are at least those of the policy, and runs keep their paths; the given setup stays as it was.
TEST(PreparedSetup, HasTheTolerancesOfThePolicy) {
    const test::Folder folder("prepared_setup");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    setup.trials[0].options.solver.tolerance = 1e-9;
    setup.trials[1].options.solver.tolerance = 1e-3;
    DiagnoseSettings settings;
    settings.policy.numerics.solver_tolerance = 1e-5;
    const setup::Setup prepared = prepared_setup(setup, settings);
    EXPECT_EQ(prepared.trials[0].options.solver.tolerance, 1e-5);
    EXPECT_EQ(prepared.trials[1].options.solver.tolerance, 1e-3);
    EXPECT_TRUE(prepared.trials[0].options.keep_path);
    EXPECT_EQ(setup.trials[0].options.solver.tolerance, 1e-9);
    EXPECT_FALSE(setup.trials[0].options.keep_path);
}

}  // namespace
}  // namespace myo::diagnosis::report_words_test
