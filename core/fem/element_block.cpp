#include "fem/element_block.hpp"

#include <Eigen/LU>

#include <cassert>

#include "base/name_table.hpp"
#include "fem/cell_shapes.hpp"

namespace myo::fem {
namespace {

constexpr NameTable<ElementKind, 7> element_names{{{
    {ElementKind::hex8, "hex8"},
    {ElementKind::hex8_mean_dilatation, "hex8_mean_dilatation"},
    {ElementKind::hex8_full, "hex8_full"},
    {ElementKind::tet10, "tet10"},
    {ElementKind::tet10_fine, "tet10_fine"},
    {ElementKind::tet10_full, "tet10_full"},
    {ElementKind::tet4, "tet4"},
}}};

/// Rest positions of the nodes of a cell, 3 x N.
template <int N>
Eigen::Matrix<double, 3, N> cell_positions(const mesh::VolumeMesh& mesh, Eigen::Index cell) {
    Eigen::Matrix<double, 3, N> X;
    for (int a = 0; a < N; ++a) X.col(a) = mesh.nodes.col(mesh.cells(a, cell));
    return X;
}

/// Isoparametric elements with a quadrature rule.
template <class Shape, int Q>
ElementBlock<Shape::nodes, Q> gauss_block(const mesh::VolumeMesh& mesh, const std::vector<QuadraturePoint>& rule,
                                          bool mean_volume) {
    constexpr int N = Shape::nodes;
    assert(rule.size() == Q);
    ElementBlock<N, Q> block;
    block.mean_volume = mean_volume;
    block.cells = mesh.cells;
    block.geometry.resize(static_cast<std::size_t>(mesh.cell_count()));
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto X = cell_positions<N>(mesh, c);
        auto& geometry = block.geometry[static_cast<std::size_t>(c)];
        for (std::size_t q = 0; q < Q; ++q) {
            const Eigen::Matrix<double, N, 3> D = Shape::derivatives(rule[q].xi);
            const Eigen::Matrix3d jacobian = X * D;  // dX/dxi
            geometry.gradient[q] = D * jacobian.inverse();
            geometry.weight[q] = rule[q].weight * jacobian.determinant();
            geometry.volume += geometry.weight[q];
        }
    }
    return block;
}

/// Quadratic tetrahedra with a mean volume and part of the bulk modulus at their points.
template <int Q>
ElementBlock<10, Q> tet10_block(const mesh::VolumeMesh& mesh, const std::vector<QuadraturePoint>& rule,
                                const CellSurroundings& surroundings) {
    auto block = gauss_block<Tet10, Q>(mesh, rule, true);
    const PointBulkPolicy policy;
    block.point_bulk_over_mu.assign(static_cast<std::size_t>(mesh.cell_count()), policy.free);
    for (std::size_t c = 0; c < surroundings.size(); ++c)
        block.point_bulk_over_mu[c] = policy.over_mu(surroundings[c].front());
    return block;
}

/// Consistent mass of all cells; the rule must integrate products of shape functions exactly.
template <class Shape>
void add_cell_mass(const mesh::VolumeMesh& mesh, const std::vector<QuadraturePoint>& rule,
                   std::vector<MassEntry>& entries) {
    constexpr int N = Shape::nodes;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto X = cell_positions<N>(mesh, c);
        Eigen::Matrix<double, N, N> M = Eigen::Matrix<double, N, N>::Zero();
        for (const QuadraturePoint& point : rule) {
            const Eigen::Matrix<double, N, 1> values = Shape::values(point.xi);
            const Eigen::Matrix3d jacobian = X * Shape::derivatives(point.xi);
            M += point.weight * jacobian.determinant() * values * values.transpose();
        }
        for (int b = 0; b < N; ++b)
            for (int a = 0; a < N; ++a) entries.push_back({mesh.cells(a, c), mesh.cells(b, c), M(a, b)});
    }
}

}  // namespace

std::string to_string(ElementKind kind) { return element_names.name(kind); }
std::vector<std::string> element_ids() { return element_names.names(); }
bool parse_element(const std::string& id, ElementKind& kind) { return element_names.find(id, kind); }

mesh::CellType cell_type(ElementKind kind) {
    switch (kind) {
        case ElementKind::tet10:
        case ElementKind::tet10_fine:
        case ElementKind::tet10_full: return mesh::CellType::tet10;
        case ElementKind::tet4: return mesh::CellType::tet4;
        case ElementKind::hex8:
        case ElementKind::hex8_mean_dilatation:
        case ElementKind::hex8_full: break;
    }
    return mesh::CellType::hex8;
}

ElementKind default_element(mesh::CellType type) {
    for (const auto& entry : element_names.entries)
        if (cell_type(entry.value) == type) return entry.value;
    return ElementKind::hex8;
}

ElementKind fine_element(ElementKind kind) { return kind == ElementKind::tet10 ? ElementKind::tet10_fine : kind; }

Elements make_elements(const mesh::VolumeMesh& mesh, ElementKind kind, const CellSurroundings& surroundings) {
    assert(mesh.type == cell_type(kind));
    switch (kind) {
        case ElementKind::hex8_mean_dilatation: return gauss_block<Hex8, 8>(mesh, hex_gauss(2), true);
        case ElementKind::hex8_full: return gauss_block<Hex8, 8>(mesh, hex_gauss(2), false);
        case ElementKind::tet10: return tet10_block<4>(mesh, tet_degree2(), surroundings);
        case ElementKind::tet10_fine: return tet10_block<10>(mesh, tet_degree3(), surroundings);
        case ElementKind::tet10_full: return gauss_block<Tet10, 4>(mesh, tet_degree2(), false);
        case ElementKind::tet4: return gauss_block<Tet4, 1>(mesh, tet_centroid(), false);
        case ElementKind::hex8: break;
    }
    return assumed_strain_block(mesh, surroundings);
}

std::vector<MassEntry> consistent_mass(const mesh::VolumeMesh& mesh) {
    std::vector<MassEntry> entries;
    with_shape(mesh.type, [&]<class Shape>(Shape shape) { add_cell_mass<Shape>(mesh, mass_rule(shape), entries); });
    return entries;
}

}  // namespace myo::fem
