#include "solver/schwarz.hpp"

#include <metis.h>

#include <algorithm>
#include <atomic>
#include <cassert>

#include "base/parallel.hpp"
#include "solver/cholmod_session.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;

struct SchwarzPolicy {
    /// Target size of a part without overlap. Larger parts need fewer iterations, smaller parts less memory.
    int unknowns_per_part = 12000;
    /// Layers of neighbouring nodes added to each part.
    int overlap_layers = 2;
};
constexpr SchwarzPolicy schwarz_policy;

/// Adjacency of the nodes (nodes that share a cell), in compressed row format as METIS expects.
struct NodeGraph {
    std::vector<idx_t> start{0}, neighbours;  // CSR: start per node plus end; adjacent nodes
    int nodes() const { return static_cast<int>(start.size()) - 1; }
};

/// Pattern of the matrix with the three directions of a node merged.
NodeGraph node_graph(const SymmetricSparse& lower) {
    const int nodes = static_cast<int>(lower.cols()) / 3;
    std::vector<std::vector<idx_t>> neighbours(static_cast<std::size_t>(nodes));
    for (int j = 0; j < nodes; ++j)
        for (SymmetricSparse::InnerIterator entry(lower, 3 * j); entry; ++entry) {
            const int i = static_cast<int>(entry.row()) / 3;
            if (i == j || (!neighbours[static_cast<std::size_t>(j)].empty() &&
                           neighbours[static_cast<std::size_t>(j)].back() == i))
                continue;
            neighbours[static_cast<std::size_t>(j)].push_back(i);
        }
    // Mirrors the lower triangle. Its entries were added first, so `below` separates them from the mirrored ones.
    std::vector<std::size_t> below(neighbours.size());
    for (std::size_t j = 0; j < neighbours.size(); ++j) below[j] = neighbours[j].size();
    for (std::size_t j = 0; j < neighbours.size(); ++j)
        for (std::size_t k = 0; k < below[j]; ++k)
            neighbours[static_cast<std::size_t>(neighbours[j][k])].push_back(static_cast<idx_t>(j));
    NodeGraph graph;
    for (const std::vector<idx_t>& list : neighbours) {
        graph.neighbours.insert(graph.neighbours.end(), list.begin(), list.end());
        graph.start.push_back(static_cast<idx_t>(graph.neighbours.size()));
    }
    return graph;
}

/// Partition of the nodes by METIS. The fixed seed makes the parts independent of earlier calls.
std::vector<std::vector<int>> cut(NodeGraph& graph, int part_count) {
    std::vector<idx_t> part(static_cast<std::size_t>(graph.nodes()), 0);
    if (part_count > 1) {
        idx_t options[METIS_NOPTIONS];
        METIS_SetDefaultOptions(options);
        options[METIS_OPTION_SEED] = 1;
        idx_t nodes = graph.nodes(), constraints = 1, parts = part_count, edges_cut = 0;
        const std::lock_guard<std::mutex> lock(cholmod_mutex());
        METIS_PartGraphKway(&nodes, &constraints, graph.start.data(), graph.neighbours.data(), nullptr, nullptr,
                            nullptr, &parts, nullptr, nullptr, options, &edges_cut, part.data());
    }
    std::vector<std::vector<int>> members(static_cast<std::size_t>(part_count));
    for (int i = 0; i < graph.nodes(); ++i)
        members[static_cast<std::size_t>(part[static_cast<std::size_t>(i)])].push_back(i);
    return members;
}

/// Nodes of the part plus overlap_layers layers of neighbours (breadth-first), ascending.
std::vector<int> with_overlap(const NodeGraph& graph, const std::vector<int>& nodes) {
    std::vector<char> inside(static_cast<std::size_t>(graph.nodes()), 0);
    std::vector<int> all = nodes;
    for (const int i : nodes) inside[static_cast<std::size_t>(i)] = 1;
    std::size_t first = 0;
    for (int layer = 0; layer < schwarz_policy.overlap_layers; ++layer) {
        const std::size_t end = all.size();
        for (; first < end; ++first)
            for (idx_t k = graph.start[static_cast<std::size_t>(all[first])];
                 k < graph.start[static_cast<std::size_t>(all[first]) + 1]; ++k)
                if (const auto j = static_cast<std::size_t>(graph.neighbours[static_cast<std::size_t>(k)]);
                    !inside[j]) {
                    inside[j] = 1;
                    all.push_back(static_cast<int>(j));
                }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Lower triangle of R A R' for the restriction R to the given unknowns, in their order.
SymmetricSparse submatrix(const SymmetricSparse& lower, const std::vector<int>& unknowns) {
    std::vector<int> place(static_cast<std::size_t>(lower.cols()), -1);
    for (std::size_t k = 0; k < unknowns.size(); ++k)
        place[static_cast<std::size_t>(unknowns[k])] = static_cast<int>(k);
    SymmetricSparse part(static_cast<Eigen::Index>(unknowns.size()), static_cast<Eigen::Index>(unknowns.size()));
    std::vector<int> counts;
    for (const int j : unknowns) counts.push_back(lower.outerIndexPtr()[j + 1] - lower.outerIndexPtr()[j]);
    part.reserve(counts);
    // Unknowns are ascending, so the lower triangle maps into the lower triangle.
    for (std::size_t k = 0; k < unknowns.size(); ++k)
        for (SymmetricSparse::InnerIterator entry(lower, unknowns[k]); entry; ++entry)
            if (const int row = place[static_cast<std::size_t>(entry.row())]; row >= 0)
                part.insert(row, static_cast<int>(k)) = entry.value();
    part.makeCompressed();
    return part;
}

}  // namespace

bool SchwarzPreconditioner::factorize(const SymmetricSparse& lower, const MatrixXd& smooth) {
    assert(lower.isCompressed() && lower.cols() % 3 == 0 && smooth.rows() == lower.cols());
    const bool known = !parts_.empty() &&
                       std::equal(starts_.begin(), starts_.end(), lower.outerIndexPtr(),
                                  lower.outerIndexPtr() + lower.cols() + 1) &&
                       std::equal(rows_.begin(), rows_.end(), lower.innerIndexPtr(),
                                  lower.innerIndexPtr() + lower.nonZeros());
    if (!known) {
        starts_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
        rows_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
        parts_.clear();
        NodeGraph graph = node_graph(lower);
        for (const std::vector<int>& members :
             cut(graph, std::max(1, static_cast<int>(lower.cols()) / schwarz_policy.unknowns_per_part))) {
            Part part;
            for (const int node : with_overlap(graph, members))
                for (int r = 0; r < 3; ++r) part.unknowns.push_back(3 * node + r);
            parts_.push_back(std::move(part));
        }
    }
    // Partition of unity: an unknown in several parts gets equal weights, so the shares add up to the whole motion.
    Eigen::VectorXd holders = Eigen::VectorXd::Zero(lower.cols());
    for (const Part& part : parts_)
        for (const int i : part.unknowns) holders(i) += 1.0;
    // Parts are independent. Concurrent writes agree, because `definite` only changes to false.
    std::atomic<bool> definite = true;
    parallel_ranges(static_cast<int>(parts_.size()), 1, [&](int first, int end) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
            Part& part = parts_[k];
            part.share = smooth(part.unknowns, Eigen::all);
            part.share.array().colwise() /= Eigen::ArrayXd(holders(part.unknowns));
            if (!part.factor.factorize(submatrix(lower, part.unknowns))) definite = false;
        }
    });
    if (definite && factorize_coarse(lower)) return true;
    parts_.clear();
    return false;
}

bool SchwarzPreconditioner::factorize_coarse(const SymmetricSparse& lower) {
    // A Z is formed part by part, because Z for all parts at once would be a dense n x (parts m) matrix.
    const Eigen::Index modes = parts_.front().share.cols(), size = modes * static_cast<Eigen::Index>(parts_.size());
    MatrixXd coarse(size, size);
    parallel_ranges(static_cast<int>(parts_.size()), 1, [&](int first, int end) {
        for (int k = first; k < end; ++k) {
            MatrixXd Z = MatrixXd::Zero(lower.cols(), modes);
            Z(parts_[static_cast<std::size_t>(k)].unknowns, Eigen::all) = parts_[static_cast<std::size_t>(k)].share;
            const MatrixXd AZ = symmetric_product(lower, Z);
            for (std::size_t i = 0; i < parts_.size(); ++i)
                coarse.block(static_cast<Eigen::Index>(i) * modes, k * modes, modes,
                             modes) = parts_[i].share.transpose() * AZ(parts_[i].unknowns, Eigen::all);
        }
    });
    coarse_.compute(coarse);
    return coarse_.info() == Eigen::Success && coarse_.isPositive();
}

MatrixXd SchwarzPreconditioner::solve(const Eigen::Ref<const MatrixXd>& B) const {
    assert(has_factor());
    const auto count = static_cast<Eigen::Index>(parts_.size()), modes = parts_.front().share.cols();
    MatrixXd coarse(modes * count, B.cols());
    std::vector<MatrixXd> local(parts_.size());
    parallel_ranges(static_cast<int>(count), 1, [&](int first, int end) {
        for (int k = first; k < end; ++k) {
            const Part& part = parts_[static_cast<std::size_t>(k)];
            const MatrixXd b = B(part.unknowns, Eigen::all);
            coarse.middleRows(k * modes, modes) = part.share.transpose() * b;
            local[static_cast<std::size_t>(k)] = part.factor.solve(b);
        }
    });
    coarse = coarse_.solve(coarse).eval();
    // Summation in the order of the parts, independent of the threads that solved them: results are reproducible.
    MatrixXd X = MatrixXd::Zero(B.rows(), B.cols());
    for (Eigen::Index k = 0; k < count; ++k) {
        const Part& part = parts_[static_cast<std::size_t>(k)];
        const MatrixXd x = local[static_cast<std::size_t>(k)] + part.share * coarse.middleRows(k * modes, modes);
        for (Eigen::Index c = 0; c < B.cols(); ++c)
            for (std::size_t i = 0; i < part.unknowns.size(); ++i)
                X(part.unknowns[i], c) += x(static_cast<Eigen::Index>(i), c);
    }
    return X;
}

double SchwarzPreconditioner::factor_entries() const {
    double sum = 0.0;
    for (const Part& part : parts_) sum += part.factor.factor_entries();
    return sum;
}

double SchwarzPreconditioner::factor_flops() const {
    double sum = 0.0;
    for (const Part& part : parts_) sum += part.factor.factor_flops();
    return sum;
}

}  // namespace myo::solver
