#include "bench/arm_model.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "bench/kept_cells.hpp"
#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"

namespace myo::bench {
namespace {

// Edge length [m] and numbers of cells of the published arm.
constexpr double edge_m = 3.571e-3;
constexpr int across = 12, along = 27;

}  // namespace

model::Model arm_model() {
    const Eigen::Vector3d size(across * edge_m, across * edge_m, along * edge_m);
    mesh::VolumeMesh mesh = kept_cells(
        mesh::box_hex_mesh({Eigen::Vector3d::Zero(), size}, {across, across, along}),
        [&](const Eigen::Vector3d& middle) {
            // Voxelised annulus: outer radius 6 cells, inner radius 2.4 cells.
            const double radius = std::hypot(middle(0) - 0.5 * size(0), middle(1) - 0.5 * size(1)) / edge_m;
            return radius < 6.0 && radius > 2.4;
        });
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1e-6);
    model::Model model;
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    const Eigen::Vector3d upwards = Eigen::Vector3d::UnitZ();
    fibres->push_back(
        fibre::fibres_in_box(mesh, {Eigen::Vector3d(10 * edge_m, 0.0, 0.0), size}, upwards, 2e5, "muscle 1"));
    fibres->push_back(fibre::fibres_in_box(
        mesh, {Eigen::Vector3d::Zero(), Eigen::Vector3d(2 * edge_m, size(1), size(2))}, upwards, 2e5, "muscle 2"));
    // Staircase of the two activations; the antagonist contracts by half of what the first muscle lengthens.
    fibre::Signal first{{}, {}}, second{{}, {}};
    for (int k = 0; k <= 4; ++k)
        // Two rows per time make a jump: the levels are piecewise constant.
        for (const int level : {k - 1, k}) {
            if (level < 0) continue;
            first.times_s.push_back(0.05 * k);
            second.times_s.push_back(0.05 * k);
            first.values.push_back(1.0 + level);
            second.values.push_back(1.0 - 0.5 * level);
        }
    model.fibres = std::move(fibres);
    model.activation = {first, second};
    const std::vector<int> clamped = mesh::nodes_in_box(mesh,
                                                        {Eigen::Vector3d(0.0, 0.0, size(2)) - margin, size + margin});
    model.body = model::make_body(std::move(mesh), fem::ElementKind::hex8_full, clamped);
    model.material = material::find_material("projective_corotational");
    model.moduli = model::uniform_moduli(model.body->cell_count(), 263824.0, 0.499);
    model.density_kg_m3 = 1070.0;
    model.gravity_m_s2 = Eigen::Vector3d(0.0, 0.0, -9.81);
    return model;
}

}  // namespace myo::bench
