#include "model/nodal_rotations.hpp"

#include <vector>

#include "base/parallel.hpp"
#include "material/polar.hpp"
#include "model/pack_tensors.hpp"

namespace myo::model {
namespace {

using Rotations = Eigen::Matrix<double, 9, Eigen::Dynamic>;

/// Volume integral of F over each cell: centre weight for assumed strains, sum over points otherwise.
template <int N, int Q>
material::Matrix3<Pack> mean_gradient(const PackGeometry<N, Q>& geometry, const PackNodes<N>& x) {
    material::Matrix3<Pack> sum = zero_tensor();
    for (std::size_t q = 0; q < Q; ++q) sum += nodal_product(x, geometry.gradient[q]) * geometry.weight[q];
    return sum;
}
material::Matrix3<Pack> mean_gradient(const PackAssumedStrain& geometry, const PackNodes<8>& x) {
    return nodal_product(x, geometry.gradient) * geometry.volume;
}

/// Sum over the cells around each node of volume-weighted deformation gradients.
template <class Geometry>
Rotations mean_gradients(const PackedCells<Geometry>& cells, const Body& body, const Eigen::Matrix3Xd& x) {
    std::vector<material::Matrix3<Pack>> means(static_cast<std::size_t>(cells.pack_count()));
    parallel_ranges(cells.pack_count(), 50, [&](int first, int end) {
        for (auto pack = static_cast<std::size_t>(first); pack < static_cast<std::size_t>(end); ++pack) {
            const auto xe = nodes_of_pack(cells, static_cast<int>(pack), x);
            means[pack] = mean_gradient(cells.geometry(static_cast<int>(pack)), xe);
        }
    });
    // Gather by node: the order of summation is fixed by the incidence.
    Rotations sum = Rotations::Zero(9, body.node_count());
    const auto* values = reinterpret_cast<const double*>(means.data());
    parallel_ranges(body.node_count(), 500, [&](int first, int end) {
        for (int i = first; i < end; ++i)
            for (int k = body.incidence.start[static_cast<std::size_t>(i)];
                 k < body.incidence.start[static_cast<std::size_t>(i) + 1]; ++k) {
                const int cell = incident_cell<Geometry::nodes>(body.incidence, k);
                const double* mean = values + cell / pack_width * 9 * pack_width + cell % pack_width;
                for (int e = 0; e < 9; ++e) sum(e, i) += mean[e * pack_width];
            }
    });
    return sum;
}

/// Replaces pack_width gradients by their polar rotations.
void turn_into_rotations(Rotations& field, Eigen::Index first) {
    const Eigen::Index last = field.cols() - 1;
    // Lanes past the last node repeat it.
    const auto column = [&](auto lane) { return std::min(first + static_cast<Eigen::Index>(lane), last); };
    material::Matrix3<Pack> F;
    Pack size = 0.0;
    for (int k = 0; k < 9; ++k) {
        F(k % 3, k / 3) = Pack([&](auto lane) { return field(k, column(lane)); });
        size += F(k % 3, k / 3) * F(k % 3, k / 3);
    }
    // The volume factor is removed first: the polar decomposition expects entries of order one.
    F *= 1.0 / sqrt((1.0 / 3.0) * size);
    const PackMask degenerate = !(size > 1e-300) || !(size < 1e300);  // zero or non-finite: no rotation defined
    for (int k = 0; k < 9; ++k) set_where(degenerate, F(k % 3, k / 3), k % 4 == 0 ? 1.0 : 0.0);
    const material::Matrix3<Pack> R = material::polar_rotation(F);
    for (Eigen::Index i = first; i <= std::min(first + pack_width - 1, last); ++i)
        for (int k = 0; k < 9; ++k) field(k, i) = R(k % 3, k / 3)[static_cast<std::size_t>(i - first)];
}

}  // namespace

Rotations nodal_rotations(const Body& body, const Eigen::Matrix3Xd& x) {
    Rotations field = std::visit([&](const auto& cells) { return mean_gradients(cells, body, x); }, body.cells);
    parallel_ranges(static_cast<int>((field.cols() + pack_width - 1) / pack_width), 50, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) turn_into_rotations(field, pack * pack_width);
    });
    return field;
}

}  // namespace myo::model
