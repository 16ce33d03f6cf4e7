#include "model/pack_cells.hpp"

namespace myo::model {
namespace {

/// Packs of an element block; one overload for each kind of block.
PackedCells<PackAssumedStrain> packed(const fem::AssumedStrainBlock& block) {
    return pack_cells<PackAssumedStrain>(block);
}
/// Packs of a block of compatible elements.
template <int N, int Q>
PackedCells<PackGeometry<N, Q>> packed(const fem::ElementBlock<N, Q>& block) {
    return pack_cells<PackGeometry<N, Q>>(block);
}

}  // namespace

PackedElements pack_elements(const fem::Elements& elements) {
    return std::visit([](const auto& block) -> PackedElements { return packed(block); }, elements);
}

// Counting sort: degrees, prefix sums, then the offsets in cell order.
NodeIncidence node_incidence(const mesh::VolumeMesh& mesh) {
    const auto nodes = static_cast<int>(mesh.cells.rows());
    NodeIncidence incidence;
    incidence.start.assign(static_cast<std::size_t>(mesh.node_count()) + 1, 0);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        for (int a = 0; a < nodes; ++a) ++incidence.start[static_cast<std::size_t>(mesh.cells(a, c)) + 1];
    for (std::size_t i = 1; i < incidence.start.size(); ++i) incidence.start[i] += incidence.start[i - 1];
    incidence.offset.resize(static_cast<std::size_t>(incidence.start.back()));
    std::vector<int> next(incidence.start.begin(), incidence.start.end() - 1);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c)
        for (int a = 0; a < nodes; ++a) {
            int& at = next[static_cast<std::size_t>(mesh.cells(a, c))];
            incidence.offset[static_cast<std::size_t>(at++)] = (c / pack_width * 3 * nodes + 3 * a) * pack_width +
                                                               c % pack_width;
        }
    return incidence;
}

}  // namespace myo::model
