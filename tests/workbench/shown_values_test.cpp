#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "backend/body_actuators.hpp"
#include "backend/check_rows.hpp"
#include "backend/fields.hpp"
#include "backend/found_commands.hpp"
#include "backend/import_problem.hpp"
#include "backend/law_settings.hpp"
#include "check/catalogue.hpp"
#include "experiment/actuators.hpp"
#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "support/folder.hpp"
#include "toml/toml_path.hpp"

// Values of the core as the window shows them, and edits of the declaration that a search makes.

namespace myo::backend::shown_values_test {
namespace {

using testing::IsEmpty;

check::Finding finding(const std::string& id, check::CheckLevel level, double figure, const std::string& unit) {
    check::Finding made = check::passed_finding("subject", "sentence");
    made.check = id;
    made.level = level;
    made.figure = figure;
    made.unit = unit;
    return made;
}

std::string figure_of(double figure, const std::string& unit, const std::string& id = "mesh") {
    return check_rows({finding(id, check::CheckLevel::passed, figure, unit)}).front().figure;
}

TEST(ShownValues, FiguresOfChecksHaveReadableUnits) {
    EXPECT_EQ(figure_of(320000.0, "Pa"), "320 kPa");
    EXPECT_EQ(figure_of(999.0, "Pa"), "999 Pa");
    EXPECT_EQ(figure_of(1000.0, "Pa"), "1 kPa");
    EXPECT_EQ(figure_of(-2.5e6, "Pa"), "-2.5 MPa");
    EXPECT_EQ(figure_of(3e9, "Pa"), "3 GPa");
    EXPECT_EQ(figure_of(1070.0, "kg/m3"), "1070 kg/m³");
    EXPECT_EQ(figure_of(9.81, "m/s2"), "9.81 m/s²");
    EXPECT_EQ(figure_of(0.00123, "m"), "1.23 mm");
    EXPECT_EQ(figure_of(1.5, "m"), "1.5 m");
    EXPECT_EQ(figure_of(0.0042, "", "step"), "0.42 %");
    EXPECT_EQ(figure_of(0.0042, ""), "0.0042");
    EXPECT_EQ(figure_of(12345.0, ""), "12345");
    EXPECT_EQ(figure_of(std::numeric_limits<double>::quiet_NaN(), "Pa"), "");
    EXPECT_EQ(figure_of(std::numeric_limits<double>::infinity(), "m"), "");
}

TEST(ShownValues, ChecksStandWorstFirstAndOtherwiseInTheirOrder) {
    using check::CheckLevel;
    const ui::commands::CheckRows rows = check_rows(
        {finding("a", CheckLevel::passed, 0.0, ""), finding("b", CheckLevel::doubtful, 0.0, ""),
         finding("c", CheckLevel::wrong, 0.0, ""), finding("d", CheckLevel::doubtful, 0.0, ""),
         finding("e", CheckLevel::passed, 0.0, "")});
    std::string order;
    for (const ui::commands::CheckRow& row : rows) order += row.id;
    EXPECT_EQ(order, "cbdae");
    EXPECT_EQ(rows[0].state, ui::commands::CheckState::red);
    EXPECT_EQ(rows[1].state, ui::commands::CheckState::amber);
    EXPECT_EQ(rows[4].state, ui::commands::CheckState::green);
    // A check of a later version asks what its id says.
    EXPECT_EQ(rows[0].question, "c");
    EXPECT_EQ(rows[0].task, "run");
}

TEST(ShownValues, AResidualOfDeclaredValuesAsksForAFitFirst) {
    const std::vector<check::Finding> residual{finding("residual", check::CheckLevel::wrong, 2.0, "")};
    EXPECT_EQ(check_rows(residual, true).front().task, "fit");
    EXPECT_EQ(check_rows(residual, false).front().task, "diagnose");
    EXPECT_EQ(check_rows({finding("step", check::CheckLevel::wrong, 2.0, "")}, true).front().task,
              check::find_check("step")->task);
}

TEST(ShownValues, NumbersOfALawKeepToItsBoundsAndOrder) {
    const std::vector<ui::commands::Choice> choices = law_choices();
    ASSERT_EQ(choices.size(), material::material_catalogue().size());
    for (const ui::commands::Choice& choice : choices) {
        ui::commands::Settings settings;
        settings.material = choice.id;
        const std::vector<material::LawParameter> parameters = material::find_material(choice.id)->parameters();
        ASSERT_EQ(choice.numbers.size(), parameters.size()) << choice.id;
        std::vector<double> usual, beyond, highest;
        for (const material::LawParameter& p : parameters) {
            usual.push_back(p.usual);
            beyond.push_back(2.0 * std::abs(p.upper) + 1.0);
            highest.push_back(p.upper);
        }
        EXPECT_EQ(law_values(settings), usual) << choice.id;
        settings.law["of another law"] = 7.0;
        set_law_values(beyond, settings);
        EXPECT_EQ(law_values(settings), highest) << choice.id;
        EXPECT_EQ(settings.law.size(), parameters.size() + 1);
        // Too many values are those of another law, too few leave the rest.
        set_law_values({}, settings);
        EXPECT_EQ(law_values(settings), highest) << choice.id;
    }
    ui::commands::Settings unknown;
    unknown.material = "no such law";
    EXPECT_THAT(law_values(unknown), IsEmpty());
    set_law_values({1.0}, unknown);
    EXPECT_TRUE(unknown.law.empty());
}

/// An experiment with a muscle, a chamber and a tendon that is shortened.
experiment::Experiment driven() {
    experiment::Experiment made;
    made.muscles.resize(1);
    made.muscles[0].name = "m";
    made.chambers.resize(1);
    made.chambers[0].name = "c";
    made.tendons.resize(1);
    made.tendons[0].name = "t";
    made.tendons[0].drive = experiment::TendonDrive::shortening;
    made.trials.resize(2);
    return made;
}

TEST(ShownValues, CommandsOfASearchAreDeclaredByTheirKind) {
    const experiment::Experiment experiment = driven();
    const fibre::Signal rising{{0.0, 1.0}, {0.0, 2000.0}}, held = fibre::Signal::constant(0.002);
    const std::vector<ui::commands::DeclarationEdit> edits = found_command_edits(experiment, 1, {rising, held});
    ASSERT_EQ(edits.size(), 4u);
    const auto removed = [&](std::size_t i) {
        return toml::path_text(std::get<ui::commands::RemoveDeclared>(edits[i]).path);
    };
    const auto set = [&](std::size_t i) { return std::get<ui::commands::SetDeclared>(edits[i]); };
    EXPECT_EQ(removed(0), "trial[1].actuation_step.c");
    EXPECT_EQ(toml::path_text(set(1).path), "trial[1].pressure_Pa.c");
    EXPECT_EQ(set(1).value, "[[0.0, 0.0], [1.0, 2000.0]]");
    EXPECT_EQ(removed(2), "trial[1].actuation_step.t");
    EXPECT_EQ(toml::path_text(set(3).path), "trial[1].shortening_m.t");
    EXPECT_EQ(set(3).value, "0.002");
    EXPECT_THAT(found_command_edits(experiment, 0, {}), IsEmpty());
}

TEST(ShownValues, AHoldTakesTheCommandAtItsStart) {
    experiment::Experiment experiment = driven();
    experiment.trials[0].hold = true;
    const fibre::Signal rising{{-1.0, 1.0}, {1000.0, 3000.0}};
    const std::vector<ui::commands::DeclarationEdit> edits = found_command_edits(experiment, 0, {rising});
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(std::get<ui::commands::SetDeclared>(edits[1]).value, "2000.0");
}

TEST(ShownValues, NothingIsDeclaredBesideAColumnOfTheFile) {
    const test::Folder folder("found_commands");
    experiment::Experiment experiment = driven();
    const fibre::Signal held = fibre::Signal::constant(1.0);
    const std::string column = experiment::actuators(experiment)[2].column;
    for (const auto& [header, count] : {std::pair{std::string("m"), 4u}, std::pair{"m," + column, 0u}}) {
        folder.write("signals.csv", "time_s," + header + "\n0," + (count > 0u ? "1" : "1,0") + "\n");
        experiment.trials[0].actuation = folder.path() / "signals.csv";
        EXPECT_EQ(found_command_edits(experiment, 0, {held, held}).size(), count) << header;
    }
    experiment.trials[0].actuation = folder.path() / "absent.csv";
    EXPECT_THAT(found_command_edits(experiment, 0, {held, held}), IsEmpty());
}

TEST(ShownValues, CommandsAreShownInTheirUnit) {
    const auto shown = [](const std::string& unit) {
        experiment::Actuator actuator;
        actuator.unit = unit;
        return shown_unit(actuator);
    };
    EXPECT_EQ(shown("Pa").unit, "kPa");
    EXPECT_EQ(shown("Pa").per_unit, 1e3);
    EXPECT_EQ(shown("m").unit, "mm");
    EXPECT_EQ(shown("m").per_unit, 1e-3);
    EXPECT_EQ(shown("N").unit, "N");
    EXPECT_EQ(shown("N").per_unit, 1.0);
}

/// A turn of axes maps recorded axis i to axis k; a mirror or a repeated axis has no determinant of 1.
TEST(ShownValues, AxesOfARecordingAreTurns) {
    EXPECT_EQ(axes_rotation({1, 2, 3}), Eigen::Matrix3d::Identity());
    EXPECT_EQ(axes_rotation({1, -3, 2}) * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, -3, 2));
    EXPECT_NEAR(axes_rotation({1, -3, 2}).determinant(), 1.0, 1e-15);
    EXPECT_NEAR(axes_rotation({1, 3, 2}).determinant(), -1.0, 1e-15);
    EXPECT_NEAR(axes_rotation({1, 1, 2}).determinant(), 0.0, 1e-15);
}

TEST(ShownValues, FieldsWithoutAModelAreThoseOfTheFrames) {
    ui::commands::MeshedBody body;
    body.mesh = mesh::box_hex_mesh({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, {1, 1, 1});
    const Eigen::Matrix3Xd& X = body.mesh.nodes;
    ui::commands::RunResult run;
    run.trials.resize(1);
    run.trials[0].frame_time_s = Eigen::Vector3d(0.0, 0.1, 0.3);
    const Eigen::Vector3d way(3.0, 0.0, 4.0);
    for (const double share : {0.0, 0.01, 0.09}) run.trials[0].frames.emplace_back(X.colwise() + share * way);
    const auto at = [&](const char* id, std::size_t frame) { return field_values(id, body, run, 0, frame); };
    EXPECT_LT(at("displacement", 0).norm(), 1e-15);
    EXPECT_NEAR(at("displacement", 2)(5), 0.45, 1e-12);
    EXPECT_EQ(at("displacement", 2).size(), 8);
    // Forward, central and backward over the times that lie between.
    EXPECT_NEAR(at("velocity", 0)(3), 0.05 / 0.1, 1e-12);
    EXPECT_NEAR(at("velocity", 1)(3), 0.45 / 0.3, 1e-12);
    EXPECT_NEAR(at("velocity", 2)(3), 0.40 / 0.2, 1e-12);
    run.trials[0].frames.resize(1);
    EXPECT_EQ(at("velocity", 0), Eigen::VectorXd::Zero(8));
    // Stresses need the models of the run, and unknown fields are none.
    for (const ui::commands::FieldKind& kind : field_catalogue())
        EXPECT_EQ(at(kind.id.c_str(), 0).size() > 0, kind.id == "displacement" || kind.id == "velocity") << kind.id;
    EXPECT_EQ(at("temperature", 0).size(), 0);
}

}  // namespace
}  // namespace myo::backend::shown_values_test
