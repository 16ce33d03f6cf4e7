#include <array>
#include <numbers>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "bench/held_bar.hpp"
#include "setup/body_mesh.hpp"

namespace myo::bench {
namespace {

/// Small enough for a linear response, and equal in the reference: such soft bodies sag by their length under g.
constexpr double small_gravity_m_s2 = 0.1;

/// A box clamped at x = 0 as a linear elastic solid: E and density of the paper's beam, nu = 0.49.
struct SolvedBox {
    std::string name;
    BarShape shape;
    double sag_mm = 0.0;        // mean of the free end under small_gravity_m_s2
    double first_Hz = 0.0;      // bending along z
    double torsion_N_mm = 0.0;  // torque over mean rotation of the free end, see unit_torque()
};

/// Source: an independent program, hexahedra of 27 nodes with discontinuous linear pressures (Bathe 2014, sec. 4.4.3)
/// on meshes graded towards edges and support, at most 114, 104, 154 and 138 thousand unknowns; extrapolated from the
/// last three meshes, which changes the values by less than 0.2 %.
const std::array<SolvedBox, 4> solved_boxes{{
    {"bar 100 x 30 x 30 mm", {0.1, 0.03, 0.03}, 0.069782, 7.3289, 100.68},
    {"column 100 x 5 x 5 mm", {0.1, 0.005, 0.005}, 2.4097, 1.27363, 0.077801},
    {"strip 100 x 20 x 4 mm", {0.1, 0.02, 0.004}, 3.6071, 1.04168, 0.34091},
    {"plate 100 x 50 x 5 mm", {0.1, 0.05, 0.005}, 2.14766, 1.35116, 1.9307},
}};

/// Errors that MeshPolicy aims at.
constexpr double bending_goal = 0.02, twist_goal = 0.06;

/// Meshes a box as the program would without a resolution, and compares it with the reference.
Result<BenchFigures> measure_default_mesh(const SolvedBox& box, fem::ElementKind element) {
    const double start = thread_time_s();
    const BarShape& shape = box.shape;
    const Box body{Eigen::Vector3d::Zero(), {shape.length_m, shape.width_m, shape.height_m}};
    // No resolution: that of the program is tested.
    setup::MeshRequest request;
    request.element = element;
    Result<setup::BodyMesh> mesh = setup::mesh_body(mesh::box_surface(body), request, {});
    if (!mesh) return mesh.error();
    const model::Model model = held_bar(shape, mesh->element, std::move(mesh->mesh));
    const Eigen::VectorXd tip = free_end_share(*model.body);
    const Eigen::Matrix3Xd torque = unit_torque(*model.body);
    SmallMotions motions(model);
    // All quantities follow from linear solves about the rest shape, with one factorisation per mesh.
    const double sag = -small_gravity_m_s2 * (motions.under(motions.weight_N()) * tip).z();
    // Mean rotation of the free end under 1 N m [rad].
    const double twist = torque.cwiseProduct(motions.under(torque)).sum();
    const double first_Hz = motions.first_bending().omega_rad_s / (2.0 * std::numbers::pi);
    BenchFigures figures;
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.name = box.name + ", " + to_string(mesh->element) + ", " + std::to_string(figures.dofs) + " DOF";
    figures.quantities = {{"sag under 0.1 m/s2", 1e3 * sag, "mm", box.sag_mm, bending_goal},
                          {"first frequency", first_Hz, "Hz", box.first_Hz, bending_goal},
                          {"torsion stiffness", 1e3 / twist, "N mm", box.torsion_N_mm, twist_goal}};
    figures.run_s = thread_time_s() - start;
    return figures;
}

}  // namespace

BenchCase bench_default_meshes() {
    BenchCase result{"default-meshes",
                     "bodies held at one end, with the cells that the program chooses, against an independent program",
                     {}};
    for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10})
        for (const SolvedBox& box : solved_boxes)
            result.runs.push_back(
                {box.name + ", " + to_string(element), [box, element] { return measure_default_mesh(box, element); }});
    return result;
}

}  // namespace myo::bench
