#include "bench/beam_statics.hpp"

#include "dynamics/statics.hpp"
#include "mesh/region.hpp"

namespace myo::bench {

model::Model static_beam(const BenchBeam& beam, double poissons_ratio) {
    model::Model model = bench_beam(beam);
    model.gravity_m_s2(2) = -beam_gravity_m_s2;
    model.moduli = model::uniform_moduli(model.body->cell_count(), 263824.0, poissons_ratio);
    return model;
}

Result<Eigen::Matrix3Xd> beam_equilibrium(const model::Model& model) {
    dynamics::StageSolver solver(model);
    Eigen::Matrix3Xd x = model.body->mesh.nodes;
    const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, x);
    if (!report.ok()) return Error{report.message, ""};
    return x;
}

Eigen::Vector3d tip_displacement(const model::Model& model, const Eigen::Matrix3Xd& x) {
    Box edge = mesh::bounding_box(model.body->mesh.nodes);
    edge.lowest(0) = edge.highest(0);
    edge.highest(2) = edge.lowest(2);
    // Lower edge of the end face: highest x, lowest z.
    const std::vector<int> nodes = mesh::nodes_in_box(model.body->mesh, edge);
    return (x(Eigen::all, nodes) - model.body->mesh.nodes(Eigen::all, nodes)).rowwise().mean();
}

Result<double> measured_tip_dz_mm(const model::Model& model, BenchFigures& figures) {
    const double start = thread_time_s();
    const Result<Eigen::Matrix3Xd> x = beam_equilibrium(model);
    figures.run_s += thread_time_s() - start;
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    if (!x) return x.error();
    return 1e3 * tip_displacement(model, *x)(2);
}

}  // namespace myo::bench
