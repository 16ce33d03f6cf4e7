#include "support/hollow.hpp"

#include <algorithm>
#include <cmath>

namespace myo::test {

mesh::VolumeMesh without(const mesh::VolumeMesh& mesh, const Box& box) {
    mesh::VolumeMesh result;
    result.type = mesh.type;
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1), kept, cells;
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        const auto cell = mesh.cells.col(c);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        // A cell belongs to the box if its centre does.
        for (const int i : cell) middle += mesh.nodes.col(i) / static_cast<double>(cell.size());
        if (box.contains(middle)) continue;
        cells.push_back(c);
        for (const int i : cell) {
            int& n = number[static_cast<std::size_t>(i)];
            // Nodes are numbered in the order in which the remaining cells refer to them.
            if (n >= 0) continue;
            n = static_cast<int>(kept.size());
            kept.push_back(i);
        }
    }
    result.nodes = mesh.nodes(Eigen::all, kept);
    result.cells = mesh.cells(Eigen::all, cells).unaryExpr([&](int i) { return number[static_cast<std::size_t>(i)]; });
    return result;
}

/// The chamber is cut from a regular mesh of 10 mm cells, so its walls are exact.
model::Model hollow_block(fem::ElementKind kind) {
    const mesh::VolumeMesh mesh = without(box_mesh(kind, {{0.0, 0.0, 0.0}, {0.06, 0.03, 0.03}}, {6, 3, 3}),
                                          {{0.02, 0.01, 0.01}, {0.05, 0.02, 0.02}});
    model::Model model;
    model.body = model::make_body(mesh, kind, mesh::nodes_in_box(mesh, {{-1e-6, -1.0, -1.0}, {1e-6, 1.0, 1.0}}));
    model.material = material::find_material("neo_hookean");
    model.moduli = model::uniform_moduli(model.body->cell_count(), 2.6e5, 0.45);
    model.density_kg_m3 = 1070.0;
    return model;
}

model::Model hollow_tube(double a, double b, double half_m, int cells, int along) {
    // Ends of about one cell's length along, at least two layers.
    const double layer = 2.0 * half_m / along, thick = b - a;
    const int layers = std::max(2, static_cast<int>(std::lround(thick / layer)));
    mesh::VolumeMesh mesh = mesh::box_hex_mesh(
        {{-1.0, -1.0, -1.0 - 2.0 * layers / along}, {1.0, 1.0, 1.0 + 2.0 * layers / along}},
        {cells, cells, along + 2 * layers});
    mesh = without(mesh, {{-1.0 / 3.0, -1.0 / 3.0, -1.0}, {1.0 / 3.0, 1.0 / 3.0, 1.0}});
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) {
        auto at = mesh.nodes.col(i);
        // Squares become circles; inside the hole's, where only the ends are, in proportion.
        const double shell = at.head<2>().cwiseAbs().maxCoeff();
        const double radius = shell < 1.0 / 3.0 ? 3.0 * a * shell : a + thick * (shell - 1.0 / 3.0) * 1.5;
        if (shell > 0.0) at.head<2>() *= radius / at.head<2>().norm();
        const double end = std::abs(at.z()) - 1.0;
        at.z() = std::copysign(end > 0.0 ? half_m + thick * end * along / (2.0 * layers) : half_m * (1.0 + end),
                               at.z());
    }
    model::Model model;
    model.body = model::make_body(mesh, fem::ElementKind::hex8, {});
    model.material = material::find_material("neo_hookean");
    model.density_kg_m3 = 1070.0;
    return model;
}

model::Model hollow_sphere(double a, double b, int cells) {
    mesh::VolumeMesh mesh = without(mesh::box_hex_mesh({{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, {cells, cells, cells}),
                                    {Eigen::Vector3d::Constant(-1.0 / 3.0), Eigen::Vector3d::Constant(1.0 / 3.0)});
    // Each cubic shell is projected onto a sphere: its distance from the centre in the maximum norm gives the radius.
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) {
        const double shell = mesh.nodes.col(i).cwiseAbs().maxCoeff();
        // The innermost shell, at 1/3, goes to radius a, the outermost, at 1, to radius b.
        mesh.nodes.col(i) *= (a + (b - a) * (shell - 1.0 / 3.0) * 1.5) / mesh.nodes.col(i).norm();
    }
    model::Model model;
    model.body = model::make_body(mesh, fem::ElementKind::hex8, {});
    model.material = material::find_material("neo_hookean");
    model.density_kg_m3 = 1070.0;
    return model;
}

}  // namespace myo::test
