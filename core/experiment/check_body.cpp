#include "experiment/check_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/clipping.hpp"
#include "mesh/face_shape.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/winding_number.hpp"

namespace myo::experiment {
namespace {

// Corners of a triangle as columns [m].
Eigen::Matrix3d corners(const mesh::SurfaceMesh& surface, Eigen::Index triangle) {
    Eigen::Matrix3d X;
    for (int i = 0; i < 3; ++i) X.col(i) = surface.vertices.col(surface.triangles(i, triangle));
    return X;
}

/// Overlap and distance queries between declared boxes or points and the closed surface of the body.
class BodyCheck {
public:
    // STL stores 32-bit floats: a face meant to lie at 0.1 m can be off by 6e-9 m. The tolerance is relative to the
    // extent.
    explicit BodyCheck(const mesh::SurfaceMesh& body)
        : body_(body), tolerance_(1e-7 * mesh::bounding_box(body.vertices).size().maxCoeff()) {}

    // If no triangle intersects the box, the box lies entirely inside or entirely outside the body; the generalised
    // winding number of its centre decides.
    bool holds_material(const Box& box) const {
        for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t)
            if (!part_in(box, t).empty()) return true;
        return mesh::winding_number(body_, 0.5 * (box.lowest + box.highest)) > 0.5;
    }

    // The box is shrunk by the tolerance on all sides, so a box that only touches the surface from outside has no
    // common volume with the body.
    bool holds_volume(Box box) const {
        box.lowest.array() += 2.0 * tolerance_;
        box.highest.array() -= 2.0 * tolerance_;
        return (box.size().array() > 0.0).all() && holds_material(box);
    }

    // The bounding box suffices: an axis-aligned box contains the body exactly if it contains all its vertices.
    bool lies_in(const Box& box) const {
        const Box bounds = mesh::bounding_box(body_.vertices);
        return (bounds.lowest.array() >= box.lowest.array() - tolerance_).all() &&
               (bounds.highest.array() <= box.highest.array() + tolerance_).all();
    }

    // Area of the surface clipped to the box, by a triangle fan per clipped polygon. The threshold rejects the sliver
    // of area that the tolerance alone can produce along an edge of the body.
    bool holds_surface(const Box& box) const {
        double area = 0.0;
        for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t) {
            const mesh::Polygon part = part_in(box, t);
            for (std::size_t i = 2; i < part.size(); ++i)
                area += 0.5 * (part[i - 1] - part[0]).cross(part[i] - part[0]).norm();
        }
        return area > 4.0 * tolerance_ * mesh::bounding_box(body_.vertices).size().maxCoeff();
    }

    // Exhaustive over the triangles: it runs once per marker, so a search tree would not pay.
    double distance_to_surface(const Eigen::Vector3d& point) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t) {
            const Eigen::Matrix3Xd X = corners(body_, t);
            nearest = std::min(nearest,
                               (X * mesh::face_shape(3, mesh::closest_face_parameters(X, point)) - point).norm());
        }
        return nearest;
    }

    double tolerance() const { return tolerance_; }

private:
    // Part of a triangle inside a box; empty if they do not meet.
    mesh::Polygon part_in(const Box& box, Eigen::Index triangle) const {
        const Eigen::Matrix3d X = corners(body_, triangle);
        return mesh::clip_to_box({X.col(0), X.col(1), X.col(2)}, box, tolerance_);
    }

    const mesh::SurfaceMesh& body_;
    double tolerance_;
};

// Key of an array entry in messages: "muscle[2]".
std::string element(const std::string& table, std::size_t index) { return table + "[" + std::to_string(index) + "]"; }

}  // namespace

Result<mesh::SurfaceMesh> read_body_surface(const Experiment& experiment) {
    if (const auto* box = std::get_if<BoxGeometry>(&experiment.geometry))
        return mesh::box_surface(Box{box->origin_m, box->origin_m + box->size_m});
    const auto& stl = std::get<StlGeometry>(experiment.geometry);
    Result<mesh::SurfaceMesh> raw = mesh::read_surface(stl.file, stl.metres_per_unit, stl.rotation);
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
    return body;
}

Error holds_whole_body(const Experiment& experiment) {
    return declaration_error(experiment, "clamp.box_m", "holds the whole body, nothing can move; its corners are in m");
}

Result<void> check_on_body(const Experiment& experiment, const mesh::SurfaceMesh& body) {
    const BodyCheck check(body);
    if (!check.holds_material(experiment.clamp_box_m))
        return declaration_error(experiment, "clamp.box_m", "the box contains no material of the body");
    // A clamp without free material is caught here, before any meshing, with the likely cause (a wrong unit).
    if (check.lies_in(experiment.clamp_box_m)) return holds_whole_body(experiment);
    for (std::size_t i = 0; i < experiment.muscles.size(); ++i) {
        const auto* box = std::get_if<MuscleBox>(&experiment.muscles[i].part);
        if (box != nullptr && !check.holds_volume(box->box_m))
            return declaration_error(experiment, element("muscle", i) + ".box_m",
                                     "the box contains no material of the body");
    }
    for (std::size_t i = 0; i < experiment.trials.size(); ++i)
        for (std::size_t j = 0; j < experiment.trials[i].loads.size(); ++j)
            if (!check.holds_surface(experiment.trials[i].loads[j].box_m))
                return declaration_error(experiment, element("trial", i) + "." + element("load", j) + ".box_m",
                                         "the box contains no surface of the body for the load to act on");
    // Fixed markers are not checked: they are attached to the surroundings.
    const double allowed = experiment.markers.max_standoff_m;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        // Markers are glued on: a small standoff is normal, a large one means a wrong unit, frame or rest position.
        const double distance = check.distance_to_surface(marker.rest_m);
        if (distance > allowed + check.tolerance())
            return declaration_error(experiment, "markers.rest_m." + marker.name,
                                     "the rest position is " + format_number(1e3 * distance, 4) +
                                         " mm off the surface, more than max_standoff_m (" +
                                         format_number(1e3 * allowed, 4) + " mm)");
    }
    return {};
}

}  // namespace myo::experiment
