#include "results/robot_tables.hpp"

#include <cmath>
#include <limits>

#include "base/markup.hpp"
#include "experiment/actuators.hpp"
#include "results/output_json.hpp"

namespace myo::results {
namespace {

/// A range of commands in a readable unit: "0 … 25 kPa".
std::string range_words(const setup::CommandRange& range, const std::string& unit) {
    const bool pressure = unit == "Pa", length = unit == "m";
    const double factor = pressure ? 1e-3 : length ? 1e3 : 1.0;
    return readable_number(factor * range.lowest, 3) + " … " + readable_number(factor * range.highest, 3) + " " +
           (pressure ? "kPa"
            : length ? "mm"
                     : unit);
}

/// Range of the commands of chamber or tendon `number`, counted over both.
std::string command_words(const setup::Setup& setup, std::size_t number) {
    const std::string unit = experiment::actuators(setup.experiment)[setup.experiment.muscles.size() + number].unit;
    return range_words(setup.command_ranges[number], unit);
}

/// Length of a tendon between its guides at rest [m].
double rest_length_m(const setup::Tendon& tendon) {
    double length = 0.0;
    for (std::size_t i = 1; i < tendon.route.guides.size(); ++i)
        length += (tendon.route.guides[i].rest_m - tendon.route.guides[i - 1].rest_m).norm();
    return length;
}

/// One row per chamber, in cm³, cm² and kPa.
report::Table chamber_table(const setup::Setup& setup) {
    report::Table table{"Chambers: the declared cavities at rest, and their pressures in the trials.",
                        {{"Chamber"}, {"Volume", "cm³"}, {"Wall area", "cm²"}, {"Pressure"}},
                        {}};
    for (std::size_t c = 0; c < setup.chambers.size(); ++c) {
        const setup::Chamber& chamber = setup.chambers[c];
        table.rows.push_back(
            {chamber.name, 1e6 * chamber.volume_m3, 1e4 * chamber.wall_area_m2, command_words(setup, c)});
    }
    return table;
}

/// One row per tendon; commands are tensions or shortenings.
report::Table tendon_table(const setup::Setup& setup) {
    report::Table table{"Tendons: their paths at rest, and their commands in the trials.",
                        {{"Tendon"},
                         {"Length", "mm"},
                         {"Guides"},
                         {"Moving with the body"},
                         {"Between them"},
                         {"Friction"},
                         {"Command"}},
                        {}};
    for (std::size_t t = 0; t < setup.tendons.size(); ++t) {
        const setup::Tendon& tendon = setup.tendons[t];
        table.rows.push_back({setup.experiment.tendons[t].name, 1e3 * rest_length_m(tendon),
                              setup.experiment.tendons[t].path_m.cols(), setup::moving_guides(tendon),
                              std::string(setup.experiment.tendons[t].channel ? "in a channel" : "straight"),
                              tendon.route.friction,
                              std::string(tendon.by_shortening ? "shortening " : "tension ") +
                                  command_words(setup, setup.chambers.size() + t)});
    }
    return table;
}

/// One row per part, with fitted moduli and damping where these are parameters.
report::Table part_table(const setup::Setup& setup, const prediction::ParameterValues& values) {
    report::Table table{"Parts with a material of their own; of parts that overlap the later one counts.",
                        {{"Part"}, {"Modulus", "kPa"}, {"Poisson's ratio"}, {"Density", "kg/m³"}, {"Damping", "ms"}},
                        {}};
    for (std::size_t k = 0; k < setup.experiment.parts.size(); ++k) {
        const experiment::PartDeclaration& part = setup.experiment.parts[k];
        // NaN: the part has the damping of the body.
        const double own_s = values.part_damping_s[k];
        table.rows.push_back({part.name, 1e-3 * values.part_modulus_Pa[k], part.poissons_ratio, part.density_kg_m3,
                              1e3 * (std::isnan(own_s) ? values.damping_s : own_s)});
    }
    return table;
}

/// Shape of an obstacle; only that of a sphere has a single size.
std::string shape_words(const experiment::ObstacleDeclaration& obstacle) {
    if (std::holds_alternative<experiment::ObstacleDeclaration::Plane>(obstacle.shape)) return "plane";
    if (const auto* sphere = std::get_if<experiment::ObstacleDeclaration::Sphere>(&obstacle.shape))
        return "sphere of radius " + readable_number(1e3 * sphere->radius_m, 3) + " mm";
    return "box";
}

/// One row per obstacle with its coefficient of friction.
report::Table obstacle_table(const setup::Setup& setup) {
    report::Table table{"Obstacles, which stand still.", {{"Obstacle"}, {"Friction"}}, {}};
    for (const experiment::ObstacleDeclaration& obstacle : setup.experiment.obstacles)
        table.rows.push_back({shape_words(obstacle), obstacle.friction});
    return table;
}

/// Score of sensor `number` of a trial; null if the trial did not complete.
const prediction::SensorScore* find_sensor(const prediction::SetupRun& run, const std::string& trial,
                                           std::size_t number) {
    const prediction::TrialScore* const score = find_score(run, trial);
    return score != nullptr && number < score->sensors.size() ? &score->sensors[number] : nullptr;
}

/// [lowest, highest] in the SI unit of the command.
report::Json range_json(const setup::CommandRange& range) { return {range.lowest, range.highest}; }

}  // namespace

std::vector<report::Block> robot_tables(const setup::Setup& setup, const prediction::ParameterValues& values) {
    std::vector<report::Block> tables;
    if (!setup.chambers.empty()) tables.emplace_back(chamber_table(setup));
    if (!setup.tendons.empty()) tables.emplace_back(tendon_table(setup));
    if (!setup.experiment.parts.empty()) tables.emplace_back(part_table(setup, values));
    if (!setup.experiment.obstacles.empty()) tables.emplace_back(obstacle_table(setup));
    return tables;
}

report::Table sensor_table(const setup::Setup& setup, const prediction::SetupRun& before,
                           const prediction::SetupRun* after) {
    report::Table table{"Sensors: root mean square of prediction minus reading.",
                        {{"Trial"}, {"Column"}, {"Unit"}, {"Noise"}, {after != nullptr ? "Before" : "Error"}},
                        {}};
    if (after != nullptr) table.columns.push_back({"After"});
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const setup::PreparedTrial& trial : setup.trials)
        for (std::size_t s = 0; s < trial.sensors.size(); ++s) {
            const setup::SensorSeries& series = trial.sensors[s];
            const prediction::SensorScore* const of_before = find_sensor(before, trial.name, s);
            table.rows.push_back(
                {trial.name, series.column, series.unit, series.noise, of_before != nullptr ? of_before->rms : none});
            if (after == nullptr) continue;
            const prediction::SensorScore* const of_after = find_sensor(*after, trial.name, s);
            table.rows.back().emplace_back(of_after != nullptr ? of_after->rms : none);
        }
    return table;
}

report::Json robot_json(const setup::Setup& setup) {
    report::Json json = report::Json::object();
    for (std::size_t c = 0; c < setup.chambers.size(); ++c) {
        const setup::Chamber& chamber = setup.chambers[c];
        json["chambers"].push_back({{"name", chamber.name},
                                    {"volume_m3", report::json_number(chamber.volume_m3)},
                                    {"wall_area_m2", report::json_number(chamber.wall_area_m2)},
                                    {"pressure_range_Pa", range_json(setup.command_ranges[c])}});
    }
    for (std::size_t t = 0; t < setup.tendons.size(); ++t) {
        const setup::Tendon& tendon = setup.tendons[t];
        // Command ranges are listed for all chambers first, then for the tendons.
        const char* const range = tendon.by_shortening ? "shortening_range_m" : "tension_range_N";
        json["tendons"].push_back({{"name", setup.experiment.tendons[t].name},
                                   {"drive", tendon.by_shortening ? "shortening" : "tension"},
                                   {"rest_length_m", report::json_number(rest_length_m(tendon))},
                                   {"guides", setup.experiment.tendons[t].path_m.cols()},
                                   {"guides_on_body", setup::moving_guides(tendon)},
                                   {"channel", setup.experiment.tendons[t].channel},
                                   {"friction", tendon.route.friction},
                                   {range, range_json(setup.command_ranges[setup.chambers.size() + t])}});
    }
    return json;
}

}  // namespace myo::results
