#include "solver/supernodal_factor.hpp"

#include <algorithm>
#include <cassert>

namespace myo {
namespace {

/// Visits the supernodes with their dense blocks and the row numbers below the diagonal block.
template <class Visit>
void visit_supernode(const SupernodalFactor& f, std::size_t s, const Visit& visit) {
    using Strided = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
    const int column = f.first_column[s], columns = f.first_column[s + 1] - column;
    const long row_count = f.first_row[s + 1] - f.first_row[s];
    const float* values = f.values.data() + f.first_value[s];
    const Strided diagonal(values, columns, columns, Eigen::OuterStride<>(row_count));
    const Strided below(values + columns, row_count - columns, columns, Eigen::OuterStride<>(row_count));
    visit(column, diagonal, below, f.rows.data() + f.first_row[s] + columns);
}

/// L L' Y = Y in place, Y permuted. A single column comes as a vector, so that its products are those of vectors. `gathered` is
/// work space for the rows of one supernode.
template <class Columns>
void solve_in_place(const SupernodalFactor& f, Columns& Y, Columns& gathered) {
    const std::size_t count = f.first_column.size() - 1;
    for (std::size_t s = 0; s < count; ++s)
        visit_supernode(f, s, [&](int column, const auto& diagonal, const auto& below, const int* rows) {
            auto top = Y.middleRows(column, diagonal.cols());
            diagonal.template triangularView<Eigen::Lower>().solveInPlace(top);
            if (below.rows() == 0) return;
            auto product = gathered.topRows(below.rows());
            product.noalias() = below * top;
            for (Eigen::Index k = 0; k < Y.cols(); ++k)
                for (Eigen::Index i = 0; i < below.rows(); ++i) Y(rows[i], k) -= product(i, k);
        });
    for (std::size_t s = count; s-- > 0;)
        visit_supernode(f, s, [&](int column, const auto& diagonal, const auto& below, const int* rows) {
            auto top = Y.middleRows(column, diagonal.cols());
            if (below.rows() > 0) {
                auto values = gathered.topRows(below.rows());
                for (Eigen::Index k = 0; k < Y.cols(); ++k)
                    for (Eigen::Index i = 0; i < below.rows(); ++i) values(i, k) = Y(rows[i], k);
                top.noalias() -= below.transpose() * values;
            }
            diagonal.template triangularView<Eigen::Lower>().transpose().solveInPlace(top);
        });
}

}  // namespace

Eigen::MatrixXd SupernodalFactor::solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
    assert(B.rows() == size());
    long most_rows = 0;
    for (std::size_t s = 0; s + 1 < first_row.size(); ++s) most_rows = std::max(most_rows, first_row[s + 1] - first_row[s]);
    // Single precision overflows where double does not: each column is solved at its own scale.
    const Eigen::RowVectorXd scale = B.colwise().lpNorm<Eigen::Infinity>().cwiseMax(1e-300);
    Eigen::MatrixXf Y(B.rows(), B.cols());
    for (Eigen::Index k = 0; k < B.cols(); ++k)
        for (int i = 0; i < size(); ++i) Y(i, k) = static_cast<float>(B(permutation[static_cast<std::size_t>(i)], k) / scale(k));
    if (B.cols() == 1) {
        Eigen::VectorXf y = Y.col(0), gathered(most_rows);
        solve_in_place(*this, y, gathered);
        Y.col(0) = y;
    } else {
        Eigen::MatrixXf gathered(most_rows, B.cols());
        solve_in_place(*this, Y, gathered);
    }
    Eigen::MatrixXd X(B.rows(), B.cols());
    for (Eigen::Index k = 0; k < B.cols(); ++k)
        for (int i = 0; i < size(); ++i) X(permutation[static_cast<std::size_t>(i)], k) = scale(k) * static_cast<double>(Y(i, k));
    return X;
}

}  // namespace myo
