#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "measurement/actuation_csv.hpp"

namespace myo::experiment {

Eigen::Vector3d unit_direction(const toml::TomlReader& table, const std::string& key) {
    const Eigen::Vector3d direction = table.vector3(key);
    const double length = direction.norm();
    if (length == 0.0) table.fail(key, "has no direction: it is zero");
    if (!(std::abs(length - 1.0) <= 0.01))
        table.fail(key, "must be a unit vector, not one of length " + format_number(length, 4));
    return direction / length;
}

std::string read_actuator_name(const toml::TomlReader& table) {
    std::string name = table.name("name");
    if (name.find(',') != std::string::npos || name == "time_s")
        table.fail("name", "heads a column of the actuation file, so it must not hold a comma or be time_s");
    return name;
}

namespace {

/// Polyline and radius of a muscle that follows a line [m].
MuscleLine read_line(const toml::TomlReader& table) {
    table.reject("fibre", "the fibres of a line run along it; leave this key out");
    MuscleLine muscle{{table.points("line_m")}, table.number("radius_m", toml::positive())};
    const Eigen::Matrix3Xd& points = muscle.line.points_m;
    if (points.cols() < 2) table.fail("line_m", "must have at least two points, not " + std::to_string(points.cols()));
    // Coincident neighbours have no tangent, hence no fibre direction.
    for (Eigen::Index i = 1; i < points.cols(); ++i)
        if (!((points.col(i) - points.col(i - 1)).norm() > 1e-3 * muscle.radius_m))
            table.fail("line_m", "points " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same");
    return muscle;
}

/// Location of a muscle: exactly one of box_m, mask and line_m.
std::variant<MuscleBox, MuscleMask, MuscleLine> read_part(const toml::TomlReader& table,
                                                          const std::filesystem::path& folder) {
    std::vector<std::string> given;
    for (const char* key : {"box_m", "mask", "line_m"})
        if (table.has(key)) given.emplace_back(key);
    if (given.empty()) table.fail("box_m", "where the muscle is, is missing: give one of box_m, mask, line_m");
    if (given.size() > 1)
        table.fail(given.back(),
                   "cannot be combined with " + given.front() + "; a muscle has exactly one of box_m, mask, line_m");
    if (given.front() != "line_m") table.reject("radius_m", "belongs to line_m, which is missing");
    if (given.front() == "line_m") return read_line(table);
    if (given.front() == "box_m") return MuscleBox{table.box("box_m"), unit_direction(table, "fibre")};
    MuscleMask mask{table.file("mask", folder), std::nullopt};
    if (table.has("fibre")) mask.fibre = unit_direction(table, "fibre");
    return mask;
}

/// Column of this muscle in the actuation file given by `signal`.
fibre::Signal read_signal(const toml::TomlReader& table, const std::filesystem::path& folder, const std::string& name) {
    const std::filesystem::path file = table.file("signal", folder);
    const Result<measurement::ActuationTable> read = measurement::read_actuation_csv(file);
    if (!read) table.fail("signal", read.error().text());
    // A file may hold the signals of several muscles, each under its name.
    const auto column = std::find(read->muscles.begin(), read->muscles.end(), name);
    if (column == read->muscles.end())
        table.fail("signal", file.filename().string() + " has no column \"" + name + "\"");
    // The table has one row per muscle and one column per time; other columns of the file belong to other muscles.
    const Eigen::VectorXd row = read->values.row(column - read->muscles.begin());
    return {{read->time_s.begin(), read->time_s.end()}, {row.begin(), row.end()}};
}

}  // namespace

std::vector<MuscleDeclaration> read_muscles(const toml::TomlReader& document, const std::filesystem::path& folder) {
    std::vector<MuscleDeclaration> muscles;
    for (const toml::TomlReader& table : document.tables(
             "muscle",
             {"name", "box_m", "mask", "line_m", "radius_m", "fibre", "stiffness_Pa", "follows", "signal", "sought"})) {
        MuscleDeclaration muscle;
        muscle.name = read_actuator_name(table);
        muscle.part = read_part(table, folder);
        muscle.stiffness_Pa = table.number("stiffness_Pa", toml::positive());
        if (table.has("follows")) {
            const toml::TomlReader follows = table.table("follows", {"muscle", "ratio"});
            muscle.follows = FollowsDeclaration{follows.text("muscle"), follows.number("ratio")};
        }
        // A follower takes its activation from the leader, so a signal of its own would contradict it.
        if (table.has("signal") && muscle.follows)
            table.fail("signal", "cannot be combined with follows; a muscle has one of the two");
        if (muscle.follows) table.reject("sought", "belongs to the muscle that this one follows");
        muscle.sought = table.boolean_or("sought", true);
        if (table.has("signal")) {
            muscle.signal = read_signal(table, folder, muscle.name);
            // The name of the file is kept for messages and for the list of input files in results.
            muscle.signal_file = table.file("signal", folder);
        }
        muscles.push_back(muscle);
    }
    return muscles;
}

}  // namespace myo::experiment
