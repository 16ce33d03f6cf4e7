#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

enum class ObstacleKind { plane, sphere, box };

/// Keys of each kind of obstacle.
struct ObstacleKeys {
    ObstacleKind kind;
    const char* word;
    std::vector<const char*> keys;
};

/// Kinds with their words and keys; a key of one kind is refused in all others.
const std::vector<ObstacleKeys>& obstacle_keys() {
    static const std::vector<ObstacleKeys> all{{ObstacleKind::plane, "plane", {"point_m", "normal"}},
                                               {ObstacleKind::sphere, "sphere", {"centre_m", "radius_m"}},
                                               {ObstacleKind::box, "box", {"box_m"}}};
    return all;
}

/// Shape of an obstacle; keys of another kind are refused, as they would have no effect.
std::variant<ObstacleDeclaration::Plane, ObstacleDeclaration::Sphere, Box> read_shape(const toml::TomlReader& table) {
    std::vector<std::pair<std::string, ObstacleKind>> words;
    for (const ObstacleKeys& known : obstacle_keys()) words.emplace_back(known.word, known.kind);
    const ObstacleKind kind = table.choice<ObstacleKind>("kind", words);
    for (const ObstacleKeys& other : obstacle_keys())
        for (const char* key : other.keys)
            if (other.kind != kind) table.reject(key, std::string("belongs to kind = \"") + other.word + "\"");
    if (kind == ObstacleKind::box) return table.box("box_m");
    if (kind == ObstacleKind::sphere)
        return ObstacleDeclaration::Sphere{table.vector3("centre_m"), table.number("radius_m", toml::positive())};
    // Only the direction of a normal counts, so any length is accepted.
    const Eigen::Vector3d normal = table.vector3("normal");
    if (!(normal.norm() > 0.0)) table.fail("normal", "has no direction: it is zero");
    return ObstacleDeclaration::Plane{table.vector3("point_m"), normal.normalized()};
}

}  // namespace

MountMotion read_mount(const toml::TomlReader& document) {
    if (!document.has("mount")) return MountMotion::fixed;
    const toml::TomlReader mount = document.table("mount", {"motion"});
    if (!mount.has("motion")) return MountMotion::fixed;
    return mount.choice<MountMotion>("motion", {{"fixed", MountMotion::fixed}, {"markers", MountMotion::markers}});
}

std::vector<ObstacleDeclaration> read_obstacles(const toml::TomlReader& document) {
    std::vector<ObstacleDeclaration> obstacles;
    for (const toml::TomlReader& table :
         document.tables("obstacle", {"kind", "point_m", "normal", "centre_m", "radius_m", "box_m", "friction"}))
        obstacles.push_back({read_shape(table), table.number_or("friction", 0.0, toml::not_negative())});
    return obstacles;
}

}  // namespace myo::experiment
