#include "model/packed_cells.hpp"

namespace myo {

template <int N, int Q>
PackedCells<N, Q> pack_cells(const ElementBlock<N, Q>& block) {
    PackedCells<N, Q> packed;
    packed.mean_volume = block.mean_volume;
    packed.most_point_bulk_over_mu = block.most_point_bulk_over_mu;
    packed.cell_count = block.cell_count();
    const int packs = (block.cell_count() + pack_width - 1) / pack_width;
    packed.lane_nodes.resize(static_cast<std::size_t>(packs));
    packed.geometry.resize(static_cast<std::size_t>(packs));
    if (!block.hourglass.empty()) packed.hourglass.resize(static_cast<std::size_t>(packs));
    for (std::size_t pack = 0; pack < packed.lane_nodes.size(); ++pack)
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(pack_width); ++lane) {
            const int cell = std::min(static_cast<int>(pack) * pack_width + static_cast<int>(lane), block.cell_count() - 1);
            for (int a = 0; a < N; ++a) packed.lane_nodes[pack][static_cast<std::size_t>(a)][lane] = block.cells(a, cell);
            const CellGeometry<N, Q>& from = block.geometry[static_cast<std::size_t>(cell)];
            PackGeometry<N, Q>& to = packed.geometry[pack];
            for (std::size_t q = 0; q < Q; ++q) {
                for (int a = 0; a < N; ++a)
                    for (int j = 0; j < 3; ++j) to.gradient[q](a, j)[lane] = from.gradient[q](a, j);
                to.weight[q][lane] = from.weight[q];
            }
            to.volume[lane] = from.volume;
            if (block.hourglass.empty()) continue;
            const HourglassGeometry& shape = block.hourglass[static_cast<std::size_t>(cell)];
            PackHourglass& hourglass = packed.hourglass[pack];
            for (int a = 0; a < 8; ++a)
                for (int s = 0; s < 4; ++s) hourglass.gamma(a, s)[lane] = shape.gamma(a, s);
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) hourglass.frame(i, j)[lane] = shape.frame(i, j);
                hourglass.half_length[static_cast<std::size_t>(i)][lane] = shape.half_length(i);
            }
        }
    return packed;
}

PackedElements pack_elements(const Elements& elements) {
    return std::visit([](const auto& block) -> PackedElements { return pack_cells(block); }, elements);
}

NodeIncidence node_incidence(const VolumeMesh& mesh) {
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
            incidence.offset[static_cast<std::size_t>(at++)] = (c / pack_width * 3 * nodes + 3 * a) * pack_width + c % pack_width;
        }
    return incidence;
}

}  // namespace myo
