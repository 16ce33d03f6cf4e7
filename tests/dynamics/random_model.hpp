#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "dynamics/simulate.hpp"
#include "material/catalogue.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "support/deformations.hpp"
#include "support/meshes.hpp"

namespace myo::test {

/// Draws of one case. Uniform where not said.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    double between(double low, double high) { return low + (high - low) * unit_(engine_); }
    double decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    bool chance(double probability) { return unit_(engine_) < probability; }
    Eigen::Vector3d direction() { return noise(1, 1.0).col(0).normalized(); }
    Eigen::Matrix3Xd noise(Eigen::Index columns, double deviation) {
        return Eigen::Matrix3Xd::NullaryExpr(3, columns, [&]() { return deviation * normal_(engine_); });
    }
    template <class T>
    const T& of(const std::vector<T>& list) {
        return list[static_cast<std::size_t>(count(0, static_cast<int>(list.size()) - 1))];
    }
    std::mt19937& engine() { return engine_; }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
    std::normal_distribution<double> normal_;
};

/// A random heap of cells of a grid, grown from one at the low x end over whole faces.
inline mesh::VolumeMesh voxel_heap(Dice& dice, const Eigen::Vector3i& cells) {
    const mesh::VolumeMesh grid = mesh::box_hex_mesh(unit_box(), cells);
    const auto number = [&](const Eigen::Vector3i& c) { return c(0) + cells(0) * (c(1) + cells(1) * c(2)); };
    std::vector<Eigen::Vector3i> kept{{0, dice.count(0, cells(1) - 1), dice.count(0, cells(2) - 1)}};
    std::vector<bool> taken(static_cast<std::size_t>(grid.cell_count()), false);
    taken[static_cast<std::size_t>(number(kept[0]))] = true;
    for (int attempt = 0; attempt < 3 * grid.cell_count(); ++attempt) {
        Eigen::Vector3i next = dice.of(kept);
        const int axis = dice.count(0, 2);
        next(axis) += dice.chance(0.5) ? 1 : -1;
        if (next(axis) < 0 || next(axis) >= cells(axis) || taken[static_cast<std::size_t>(number(next))]) continue;
        taken[static_cast<std::size_t>(number(next))] = true;
        kept.push_back(next);
    }
    mesh::VolumeMesh heap{mesh::CellType::hex8, {}, Eigen::MatrixXi(8, static_cast<Eigen::Index>(kept.size()))};
    std::map<int, int> renamed;
    for (std::size_t c = 0; c < kept.size(); ++c)
        for (int a = 0; a < 8; ++a) {
            const int node = grid.cells(a, number(kept[c]));
            heap.cells(a, static_cast<Eigen::Index>(
                              c)) = renamed.emplace(node, static_cast<int>(renamed.size())).first->second;
        }
    heap.nodes.resize(3, static_cast<Eigen::Index>(renamed.size()));
    for (const auto& [old_name, name] : renamed) heap.nodes.col(name) = grid.nodes.col(old_name);
    return heap;
}

/// A box or a heap, jittered, flattened and sheared; tiny to large. Its worst cell may be as bad as 0.02 of 1, but not
/// turned.
inline mesh::VolumeMesh random_mesh(Dice& dice, fem::ElementKind kind) {
    const mesh::CellType type = fem::cell_type(kind);
    const bool tets = type != mesh::CellType::hex8;  // six of them make a cell
    const Eigen::Vector3i cells(dice.count(1, tets ? 3 : 5), dice.count(1, 2), tets ? 1 : dice.count(1, 2));
    mesh::VolumeMesh mesh = tets               ? mesh::tet_box_mesh(unit_box(), cells, mesh::CellType::tet4)
                            : dice.chance(0.4) ? voxel_heap(dice, cells + Eigen::Vector3i(0, 1, 1))
                                               : mesh::box_hex_mesh(unit_box(), cells);
    const double edge = mesh::mean_edge_length(mesh);
    double jitter = dice.chance(0.4) ? 0.0 : dice.between(0.0, 0.25);
    const Eigen::Matrix3Xd shift = dice.noise(mesh.node_count(), edge), even = mesh.nodes;
    do {
        mesh.nodes = even + jitter * shift;
        jitter *= 0.7;
    } while (mesh::cell_shapes(mesh).minCoeff() < 0.02 && jitter > 1e-6);
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity() * dice.decades(0.01, 1.0);
    if (dice.chance(0.3)) A.row(dice.count(0, 2)) *= dice.decades(0.1, 1.0);
    if (dice.chance(0.3)) A(0, 2) = dice.between(-1.0, 1.0) * A(0, 0);
    mesh.nodes = A * mesh.nodes;
    return type == mesh::CellType::tet10 ? mesh::to_tet10(mesh) : mesh;
}

/// Nodes at the low end of the mesh along its longest axis, at least three of them.
inline std::vector<int> low_end(const mesh::VolumeMesh& mesh) {
    std::vector<int> order(static_cast<std::size_t>(mesh.node_count()));
    for (int i = 0; i < static_cast<int>(order.size()); ++i) order[static_cast<std::size_t>(i)] = i;
    std::sort(order.begin(), order.end(), [&](int a, int b) { return mesh.nodes(0, a) < mesh.nodes(0, b); });
    order.resize(std::min<std::size_t>(order.size() - 1, std::max<std::size_t>(3, order.size() / 6)));
    return order;
}

/// A case: what is simulated, how, and which kind it is, for the count of what converges.
struct RandomCase {
    model::Model model;
    dynamics::SimulationOptions options;
    bool statics = false;
    std::vector<std::string> kinds;
};

inline RandomCase random_case(unsigned seed) {
    Dice dice(seed);
    RandomCase result;
    model::Model& model = result.model;
    fem::ElementKind kind{};
    fem::parse_element(dice.of(fem::element_ids()), kind);
    const mesh::VolumeMesh mesh = random_mesh(dice, kind);
    const bool held = dice.chance(0.9);
    model.body = model::make_body(mesh, kind, held ? low_end(mesh) : std::vector<int>{});
    const model::Body& body = *model.body;
    const double size = (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).maxCoeff(),
                 edge = mesh::mean_edge_length(mesh);

    model.material = dice.of(material::material_catalogue());
    const double E = dice.decades(1e3, 1e8), nu = dice.of(std::vector<double>{0.0, 0.3, 0.45, 0.49, 0.499, 0.4995});
    model.moduli = model::uniform_moduli(body.cell_count(), E, nu);
    const bool contrast = dice.chance(0.3);
    if (contrast)
        for (material::Moduli& m : model.moduli)
            if (dice.chance(0.5)) m = material::moduli_from_young(1000.0 * E, nu);
    model.density_kg_m3 = dice.decades(100.0, 8000.0);
    if (dice.chance(0.5)) model.damping_s = dice.decades(1e-5, 0.1);
    if (dice.chance(0.2)) model.velocity_force_1_s = dice.between(-20.0, 20.0);
    // The weight strains by up to a tenth, a force by up to a fifth; some loads are far beyond what a body bears.
    const double violence = dice.chance(0.1) ? dice.decades(1.0, 100.0) : 1.0;
    model.gravity_m_s2 = dice.decades(1e-4, 0.1) * violence * E / (model.density_kg_m3 * size) * dice.direction();
    const double volume = body.volume_m3;
    if (dice.chance(0.5)) {
        model::DeadForce load;
        load.share = Eigen::VectorXd::Zero(body.node_count());
        for (int i = 0; i < 3; ++i) load.share(dice.count(0, body.node_count() - 1)) += 1.0 / 3.0;
        load.force_N = dice.decades(1e-4, 0.05) * violence * E * volume / size * dice.direction();
        model.forces.push_back(load);
    }
    if (dice.chance(0.3)) {
        auto groups = std::make_shared<std::vector<fibre::FibreGroup>>();
        const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff(), high = mesh.nodes.rowwise().maxCoeff();
        const Eigen::Vector3d fibre = dice.chance(0.5) ? Eigen::Vector3d::UnitX() : dice.direction();
        groups->push_back(fibre::fibres_in_box(mesh, {low, Eigen::Vector3d(high(0), high(1), 0.5 * (low(2) + high(2)))},
                                               fibre, dice.decades(0.01, 1.0) * E, "half"));
        model.fibres = groups;
        model.activation = {fibre::Signal::constant(dice.between(0.2, 2.5))};
    }

    dynamics::SimulationOptions& options = result.options;
    dynamics::parse_integrator(dice.of(dynamics::integrator_ids()), options.integrator.integrator);
    options.integrator.rho_inf = dice.between(0.0, 1.0);
    dynamics::parse_strategy(dice.of(dynamics::strategy_ids()), options.solver.strategy);
    options.h_s = dice.decades(1e-6, 10.0);
    options.end_s = 3.0 * options.h_s;
    result.statics = dice.chance(0.15);
    const double period = size * std::sqrt(model.density_kg_m3 / E);  // of a wave, about
    const std::string start = dice.of(std::vector<std::string>{"undeformed", "undeformed", "equilibrium", "thrown",
                                                               "shaken", "turned inside out", "mirrored"});
    if (start == "equilibrium") options.start = dynamics::StartKind::equilibrium;
    if (start == "thrown")
        options.initial.velocities = dice.noise(body.node_count(), dice.decades(0.01, 1.0) * size / period);
    if (start == "shaken") options.initial.positions = mesh.nodes + dice.noise(body.node_count(), 0.05 * edge);
    if (start == "turned inside out") options.initial.positions = mesh.nodes + dice.noise(body.node_count(), edge);
    if (start == "mirrored") options.initial.positions = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal() * mesh.nodes;

    result.kinds = {"start " + start,
                    "element " + to_string(kind),
                    "material " + model.material->id(),
                    "strategy " + to_string(options.solver.strategy),
                    result.statics ? "statics" : "integrator " + to_string(options.integrator.integrator),
                    "nu " + std::to_string(nu).substr(0, 6),
                    contrast ? "contrast 1000" : "contrast 1",
                    held ? "held" : "free",
                    violence > 1.0 ? "overloaded" : "bearable loads"};
    if (!result.statics)
        result.kinds.push_back("h 1e" + std::to_string(static_cast<int>(std::floor(std::log10(options.h_s)))) + " s");
    return result;
}

}  // namespace myo::test
