#include "commands/picked_place.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

#include "commands/muscle_signal.hpp"
#include "commands/scene_at_time.hpp"
#include "viewport/picking.hpp"

namespace myo::ui::commands {
namespace {

using Eigen::Vector3d;

/// A number by a format of printf.
std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Three numbers, each in this format: "1.00, 2.00, 3.00".
std::string triple(const char* format, const Vector3d& v) {
    return number(format, v.x()) + ", " + number(format, v.y()) + ", " + number(format, v.z());
}

/// Position in millimetres, or "not seen" for an occluded marker.
std::string in_mm(const Vector3d& place_m) {
    return place_m.allFinite() ? triple("%.2f", 1e3 * place_m) + " mm" : "not seen";
}

/// Appends the muscles that act in a cell, with their weight, fibre direction and activation.
void add_muscles_of_cell(std::vector<ReportLine>& lines, int cell, const WorkbenchState& state) {
    for (std::size_t m = 0; m < state.paint.size() && m < state.settings.muscles.size(); ++m) {
        if (!state.paint[m] || cell >= state.paint[m]->count() || !(state.paint[m]->weights(cell) > 0.0)) continue;
        const Muscle& muscle = state.settings.muscles[m];
        lines.push_back({muscle.name, number("%.0f %% of the element", 100.0 * state.paint[m]->weights(cell))});
        lines.push_back({"Fibres at rest", triple("%.2f", state.paint[m]->directions.col(cell))});
        lines.push_back({"Activation a", number("%.3f", signal_of(state, muscle).value(state.time_s))});
    }
}

/// Lines about a place on the body: its nearest node, now and at rest, the field there, its cell and muscles.
std::vector<ReportLine> lines_about_body(const PickedPlace& place, const WorkbenchState& state,
                                         const viewport::DrawnScene& scene) {
    const Vector3d rest = state.body->mesh.nodes.col(place.node), now = scene.positions.col(place.node);
    std::vector<ReportLine> lines{{"Node", std::to_string(place.node)},
                                  {"At rest", in_mm(rest)},
                                  {"Now", in_mm(now)},
                                  {"Displacement", number("%.3f mm", 1e3 * (now - rest).norm())}};
    // The field may still belong to another mesh for a frame.
    if (scene.field && place.node < scene.field->values.size())
        lines.push_back({scene.field->name, number("%.4g ", scene.field->values[place.node]) + scene.field->unit});
    lines.push_back({"Element", std::to_string(place.cell) + ", " + to_string(state.body->mesh.type)});
    if (state.ground)
        lines.push_back({"Volume", number("%.3g mm\xc2\xb3", 1e9 * state.ground->volumes_m3(place.cell))});
    add_muscles_of_cell(lines, place.cell, state);
    return lines;
}

/// Lines about a marker: at rest, measured, simulated, and the errors. `error`: null: unknown.
std::vector<ReportLine> lines_about_marker(int marker, const WorkbenchState& state, const MarkerError* error) {
    const auto m = static_cast<std::size_t>(marker);
    std::vector<ReportLine> lines{{"Marker", state.scene->markers[m].name},
                                  {"At rest", in_mm(state.scene->markers[m].rest_m)}};
    const SceneTrial* const trial = state.scene_trial();
    if (!trial || trial->time_s.size() == 0) return lines;
    // Measured and simulated markers have the same sample times; a run of another version of the experiment does not.
    const TimePlace when = place_in_time(trial->time_s, state.time_s);
    const Vector3d measured = at_time(trial->measured[m], when);
    if (is_seen(*trial, m)) lines.push_back({"Measured", in_mm(measured)});
    const SimulatedTrial* const simulated = state.simulated_trial();
    if (!simulated || m >= simulated->markers.size() || simulated->markers[m].cols() != trial->time_s.size())
        return lines;
    const Vector3d predicted = at_time(simulated->markers[m], when);
    lines.push_back({"Simulated", in_mm(predicted)});
    if (measured.allFinite()) lines.push_back({"Error now", number("%.3f mm", 1e3 * (predicted - measured).norm())});
    if (error && std::isfinite(error->rms_m)) lines.push_back({"Error, rms", number("%.3f mm", 1e3 * error->rms_m)});
    return lines;
}

/// The marker nearest to the pixel, within reach [pixels]. `hit`: where the ray through the pixel meets the body.
std::optional<PickedPlace> marker_at(const viewport::DrawnScene& scene, const viewport::Camera& camera,
                                     const viewport::ViewSize& size, const Eigen::Vector2d& pixel, double reach,
                                     const std::optional<viewport::SurfaceHit>& hit) {
    const viewport::Ray ray = viewport::ray_through(camera, size, pixel);
    std::optional<PickedPlace> picked;
    double nearest = reach;
    for (const viewport::DrawnMarker& marker : scene.markers) {
        if (marker.number < 0 || !marker.position.allFinite()) continue;
        const auto seen = viewport::project(camera, size, marker.position);
        if (!seen || (seen->head<2>() - pixel).norm() > nearest) continue;
        // Markers take precedence over the body, unless the body hides them.
        const double depth = ray.direction.dot(marker.position - ray.origin_m);
        if (hit && depth > hit->distance_m + 2.0 * scene.marker_radius) continue;
        nearest = (seen->head<2>() - pixel).norm();
        picked = PickedPlace{marker.number, marker.ring, {-1, -1, -1}, Vector3d::Zero(), -1, -1};
    }
    return picked;
}

/// A place on the body, by the nodes of its triangle.
PickedPlace place_on_body(const viewport::DrawnScene& scene, const viewport::SurfaceHit& hit) {
    PickedPlace place;
    for (std::size_t k = 0; k < 3; ++k)
        place.corners[k] = scene.surface->corners[3 * static_cast<std::size_t>(hit.triangle) + k];
    place.weights = hit.weights;
    const int face = hit.triangle / scene.surface->triangles_per_face();
    place.cell = scene.body->faces.cell(face);
    const Vector3d at = hit.place(*scene.surface, scene.positions);
    // The nearest node of the face, for the values of node fields.
    double closest = std::numeric_limits<double>::infinity();
    for (const int node : scene.body->faces.nodes.col(face)) {
        const double squared_distance = (scene.positions.col(node) - at).squaredNorm();
        if (squared_distance < closest) closest = squared_distance, place.node = node;
    }
    return place;
}

}  // namespace

std::optional<std::size_t> pick_one(const std::vector<Vector3d>& places_m, const viewport::DrawnScene& scene,
                                    const viewport::Camera& camera, const viewport::ViewSize& size,
                                    const Eigen::Vector2d& pixel, double reach) {
    const viewport::Ray ray = viewport::ray_through(camera, size, pixel);
    // Where the ray meets the body: places clearly behind are hidden by it.
    const auto hit = scene.surface ? viewport::pick_surface(*scene.surface, scene.positions, ray) : std::nullopt;
    std::optional<std::size_t> seen, hidden;
    double nearest_seen = reach, nearest_hidden = reach;
    for (std::size_t i = 0; i < places_m.size(); ++i) {
        const auto at = viewport::project(camera, size, places_m[i]);
        if (!at) continue;
        const double distance = (at->head<2>() - pixel).norm();
        // A marker's sphere reaches out of the body, so it counts as hidden only if its centre lies clearly behind the
        // hit.
        const bool behind = hit &&
                            ray.direction.dot(places_m[i] - ray.origin_m) > hit->distance_m + 2.0 * scene.marker_radius;
        double& nearest = behind ? nearest_hidden : nearest_seen;
        if (distance > nearest) continue;
        nearest = distance;
        (behind ? hidden : seen) = i;
    }
    return seen ? seen : hidden;
}

std::optional<viewport::SurfaceHit> hit_on_body(const WorkbenchState& state, const viewport::DrawnScene& scene,
                                                const viewport::Camera& camera, const viewport::ViewSize& size,
                                                const Eigen::Vector2d& pixel) {
    if (!state.body || !scene.body || !scene.surface || scene.positions.cols() != state.body->mesh.node_count())
        return std::nullopt;
    return viewport::pick_surface(*scene.surface, scene.positions, viewport::ray_through(camera, size, pixel));
}

std::optional<PickedPlace> pick_place(const WorkbenchState& state, const viewport::DrawnScene& scene,
                                      const viewport::Camera& camera, const viewport::ViewSize& size,
                                      const Eigen::Vector2d& pixel, double reach) {
    const std::optional<viewport::SurfaceHit> hit = hit_on_body(state, scene, camera, size, pixel);
    const std::optional<PickedPlace> picked = marker_at(scene, camera, size, pixel, reach, hit);
    // A place on the body is stored by the nodes of its triangle, so that it moves with them.
    if (picked || !hit) return picked;
    return place_on_body(scene, *hit);
}

Vector3d place_now(const PickedPlace& place, const viewport::DrawnScene& scene) {
    if (place.marker < 0) {
        Vector3d sum = Vector3d::Zero();
        for (int k = 0; k < 3; ++k)
            sum += place.weights[k] * scene.positions.col(place.corners[static_cast<std::size_t>(k)]);
        return sum;
    }
    for (const viewport::DrawnMarker& marker : scene.markers)
        if (marker.number == place.marker && marker.ring == place.simulated) return marker.position;
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

Vector3d place_at_rest(const PickedPlace& place, const WorkbenchState& state) {
    if (place.marker >= 0) return state.scene->markers[static_cast<std::size_t>(place.marker)].rest_m;
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        sum += place.weights[k] * state.body->mesh.nodes.col(place.corners[static_cast<std::size_t>(k)]);
    return sum;
}

std::vector<ReportLine> lines_about(const PickedPlace& place, const WorkbenchState& state,
                                    const viewport::DrawnScene& scene, const MarkerError* error) {
    return place.marker >= 0 ? lines_about_marker(place.marker, state, error) : lines_about_body(place, state, scene);
}

}  // namespace myo::ui::commands
