#include "fem/element_block.hpp"

#include <cassert>

#include "base/name_table.hpp"
#include "fem/isoparametric.hpp"

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

/// Quadratic tetrahedra with a mean volume and part of the bulk modulus at their points.
template <int Q>
ElementBlock<10, Q> tet10_block(const mesh::VolumeMesh& mesh, const std::vector<mesh::QuadraturePoint>& rule,
                                const CellSurroundings& surroundings) {
    auto block = gauss_block<mesh::Tet10, Q>(mesh, rule, true);
    const PointBulkPolicy policy;
    block.point_bulk_over_mu.assign(static_cast<std::size_t>(mesh.cell_count()), policy.free);
    for (std::size_t c = 0; c < surroundings.size(); ++c)
        block.point_bulk_over_mu[c] = policy.over_mu(surroundings[c].front());
    return block;
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
        case ElementKind::hex8_mean_dilatation: return gauss_block<mesh::Hex8, 8>(mesh, mesh::hex_gauss(2), true);
        case ElementKind::hex8_full: return gauss_block<mesh::Hex8, 8>(mesh, mesh::hex_gauss(2), false);
        case ElementKind::tet10: return tet10_block<4>(mesh, mesh::tet_degree2(), surroundings);
        case ElementKind::tet10_fine: return tet10_block<10>(mesh, mesh::tet_degree3(), surroundings);
        case ElementKind::tet10_full: return gauss_block<mesh::Tet10, 4>(mesh, mesh::tet_degree2(), false);
        case ElementKind::tet4: return gauss_block<mesh::Tet4, 1>(mesh, mesh::tet_centroid(), false);
        case ElementKind::hex8: break;
    }
    return assumed_strain_block(mesh, surroundings);
}

std::vector<MassEntry> consistent_mass(const mesh::VolumeMesh& mesh) {
    return mesh::with_cell(mesh.type, [&](auto cell) { return consistent_mass_of<decltype(cell)>(mesh); });
}

}  // namespace myo::fem
