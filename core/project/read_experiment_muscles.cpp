#include <cmath>

#include "base/text.hpp"
#include "project/read_experiment_tables.hpp"

namespace myo {

Eigen::Vector3d unit_direction(const TomlReader& table, const std::string& key) {
    const Eigen::Vector3d direction = table.vector3(key);
    const double length = direction.norm();
    if (length == 0.0) table.fail(key, "has no direction: it is zero");
    if (!(std::abs(length - 1.0) <= 0.01))
        table.fail(key, "must be a unit vector, not one of length " + format_number(length, 4));
    return direction / length;
}

std::vector<MuscleDeclaration> read_muscles(const TomlReader& document) {
    std::vector<MuscleDeclaration> muscles;
    for (const TomlReader& table : document.tables("muscle", {"name", "box_m", "fibre", "stiffness_Pa", "follows"})) {
        MuscleDeclaration muscle;
        muscle.name = table.name("name");
        if (muscle.name.find(',') != std::string::npos || muscle.name == "time_s")
            table.fail("name", "heads a column of the actuation file, so it must not hold a comma or be time_s");
        muscle.box_m = table.box("box_m");
        muscle.fibre = unit_direction(table, "fibre");
        muscle.stiffness_Pa = table.number("stiffness_Pa", positive());
        if (table.has("follows")) {
            const TomlReader follows = table.table("follows", {"muscle", "ratio"});
            muscle.follows = FollowsDeclaration{follows.text("muscle"), follows.number("ratio")};
        }
        muscles.push_back(muscle);
    }
    return muscles;
}

}  // namespace myo
