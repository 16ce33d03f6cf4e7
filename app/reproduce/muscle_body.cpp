#include "reproduce/muscle_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "material/catalogue.hpp"
#include "mesh/cell_hex8.hpp"
#include "mesh/region.hpp"

#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Vector3d;

// Value of the published scripts.
constexpr double muscle_stiffness_Pa = 2e5;

/// Binding of a material point, the mean of several points on or inside a mesh of axis-aligned hexahedra. Markers bind
/// to the surface; this point may lie inside, so trilinear shape functions are used.
measurement::MarkerBinding tracked_point(const mesh::VolumeMesh& mesh, const std::vector<Vector3d>& points) {
    std::map<int, double> share;
    for (const Vector3d& point : points) {
        // Cell with the smallest distance to the point; 0 for the cell that holds it.
        double nearest = std::numeric_limits<double>::infinity();
        Eigen::Index cell = 0;
        Vector3d best = Vector3d::Zero();  // reference coordinates, -1 ... 1
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
            const Box box = mesh::bounding_box(mesh.nodes(Eigen::all, mesh.cells.col(c)));
            const Vector3d inside = point.cwiseMax(box.lowest).cwiseMin(box.highest);
            if (const double squared_distance = (point - inside).squaredNorm(); squared_distance < nearest) {
                nearest = squared_distance;
                cell = c;
                best = 2.0 * (inside - box.lowest).cwiseQuotient(box.size()) - Vector3d::Ones();
            }
        }
        const auto weights = mesh::Hex8::values(best);
        for (Eigen::Index a = 0; a < mesh.cells.rows(); ++a)
            share[mesh.cells(a, cell)] += weights(a) / static_cast<double>(points.size());
    }
    measurement::MarkerBinding binding;
    binding.weights.resize(static_cast<Eigen::Index>(share.size()));
    // The offset of the binding is zero, so its gradient, which turns the offset, is not needed.
    binding.gradient.setZero(binding.weights.size(), 3);
    for (const auto& [node, weight] : share) {
        binding.weights(static_cast<Eigen::Index>(binding.nodes.size())) = weight;
        binding.nodes.push_back(node);
    }
    return binding;
}

/// Tracked point first, then the markers on the surface; positions at rest [m].
measurement::MarkerSet observed_points(const mesh::VolumeMesh& mesh, const std::vector<Vector3d>& tracked,
                                       const std::vector<Vector3d>& markers) {
    measurement::MarkerSet set = measurement::marker_set(mesh, markers);
    set.bindings.insert(set.bindings.begin(), tracked_point(mesh, tracked));
    set.nodes.insert(set.nodes.end(), set.bindings.front().nodes.begin(), set.bindings.front().nodes.end());
    std::sort(set.nodes.begin(), set.nodes.end());
    set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
    // `positions` gives the place of each binding's nodes in the common list, which has changed.
    set.positions.clear();
    for (const measurement::MarkerBinding& binding : set.bindings) {
        set.positions.emplace_back();
        for (const int node : binding.nodes)
            set.positions.back().push_back(
                static_cast<int>(std::lower_bound(set.nodes.begin(), set.nodes.end(), node) - set.nodes.begin()));
    }
    return set;
}

/// Columns of cubes of this edge [m], counted from the lowest side of the body, whose centres lie in the box: the
/// published program selected whole cells.
Box whole_columns(const Box& box, const Box& body, const Box& mesh, double edge) {
    Box columns = mesh;
    const double low = box.lowest(0) - body.lowest(0), high = box.highest(0) - body.lowest(0);
    if (low > edge) columns.lowest(0) = mesh.lowest(0) + edge * std::ceil(low / edge - 0.5);
    if (high < mesh.size()(0)) columns.highest(0) = mesh.lowest(0) + edge * std::floor(high / edge + 0.5);
    columns.highest(2) = std::min(mesh.highest(2), mesh.lowest(2) + edge * std::round(box.highest(2) / edge));
    return columns;
}

}  // namespace

const MuscleRobot& paper_arm() {
    static const MuscleRobot arm{
        "arm",
        "Cylinder_Hex_Hole.stl",
        {{-0.03, -0.03, 0.0995}, {0.03, 0.03, 0.1005}},
        {{0.0138, -0.023, 0.0}, {0.0223, 0.023, 0.1}},
        {{-0.0223, -0.023, 0.0}, {-0.0142, 0.023, 0.1}},
        // A hair above 3.571 mm, of which 28 would fit: the published grid has 27 along the arm.
        3.5715e-3,
        -9.81,
        {{-0.0222, 0.0, 0.0}, {0.0222, 0.0, 0.0}, {0.0, -0.0222, 0.0}, {0.0, 0.0222, 0.0}},
        {{-0.009645, -0.0265, 0.0}, {-0.009645, 0.0265, 0.0}, {-0.0282, 0.0, 0.0}},
        -1.0};
    return arm;
}

const MuscleRobot& paper_fish() {
    static const MuscleRobot fish{"fish",
                                  "soft_fish.stl",
                                  {{-0.1, -0.1, -0.0005}, {0.1, 0.1, 0.0005}},
                                  {{-0.0155, -0.03, 0.0}, {-0.007, 0.03, 0.06}},
                                  {{0.005, -0.03, 0.0}, {0.0155, 0.03, 0.06}},
                                  2.857e-3,
                                  -9.81,
                                  {{0.0, -0.01419, 0.05221}},
                                  {},
                                  1.0};
    return fish;
}

std::filesystem::path geometry_file(const ReproduceSettings& settings, const MuscleRobot& robot) {
    return settings.data / "data/geometry" / robot.geometry;
}

Result<MuscleBody> make_muscle_body(const ReproduceSettings& settings, const MuscleRobot& robot,
                                    const MuscleBodyOptions& options) {
    const Result<mesh::SurfaceMesh> read = mesh::read_surface(geometry_file(settings, robot), 1e-3);
    if (!read) return read.error();
    // Files of the repository are STL, without shared vertices, in mm.
    const mesh::SurfaceMesh surface = mesh::weld(*read);
    const double edge = options.edge_m > 0.0 ? options.edge_m : robot.published_edge_m;
    Result<setup::BodyMesh> meshed = setup::mesh_body(
        surface,
        {options.published ? fem::ElementKind::hex8_full : fem::ElementKind::hex8, edge,
         options.published ? setup::Voxels::truncated : setup::Voxels::fitted},
        {robot.clamp});
    if (!meshed) return meshed.error();
    const Box body = mesh::bounding_box(surface.vertices), bounds = mesh::bounding_box(meshed->mesh.nodes);
    MuscleBody result;
    model::Model& model = result.model;
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const Box& muscle : {robot.first, robot.second}) {
        // With one muscle the first box counts.
        if (static_cast<int>(fibres->size()) == options.muscles) break;
        const Box box = options.published ? whole_columns(muscle, body, bounds, edge) : muscle;
        fibres->push_back(fibre::fibres_in_box(meshed->mesh, box, Vector3d::UnitZ(), muscle_stiffness_Pa,
                                               "muscle " + std::to_string(fibres->size() + 1)));
        model.activation.push_back(fibre::Signal::constant(1.0));
        if (fibres->back().points.empty())
            return Error{fibres->back().name + " has no cells of the mesh; choose a finer one", robot.id};
    }
    model.fibres = std::move(fibres);
    std::vector<Vector3d> points;
    for (const Vector3d& point : robot.tracked) {
        // Truncated voxels shrink the body; the tracked point keeps its relative position.
        const Vector3d share = (point - body.lowest).cwiseQuotient(body.size());
        points.push_back(options.published ? Vector3d(bounds.lowest + share.cwiseProduct(bounds.size())) : point);
    }
    result.points = observed_points(meshed->mesh, points, robot.markers);
    const std::vector<int> clamped = mesh::nodes_in_box(
        meshed->mesh, setup::box_on_mesh(*meshed, setup::held_part(robot.clamp, body)));
    model.body = model::make_body(std::move(meshed->mesh), meshed->element, clamped);
    model.material = material::find_material(options.published ? "projective_corotational" : "neo_hookean");
    model.moduli = model::uniform_moduli(model.body->cell_count(), options.youngs_modulus_Pa, 0.499);
    model.density_kg_m3 = 1070.0;
    // Mass, integration and energy of the published program, see the case beam-static for what each of them changes.
    model.mass_model = options.published ? model::MassModel::equal_vertices : model::MassModel::consistent;
    model.damping_s = options.damping_s;
    model.gravity_m_s2 = Vector3d(0.0, 0.0, robot.gravity_m_s2);
    return result;
}

std::string missing_geometry(const ReproduceSettings& settings, const MuscleRobot& robot) {
    return "the body is not there: fetch " + robot.geometry +
           " of the public repository srl-ethz/diffPD_sim2real and put it at " +
           geometry_file(settings, robot).string() +
           ", or name the folder above data/geometry in MYOLOOP_DATA; without it nothing is simulated";
}

}  // namespace myo::reproduce
