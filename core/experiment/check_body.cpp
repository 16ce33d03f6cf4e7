#include "experiment/check_body.hpp"

#include "base/text.hpp"
#include "experiment/body_queries.hpp"
#include "experiment/check_robot_parts.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/boundary_surface.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_parts.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/volume_reader.hpp"
#include "toml/toml_path.hpp"

namespace myo::experiment {
namespace {

/// Boundary of the declared volume mesh, scaled and turned to the mesh frame [m].
Result<mesh::SurfaceMesh> read_volume_surface(const Experiment& experiment, const VolumeGeometry& declared) {
    Result<mesh::VolumeMesh> cells = mesh::read_volume(declared.file, declared.metres_per_unit);
    if (!cells) return Error{"geometry.file: " + cells.error().what, cells.error().where};
    cells->nodes = declared.rotation * cells->nodes;
    mesh::SurfaceMesh body = mesh::boundary_surface(*cells);
    if (const Result<void> size = mesh::check_plausible_size(mesh::bounding_box(body.vertices).size()); !size)
        return declaration_error(experiment, "geometry.unit", size.error().what);
    return body;
}

}  // namespace

Result<mesh::SurfaceMesh> read_body_surface(const Experiment& experiment, std::vector<std::string>* warnings) {
    if (const auto* box = std::get_if<BoxGeometry>(&experiment.geometry))
        return mesh::box_surface(Box{box->origin_m, box->origin_m + box->size_m});
    if (const auto* volume = std::get_if<VolumeGeometry>(&experiment.geometry))
        return read_volume_surface(experiment, *volume);
    const auto& stl = std::get<StlGeometry>(experiment.geometry);
    Result<mesh::SurfaceMesh> raw = mesh::read_surface(stl.file, stl.metres_per_unit, stl.rotation, warnings);
    if (!raw) return Error{"geometry.file: " + raw.error().what, raw.error().where};
    if (const Result<void> size = mesh::check_plausible_size(mesh::bounding_box(raw->vertices).size()); !size)
        return declaration_error(experiment, "geometry.unit", size.error().what);
    // STL repeats the vertices of each triangle; closedness and orientation need shared ones.
    mesh::SurfaceMesh body = mesh::weld(*raw);
    const mesh::SurfaceReport report = mesh::check_surface(body);
    const std::string file = stl.file.filename().string();
    if (!report.closed)
        return declaration_error(experiment, "geometry.file",
                                 file + " is not closed: " + std::to_string(report.open_edges) + " open edges");
    // "Outward" is only defined for a consistently oriented surface.
    if (report.oriented && !report.outward)
        return declaration_error(experiment, "geometry.file",
                                 file + " is turned inside out; its triangles must face outward");
    Result<mesh::FacingParts> parts = mesh::facing_parts(body);
    if (!parts) return declaration_error(experiment, "geometry.file", file + ": " + parts.error().what);
    if (warnings != nullptr)
        for (const std::string& note : parts->notes) warnings->push_back(file + ": " + note);
    return std::move(parts->surface);
}

Error holds_whole_body(const Experiment& experiment, const std::string& key) {
    return declaration_error(experiment, key, "holds the whole body, nothing can move; its corners are in m");
}

Result<void> check_on_body(const Experiment& experiment, const mesh::SurfaceMesh& body) {
    // What holds the body comes first: a wrong unit or frame shows there. Muscles, other parts, loads and markers
    // follow.
    const BodyQueries check(body);
    if (has_clamp(experiment) && !check.holds_material(experiment.clamp_box_m))
        return declaration_error(experiment, "clamp.box_m", "the box contains no material of the body");
    // A clamp without free material is caught here, before any meshing, with the likely cause (a wrong unit).
    if (has_clamp(experiment) && check.lies_in(experiment.clamp_box_m))
        return holds_whole_body(experiment, "clamp.box_m");
    for (std::size_t i = 0; i < experiment.supports.size(); ++i) {
        const SupportDeclaration& support = experiment.supports[i];
        // A box without depth has no area; it is grown beyond the tolerance within which clipping drops slivers.
        const Box grown{support.box_m.lowest.array() - 2.0 * check.tolerance(),
                        support.box_m.highest.array() + 2.0 * check.tolerance()};
        const std::string key = toml::element_text("support", i) + ".box_m";
        if (!check.holds_material(grown))
            return declaration_error(experiment, key, "the box contains no material of the body");
        if (support.clamps() && check.lies_in(support.box_m)) return holds_whole_body(experiment, key);
    }
    for (std::size_t i = 0; i < experiment.muscles.size(); ++i) {
        const auto* box = std::get_if<MuscleBox>(&experiment.muscles[i].part);
        // A muscle needs volume to contract; a box that touches a face from outside has none.
        if (box != nullptr && !check.holds_volume(box->box_m))
            return declaration_error(experiment, toml::element_text("muscle", i) + ".box_m",
                                     "the box contains no material of the body");
    }
    if (Result<void> parts = check_robot_parts_on_body(experiment, check); !parts) return parts;
    for (std::size_t i = 0; i < experiment.trials.size(); ++i)
        for (std::size_t j = 0; j < experiment.trials[i].loads.size(); ++j)
            if (!check.holds_surface(experiment.trials[i].loads[j].box_m))
                return declaration_error(
                    experiment, toml::element_text("trial", i) + "." + toml::element_text("load", j) + ".box_m",
                    "the box contains no surface of the body for the load to act on");
    // Fixed markers are not checked: they are attached to the surroundings.
    const double allowed = experiment.markers.max_standoff_m;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        // Markers are glued on: a small standoff is normal, a large one means a wrong unit, frame or rest position.
        const double distance = check.distance_to_surface(marker.rest_m);
        if (distance > allowed + check.tolerance())
            return declaration_error(experiment, (marker.probe ? "markers.probe_m." : "markers.rest_m.") + marker.name,
                                     "the rest position is " + format_number(1e3 * distance, 4) +
                                         " mm off the surface, more than max_standoff_m (" +
                                         format_number(1e3 * allowed, 4) + " mm)");
    }
    return {};
}

}  // namespace myo::experiment
