#include "sensitivity/tangent_columns.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace myo::sensitivity {
namespace {

struct TangentColumnsPolicy {
    Eigen::Index entries_at_once = 2048;
};
constexpr TangentColumnsPolicy tangent_columns_policy;

}  // namespace

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd gather_columns(const model::BlockPattern& pattern, const model::NodalColumns& fields) {
    MatrixXd result(pattern.unknowns(), fields.rows() / 3);
    for (Index p = 0; p < result.cols(); ++p)
        for (int i = 0; i < pattern.free_count; ++i)
            result.col(p).segment<3>(3 *
                                     i) = fields.col(pattern.free_nodes[static_cast<std::size_t>(i)]).segment<3>(3 * p);
    for (const int unknown : pattern.held_unknowns) result.row(unknown).setZero();
    return result;
}

model::NodalColumns scatter_columns(const model::BlockPattern& pattern, const MatrixXd& unknowns) {
    model::NodalColumns result = model::NodalColumns::Zero(3 * unknowns.cols(),
                                                           static_cast<Index>(pattern.free_index.size()));
    for (Index p = 0; p < unknowns.cols(); ++p)
        for (int i = 0; i < pattern.free_count; ++i)
            result.col(pattern.free_nodes[static_cast<std::size_t>(i)]).segment<3>(3 * p) = unknowns.col(p).segment<3>(
                3 * i);
    for (const int unknown : pattern.held_unknowns)
        for (Index p = 0; p < unknowns.cols(); ++p)
            result(3 * p + unknown % 3, pattern.free_nodes[static_cast<std::size_t>(unknown / 3)]) = 0.0;
    return result;
}

model::NodalColumns mass_times(const model::NodalColumns& fields, const model::MassMatrix& mass) {
    if (fields.size() == 0) return {};
    model::NodalColumns result(fields.rows(), fields.cols());
    // Each thread writes its own columns (nodes): deterministic without synchronisation. The mass matrix is symmetric.
    parallel_ranges(static_cast<int>(mass.isotropic.outerSize()), 50, [&](int first, int end) {
        for (int j = first; j < end; ++j) {
            result.col(j).setZero();
            for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.isotropic, j); entry; ++entry)
                result.col(j) += entry.value() * fields.col(entry.row());
        }
    });
    if (mass.has_directional()) model::add_directional(mass.directional, fields, result);
    return result;
}

// Blocks of entries are summed over all terms, so that the partial sum stays in the cache.
MatrixXd sum_of(const FieldTerms& terms) {
    MatrixXd result;
    for (const auto& [factor, field] : terms)
        if (factor != 0.0 && field->size() > 0) result.resizeLike(*field);
    for (Index start = 0; start < result.size(); start += tangent_columns_policy.entries_at_once) {
        const Index count = std::min(tangent_columns_policy.entries_at_once, result.size() - start);
        Eigen::Map<VectorXd> part(result.data() + start, count);
        part.setZero();
        for (const auto& [factor, field] : terms)
            if (factor != 0.0 && field->size() > 0)
                part += factor * Eigen::Map<const VectorXd>(field->data() + start, count);
    }
    return result;
}

}  // namespace myo::sensitivity
