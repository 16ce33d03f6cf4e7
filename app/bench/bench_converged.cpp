#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "bench/beam_statics.hpp"
#include "bench/bench_cases.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"

namespace myo::bench {
namespace {

/// The soft beam with cells graded towards the clamp and the edges. The stress is singular along the edge of the clamp,
/// so uniform meshes converge with h^1.2 only at nu = 0.5; graded ones keep second order, and the limit can be
/// extrapolated. Tetrahedra use half the grading along the beam, as flat ones lose what it gains.
model::Model graded_beam(fem::ElementKind element, int n, double poissons_ratio) {
    const Box box{Eigen::Vector3d::Zero(), Eigen::Vector3d(0.1, 0.03, 0.03)};
    const Eigen::Vector3i cells(4 * n, 2 * n, 2 * n);
    const bool hexahedra = fem::cell_type(element) == mesh::CellType::hex8;
    mesh::VolumeMesh mesh = hexahedra ? mesh::box_hex_mesh(box, cells)
                                      : mesh::tet_box_mesh(box, cells, mesh::CellType::tet4);
    // Along the beam towards the clamp; across it towards both sides, where stresses are singular at the clamp's edges.
    const double grading = hexahedra ? 1.0 : 0.5;
    for (auto X : mesh.nodes.colwise()) {
        const Eigen::Vector3d s = X.cwiseQuotient(box.size());
        X(0) *= 1.0 - grading + grading * s(0);
        for (int a = 1; a < 3; ++a) X(a) = 0.5 * box.size()(a) * (1.0 - std::cos(std::numbers::pi * s(a)));
    }
    if (!hexahedra) mesh = mesh::to_tet10(mesh);
    Box clamp = box;
    clamp.highest(0) = 0.0;
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, clamp);
    model::Model model = static_beam({element, {1, 1, 1}}, poissons_ratio);
    model.body = model::make_body(std::move(mesh), element, clamped);
    model.moduli.resize(static_cast<std::size_t>(model.body->cell_count()), model.moduli.front());
    return model;
}

/// Richardson limit of d(h) = d + c h^p from three meshes with halved edges. Reported only if the observed p is close
/// to 2, as for smooth solutions: that of hex8 is; tet10 is not yet asymptotic on its first mesh and serves as a check
/// by its last one.
Result<BenchFigures> extrapolated(fem::ElementKind element, const ConvergedBeam& known) {
    const int first = fem::cell_type(element) == mesh::CellType::tet10
                          ? 1
                          : 2;  // mid-nodes count: the same numbers of nodes for both
    BenchFigures figures;
    std::array<double, 3> dz{};
    for (std::size_t level = 0; level < 3; ++level) {
        const Result<double> one = measured_tip_dz_mm(graded_beam(element, first << level, known.poissons_ratio),
                                                      figures);
        if (!one) return one.error();
        dz[level] = *one;
        figures.quantities.push_back(
            {"tip under gravity, " + std::to_string(figures.dofs) + " DOF", *one, "mm", known.dz_mm});
    }
    // d(h) - d(h/2) falls by 2^p per halving.
    const double ratio = (dz[1] - dz[0]) / (dz[2] - dz[1]), order = ratio > 0.0 ? std::log2(ratio) : 0.0;
    if (order > 1.75) {
        figures.quantities.push_back({"order", order, "", {}});
        figures.quantities.push_back({"limit", dz[2] + (dz[2] - dz[1]) / (ratio - 1.0), "mm", known.dz_mm});
    }
    figures.name = to_string(element) + ", nu " + format_number(known.poissons_ratio);
    return figures;
}

}  // namespace

BenchCase bench_converged() {
    BenchCase result{"converged",
                     "where the deflections of the case locking converge to: graded meshes and Richardson "
                     "extrapolation with two elements",
                     {}};
    for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10})
        for (const ConvergedBeam& known : converged_beam)
            result.runs.push_back({to_string(element) + ", nu " + format_number(known.poissons_ratio),
                                   [element, known] { return extrapolated(element, known); }});
    return result;
}

}  // namespace myo::bench
