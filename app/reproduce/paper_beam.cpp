#include "reproduce/paper_beam.hpp"

#include <cassert>
#include <cmath>

#include "bench/beam_statics.hpp"
#include "bench/published_beam.hpp"
#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"

namespace myo::reproduce {
namespace {

const Box whole_beam{{-0.1, 0.0, 0.0}, {0.0, 0.03, 0.03}};

/// Mesh of the beam, nodes [m]: whole cubes from the tip on as published, or equal cells that fill it.
mesh::VolumeMesh mesh_of(const PaperBeam& beam) {
    if (beam.cube_edge_m > 0.0) {
        const Result<mesh::GridLines> grid = mesh::whole_cube_lines(whole_beam, beam.cube_edge_m, {true, false, false});
        assert(grid);
        return mesh::hex_mesh(*grid);
    }
    const mesh::CellType type = fem::cell_type(beam.element);
    return type == mesh::CellType::hex8 ? mesh::box_hex_mesh(whole_beam, beam.cells)
                                        : mesh::tet_box_mesh(whole_beam, beam.cells, type);
}

}  // namespace

model::Model make_paper_beam(const PaperBeam& beam) {
    mesh::VolumeMesh mesh = mesh_of(beam);
    // The clamped end is that of the mesh: whole cubes end before x = -0.1 m.
    Box clamp = mesh::bounding_box(mesh.nodes);
    clamp.highest(0) = clamp.lowest(0);
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, clamp);
    model::Model model;
    model.body = model::make_body(std::move(mesh), beam.element, clamped);
    model.material = material::find_material(beam.material);
    model.moduli = model::uniform_moduli(model.body->cell_count(), beam.youngs_modulus_Pa, 0.499);
    model.density_kg_m3 = 1070.0;
    model.damping_s = beam.damping_s;
    model.velocity_force_1_s = beam.velocity_force_1_s;
    model.mass_model = beam.mass_model;
    model.gravity_m_s2 = {0.0, 0.0, -bench::beam_gravity_m_s2};
    if (beam.tip_force_N != 0.0)
        model.forces.push_back(bench::force_on_upper_tip_edge(model.body->mesh, -beam.tip_force_N));
    return model;
}

PaperBeam published_hex_beam(int cells_along) {
    PaperBeam beam;
    beam.element = fem::ElementKind::hex8_full;
    // Edges that reproduce the published counts: 23 x 7 x 7 cubes of 4.26 mm, 32 x 9 x 9 of 3.04 mm.
    beam.cube_edge_m = 0.1 / (cells_along == 23 ? 23.5 : cells_along + 0.9);
    beam.mass_model = model::MassModel::equal_vertices;
    beam.material = "projective_corotational";
    return beam;
}

double published_vertex_mass_kg() { return 1070.0 * std::pow(published_hex_beam(23).cube_edge_m, 3); }

const std::array<Eigen::Vector3d, 3>& beam_surface_points() {
    static const std::array<Eigen::Vector3d, 3> points{
        {Eigen::Vector3d(0.0, 0.015, 0.03), Eigen::Vector3d(0.0, 0.0, 0.024), Eigen::Vector3d(0.0, 0.03, 0.006)}};
    return points;
}

std::array<mesh::BoundaryPoint, 3> bind_beam_points(const model::Model& model) {
    const mesh::VolumeMesh& mesh = model.body->mesh;
    const Box box = mesh::bounding_box(mesh.nodes);
    const mesh::BoundaryLocator locator(mesh, model.body->boundary);
    std::array<mesh::BoundaryPoint, 3> points;
    for (std::size_t i = 0; i < 3; ++i) {
        // Same relative position in a body that truncated voxels made smaller.
        const Eigen::Vector3d share = (beam_surface_points()[i] - whole_beam.lowest).cwiseQuotient(whole_beam.size());
        points[i] = mesh::closest_boundary_point(locator, box.lowest + share.cwiseProduct(box.size()));
    }
    return points;
}

Eigen::Matrix3d beam_point_displacements(const std::array<mesh::BoundaryPoint, 3>& points,
                                         const Eigen::Matrix3Xd& displacements) {
    Eigen::Matrix3d result;
    for (std::size_t i = 0; i < 3; ++i)
        result.col(static_cast<Eigen::Index>(i)) = displacements(Eigen::all, points[i].nodes) * points[i].weights;
    return result;
}

}  // namespace myo::reproduce
