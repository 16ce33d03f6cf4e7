#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"

// Intervals and groups in the JSON of a diagnosis, and its table of numerical errors, from made-up fits without a run.

namespace myo::diagnosis::report_values_test {
namespace {

prediction::ModelParameter number_of(const std::string& key, int component = -1) {
    prediction::ModelParameter p;
    p.kind = prediction::ModelParameter::Kind::effect;
    p.parameter.name = "effect.point_mass." + key + (component < 0 ? "" : std::to_string(component));
    p.of_effect = key;
    p.component = component;
    return p;
}

/// A mass of 2 kg at a place, with a fitted direction; the first component of the place is not determined.
Diagnosis with_mass() {
    Diagnosis d = test::with_candidate(0.3);
    d.augmented = *d.candidates[0].judged;
    JointFit& fit = d.augmented.fit;
    fit.effects = {{"point_mass", {{"mass_kg", 2.0}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(0.1, 0.2, 0.3))}}}};
    fit.values.effects = fit.effects;
    fit.parameters = {number_of("mass_kg"), number_of("position_m", 0), number_of("position_m", 1),
                      number_of("axis", 0)};
    fit.parameters[0].parameter.lower = 1.9;
    fit.parameters[3].base = Eigen::Vector3d::UnitZ();
    fit.report.deviations = Eigen::Vector4d(0.1, std::nan(""), 0.01, 0.5);
    d.verdict.kind = VerdictKind::effects;
    d.verdict.effects = fit.effects;
    return d;
}

TEST(ReportValues, IntervalsAreOfTheFittedNumbersOfAnEffect) {
    Diagnosis d = with_mass();
    d.repeatability.repeats = {{0, 1}};
    d.repeatability.rms_m = 3e-4;
    const report::Json json = diagnosis_json({}, d, "mass");
    const report::Json& intervals = json["verdict"]["effects"][0]["intervals"];
    EXPECT_EQ(intervals.size(), 2u) << "an angle has none";
    EXPECT_EQ(intervals["mass_kg"][0], 1.9) << "the bound is nearer than 1.96 deviations";
    EXPECT_NEAR(intervals["mass_kg"][1].get<double>(), 2.195996, 1e-6);
    ASSERT_EQ(intervals["position_m"].size(), 2u);
    EXPECT_TRUE(intervals["position_m"][0].is_null());
    EXPECT_NEAR(intervals["position_m"][1][0].get<double>(), 0.2 - 0.0195996, 1e-6);
    EXPECT_TRUE(json["details"]["augmented"]["std"]["effect.point_mass.position_m0"].is_null());
    EXPECT_EQ(json["verdict"]["floor_m"], 3e-4);
}

TEST(ReportValues, GroupsAreTwinsAndUndecidedConfusions) {
    Diagnosis d = with_mass();
    d.verdict.twins = {{"point_mass", "tip_load"}};
    d.confusions = {{"tip_load", "point_mass", 1.0, ""}, {"point_mass", "creep", 0.98, ""}, {"a", "b", 0.99, ""}};
    const std::vector<std::vector<std::string>> expected{{"point_mass", "tip_load"}, {"point_mass", "creep"}};
    EXPECT_EQ(diagnosis_json({}, d, "mass")["verdict"]["not_told_apart"], expected);
}

std::string text(const report::Table& table, std::size_t row, std::size_t column) {
    return std::get<std::string>(table.rows.at(row).at(column).content);
}
double number(const report::Table& table, std::size_t row, std::size_t column) {
    return std::get<double>(table.rows.at(row).at(column).content);
}

TEST(ReportValues, NumericalErrorsAreInMillimetresAndNoises) {
    setup::Setup setup;
    setup.trials.resize(1);
    setup.trials[0].options.h_s = 0.005;
    Diagnosis d = with_mass();
    d.step_factors = {2.0};
    d.numerics.step_ratio = 0.5;
    d.numerics.step_rms_m = 0.2 * test::noise_m;
    d.numerics.rest_rms_m = 0.3 * test::noise_m;
    const auto table = [&] { return std::get<report::Table>(numerics_section(setup, d).blocks.at(1).content); };
    ASSERT_EQ(table().rows.size(), 3u);
    EXPECT_EQ(text(table(), 0, 1), "steps of 10 ms times 0.50");
    EXPECT_NEAR(number(table(), 0, 2), 0.02, 1e-12);
    EXPECT_NEAR(number(table(), 0, 3), 0.2, 1e-12);
    EXPECT_EQ(text(table(), 1, 1), "no finer mesh was made");
    EXPECT_TRUE(std::isnan(number(table(), 1, 2)));
    d.numerics.effective_modulus.mesh = 0.1;
    ASSERT_EQ(table().rows.size(), 4u);
    EXPECT_EQ(text(table(), 2, 1), "with cells of 1.100 times the body's modulus");
    EXPECT_NEAR(number(table(), 2, 3), 0.3, 1e-12);
}

}  // namespace
}  // namespace myo::diagnosis::report_values_test
