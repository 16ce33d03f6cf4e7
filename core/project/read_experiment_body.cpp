#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "project/read_experiment.hpp"
#include "project/read_experiment_tables.hpp"

namespace myo {
namespace {

// Coordinates typed in decimal may miss a face by rounding: 0.1 + 0.2 > 0.3.
constexpr double rounding_m = 1e-9;

[[noreturn]] void fail(const Experiment& experiment, const std::string& key, const std::string& sentence) {
    throw TomlFailure{declaration_error(experiment, key, sentence)};
}

// Edge lengths of the part of the body inside the box; negative where they are apart.
Eigen::Vector3d overlap(const Box& body, const Box& box) {
    return body.highest.cwiseMin(box.highest) - body.lowest.cwiseMax(box.lowest);
}

bool holds_material(const Box& body, const Box& box) { return overlap(body, box).minCoeff() >= -rounding_m; }

// Whether some face of the body has area inside the box.
bool holds_surface(const Box& body, const Box& box) {
    const Eigen::Vector3d common = overlap(body, box);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const bool has_area = common[(axis + 1) % 3] > rounding_m && common[(axis + 2) % 3] > rounding_m;
        for (const double face : {body.lowest[axis], body.highest[axis]})
            if (has_area && face >= box.lowest[axis] - rounding_m && face <= box.highest[axis] + rounding_m) return true;
    }
    return false;
}

double distance_to_surface(const Box& body, const Eigen::Vector3d& point) {
    const Eigen::Vector3d outside = (body.lowest - point).cwiseMax(point - body.highest);
    if (outside.maxCoeff() <= 0.0) return -outside.maxCoeff();   // inside: to the nearest face
    return outside.cwiseMax(0.0).norm();
}

}  // namespace

void check_against_box_body(const Experiment& experiment) {
    const auto& geometry = std::get<BoxGeometry>(experiment.geometry);
    const Box body{geometry.origin_m, geometry.origin_m + geometry.size_m};
    if (!holds_material(body, experiment.clamp_box_m)) fail(experiment, "clamp.box_m", "the box contains no material of the body");
    for (std::size_t i = 0; i < experiment.muscles.size(); ++i)
        if (overlap(body, experiment.muscles[i].box_m).minCoeff() <= rounding_m)
            fail(experiment, "muscle[" + std::to_string(i) + "].box_m", "the box contains no material of the body");
    for (std::size_t i = 0; i < experiment.trials.size(); ++i)
        for (std::size_t j = 0; j < experiment.trials[i].loads.size(); ++j)
            if (!holds_surface(body, experiment.trials[i].loads[j].box_m))
                fail(experiment, "trial[" + std::to_string(i) + "].load[" + std::to_string(j) + "].box_m",
                     "the box contains no surface of the body for the load to act on");
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        const double distance = distance_to_surface(body, marker.rest_m);
        if (distance > experiment.markers.max_standoff_m + rounding_m)
            fail(experiment, "markers.rest_m." + marker.name,
                 "the rest position is " + format_number(1e3 * distance, 4) + " mm off the surface, more than max_standoff_m (" +
                     format_number(1e3 * experiment.markers.max_standoff_m, 4) + " mm)");
    }
}

}  // namespace myo
