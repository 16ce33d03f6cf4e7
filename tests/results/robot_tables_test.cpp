#include "results/robot_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/chambered_beam.hpp"

namespace myo::results {
namespace {

double number(const report::Cell& cell) { return std::get<double>(cell.content); }
std::string words(const report::Cell& cell) { return std::get<std::string>(cell.content); }

/// Chamber of 70 x 18 x 8 mm, a tendon of 95 mm with one guide that stands still, a part, an obstacle, two sensors.
class RobotTables : public testing::Test {
protected:
    RobotTables()
        : folder_("robot_tables"), setup_(test::chambered_beam(folder_, 0.1, [&](experiment::Experiment& e) {
              e.tendons.push_back(test::upper_tendon());
              e.tendons.back().name = "cable";
              e.tendons.back().friction = 0.1;
              experiment::PartDeclaration part;
              part.name = "tip";
              part.place = Box{{0.06, -0.01, -0.01}, {0.11, 0.04, 0.04}};
              part.youngs_modulus_Pa = 6e5;
              part.poissons_ratio = 0.48;
              part.density_kg_m3 = 1100.0;
              e.parts.push_back(part);
              e.obstacles.push_back({experiment::ObstacleDeclaration::Sphere{{0.2, 0.0, 0.0}, 0.02}, 0.3});
              e.sensors = {{"motor", experiment::SensorKind::tendon_shortening, "cable", 1e-4}};
              folder_.write("sensors.csv", "time_s,motor_m\n0,0\n0.1,0.001\n");
              e.trials[0].sensors = folder_.path() / "sensors.csv";
              e.trials[0].actuation_steps = {{"upper", 5000.0}};
              e.trials[1].actuation_steps = {{"upper", -1000.0}, {"cable", 1.5}};
          })) {}
    test::Folder folder_;
    setup::Setup setup_;
};

TEST_F(RobotTables, ShowWhatIsDeclared) {
    const std::vector<report::Block> blocks = robot_tables(setup_, prediction::declared_values(setup_));
    ASSERT_EQ(blocks.size(), 4u);
    const auto row = [&](std::size_t table) { return std::get<report::Table>(blocks[table].content).rows.at(0); };
    EXPECT_EQ(words(row(0)[0]), "upper");
    EXPECT_NEAR(number(row(0)[1]), 7.0 * 1.8 * 0.8, 1e-9);
    EXPECT_NEAR(number(row(0)[2]), 2.0 * (7.0 * 1.8 + 7.0 * 0.8 + 1.8 * 0.8), 1e-9);
    EXPECT_EQ(words(row(0)[3]), "−1.00 … 5.00 kPa");
    EXPECT_NEAR(number(row(1)[1]), 95.0, 1e-9);
    EXPECT_EQ(number(row(1)[2]), 4.0);
    EXPECT_EQ(number(row(1)[3]), 3.0);
    EXPECT_EQ(words(row(1)[4]), "straight");
    EXPECT_EQ(words(row(1)[6]), "tension 0 … 1.50 N");
    EXPECT_EQ(number(row(2)[1]), 600.0);
    EXPECT_NEAR(number(row(2)[4]), 4.0, 1e-12) << "the material's damping";
    EXPECT_EQ(words(row(3)[0]), "sphere of radius 20.0 mm");
    const report::Json json = robot_json(setup_);
    EXPECT_EQ(json["chambers"][0]["pressure_range_Pa"], report::Json({-1000.0, 5000.0}));
    EXPECT_EQ(json["tendons"][0]["drive"], "tension");
    EXPECT_EQ(json["tendons"][0]["guides_on_body"], 3);
    EXPECT_EQ(json["tendons"][0]["channel"], false);
    EXPECT_EQ(json["tendons"][0]["tension_range_N"], report::Json({0.0, 1.5}));
}

TEST_F(RobotTables, ShowSensorsBeforeAndAfter) {
    prediction::SetupRun before, after;
    before.scores.resize(1);
    before.scores[0].name = "swing";
    before.scores[0].sensors = {{"motor_m", "m", 1e-4, 2e-3}};
    after = before;
    after.scores[0].sensors[0].rms = 1.5e-4;
    const report::Table table = sensor_table(setup_, before, &after);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(words(table.rows[0][1]), "motor_m");
    EXPECT_EQ(number(table.rows[0][3]), 1e-4);
    EXPECT_EQ(number(table.rows[0][4]), 2e-3);
    EXPECT_EQ(number(table.rows[0][5]), 1.5e-4);
    EXPECT_EQ(sensor_table(setup_, before, nullptr).columns.size(), 5u);
}

}  // namespace
}  // namespace myo::results
