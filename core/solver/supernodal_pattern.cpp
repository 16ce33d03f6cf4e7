#include "solver/supernodal_pattern.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <memory>
#include <utility>

#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "solver/cholmod_session.hpp"

namespace myo::solver {
namespace {

/// Operations of the partial factorisation of a dense block with n columns and m rows.
double supernode_flops(double n, double m) {
    // Sum over columns j of (m - j)^2: column j has m - j rows with one division each and their mutual products.
    return n * m * m - n * n * m + n * n * n / 3.0;
}

struct SupernodalPatternPolicy {
    /// Subtrees with less than this share of the total work stay on one thread.
    double subtree_share = 1.0 / 32.0;
};
constexpr SupernodalPatternPolicy supernodal_pattern_policy;

/// Elimination tree with children and roots, and the cut into subtrees of one thread each.
void cut_tree(SupernodalPattern& p) {
    const auto count = static_cast<std::size_t>(p.supernodes());
    std::vector<double> work(count);
    std::vector<int> first(count);  // first supernode of the subtree
    double total = 0.0;
    p.children.resize(count);
    for (std::size_t s = 0; s < count; ++s) {
        const int at = static_cast<int>(s);
        const double own = supernode_flops(p.columns(at), p.row_count(at));
        total += own;
        work[s] += own;
        // Postordering makes a subtree contiguous: it ends at its root and starts at the first child's start.
        first[s] = p.children[s].empty() ? at : first[static_cast<std::size_t>(p.children[s].front())];
        if (p.parent[s] < 0)
            p.roots.push_back(at);
        else {
            p.children[static_cast<std::size_t>(p.parent[s])].push_back(at);
            work[static_cast<std::size_t>(p.parent[s])] += work[s];
        }
    }
    p.subtree_start.assign(count, -1);
    for (std::size_t s = 0; s < count; ++s)
        if (work[s] <= supernodal_pattern_policy.subtree_share * total) p.subtree_start[s] = first[s];
}

/// Positions of the rows below each supernode in the rows of its parent. Both lists are ascending: one merge pass.
void match_parents(SupernodalPattern& p) {
    p.parent_position.assign(p.rows.size(), -1);
    for (int s = 0; s < p.supernodes(); ++s) {
        const int up = p.parent[static_cast<std::size_t>(s)];
        if (up < 0) continue;
        long at = p.first_row[static_cast<std::size_t>(up)];
        const long first = p.first_row[static_cast<std::size_t>(s)];
        for (long i = first + p.columns(s); i < first + p.row_count(s); ++i) {
            while (p.rows[static_cast<std::size_t>(at)] != p.rows[static_cast<std::size_t>(i)]) ++at;
            assert(at < p.first_row[static_cast<std::size_t>(up) + 1]);
            p.parent_position[static_cast<std::size_t>(i)] = static_cast<int>(
                at - p.first_row[static_cast<std::size_t>(up)]);
        }
    }
}

/// Position in the factor's values for each stored entry of the lower triangle of A.
void place_entries(const SymmetricSparse& lower, SupernodalPattern& p) {
    assert(p.value_count() <= std::numeric_limits<std::uint32_t>::max());
    const auto n = static_cast<std::size_t>(p.size());
    std::vector<int> place(n), supernode(n);
    for (std::size_t k = 0; k < n; ++k) place[static_cast<std::size_t>(p.permutation[k])] = static_cast<int>(k);
    for (int s = 0; s < p.supernodes(); ++s)
        for (int c = 0; c < p.columns(s); ++c)
            supernode[static_cast<std::size_t>(p.first_column[static_cast<std::size_t>(s)] + c)] = s;
    p.entry.resize(static_cast<std::size_t>(lower.nonZeros()));
    std::size_t k = 0;
    for (int j = 0; j < lower.outerSize(); ++j)
        for (SymmetricSparse::InnerIterator it(lower, j); it; ++it, ++k) {
            // The permutation can move an entry above the diagonal. min and max return it to the lower triangle.
            const auto [column, row] = std::minmax(
                {place[static_cast<std::size_t>(it.row())], place[static_cast<std::size_t>(j)]});
            const auto s = static_cast<std::size_t>(supernode[static_cast<std::size_t>(column)]);
            const auto begin = p.rows.begin() + p.first_row[s], end = begin + p.row_counts[s];
            const long local_row = std::lower_bound(begin, end, row) - begin;
            const long value = p.first_value[s] +
                               (column - p.first_column[s]) * static_cast<long>(p.row_stride(static_cast<int>(s))) +
                               local_row;
            p.entry[k] = static_cast<std::uint32_t>(value);
        }
}

/// Analysis on this thread; METIS and CHOLMOD cannot be interrupted.
SupernodalPattern analysed(const SymmetricSparse& lower) {
    CholmodSession session;
    cholmod_sparse matrix = cholmod_view(lower);
    const CholmodFactor factor = session.analyse(matrix);
    SupernodalPattern p;
    if (!factor) return p;
    const auto* permutation = static_cast<const int*>(factor->Perm);
    const auto* columns = static_cast<const int*>(factor->super);
    const auto* row_starts = static_cast<const int*>(factor->pi);
    const auto* rows = static_cast<const int*>(factor->s);
    p.permutation.assign(permutation, permutation + factor->n);
    p.first_column.assign(columns, columns + factor->nsuper + 1);
    // Row lists are padded to whole cache lines, see row_stride().
    p.first_row.assign(1, 0);
    for (std::size_t s = 0; s < factor->nsuper; ++s) {
        constexpr int unit = SupernodalPattern::stride_unit;
        const int count = row_starts[s + 1] - row_starts[s];
        p.row_counts.push_back(count);
        p.rows.insert(p.rows.end(), rows + row_starts[s], rows + row_starts[s + 1]);
        p.first_row.push_back(p.first_row.back() + (count + unit - 1) / unit * unit);
        p.rows.resize(static_cast<std::size_t>(p.first_row.back()), -1);
    }
    p.parent.assign(factor->nsuper, -1);
    p.first_value.assign(1, 0);
    std::vector<int> supernode(factor->n);
    for (std::size_t s = 0; s < factor->nsuper; ++s)
        std::fill(supernode.begin() + columns[s], supernode.begin() + columns[s + 1], static_cast<int>(s));
    for (int s = 0; s < p.supernodes(); ++s) {
        p.first_value.push_back(p.first_value.back() + static_cast<long>(p.columns(s)) * p.row_stride(s));
        if (p.row_count(s) == p.columns(s)) continue;
        // The parent is the supernode of the first row below the own columns.
        const long first_below = p.first_row[static_cast<std::size_t>(s)] + p.columns(s);
        p.parent[static_cast<std::size_t>(s)] = supernode[static_cast<std::size_t>(
            p.rows[static_cast<std::size_t>(first_below)])];
    }
    cut_tree(p);
    match_parents(p);
    place_entries(lower, p);
    return p;
}

}  // namespace

SupernodalPattern analyse_pattern(const SymmetricSparse& lower) {
    if (cancellation_in_scope() == nullptr) return analysed(lower);
    const auto matrix = std::make_shared<const SymmetricSparse>(lower);
    const auto pattern = std::make_shared<SupernodalPattern>();
    if (!run_abandonable([matrix, pattern] { *pattern = analysed(*matrix); })) return {};
    return std::move(*pattern);
}

double factor_flops(const SupernodalPattern& pattern) {
    double sum = 0.0;
    for (int s = 0; s < pattern.supernodes(); ++s) sum += supernode_flops(pattern.columns(s), pattern.row_count(s));
    return sum;
}

}  // namespace myo::solver
