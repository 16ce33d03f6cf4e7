#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

/// Guides of a tendon at rest, 3 x n [m], from the motor to the anchor.
Eigen::Matrix3Xd read_path(const toml::TomlReader& table) {
    Eigen::Matrix3Xd path = table.points("path_m");
    if (path.cols() < 2) table.fail("path_m", "a tendon needs at least two guides, not " + std::to_string(path.cols()));
    // The direction between two guides at one place is not defined.
    for (Eigen::Index i = 1; i < path.cols(); ++i)
        if (path.col(i) == path.col(i - 1))
            table.fail("path_m", "guides " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same");
    return path;
}

}  // namespace

std::vector<TendonDeclaration> read_tendons(const toml::TomlReader& document) {
    std::vector<TendonDeclaration> tendons;
    for (const toml::TomlReader& table :
         document.tables("tendon", {"name", "path_m", "drive", "stiffness_N_m", "friction", "channel", "sought"})) {
        TendonDeclaration tendon;
        tendon.name = read_actuator_name(table);
        tendon.path_m = read_path(table);
        tendon.drive = table.choice<TendonDrive>(
            "drive", {{"tension", TendonDrive::tension}, {"shortening", TendonDrive::shortening}});
        if (tendon.drive == TendonDrive::tension)
            table.reject("stiffness_N_m",
                         "belongs to drive = \"shortening\": a prescribed tension does not depend on it");
        tendon.stiffness_N_m = table.optional_number("stiffness_N_m", toml::positive());
        tendon.friction = table.number_or("friction", 0.0, toml::not_negative());
        tendon.channel = table.boolean_or("channel", false);
        tendon.sought = table.boolean_or("sought", true);
        tendons.push_back(std::move(tendon));
    }
    return tendons;
}

}  // namespace myo::experiment
