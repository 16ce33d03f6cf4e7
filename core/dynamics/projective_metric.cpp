#include "dynamics/projective_metric.hpp"

#include <cmath>
#include <vector>

namespace myo::dynamics {
namespace {

/// Integral over the cell of the product of two nodes' shape gradients: an entry of the cell's Laplacian. `lane`: index
/// of the cell in its SIMD pack.
template <int N, int Q>
double gradient_product(const model::PackGeometry<N, Q>& geometry, std::size_t lane, int a, int b) {
    double sum = 0.0;
    for (std::size_t q = 0; q < Q; ++q)
        for (int j = 0; j < 3; ++j)
            sum += static_cast<double>(geometry.weight[q][lane]) *
                   static_cast<double>(geometry.gradient[q](a, j)[lane]) *
                   static_cast<double>(geometry.gradient[q](b, j)[lane]);
    return sum;
}

/// The same for assumed-strain cells. The mean gradient has four zero-energy modes (hourglass modes); they get a
/// stiffness of the same size.
double gradient_product(const model::PackAssumedStrain& geometry, std::size_t lane, int a, int b) {
    double sum = 0.0, half_edge_squared = 0.0;
    for (int j = 0; j < 3; ++j) {
        sum += static_cast<double>(geometry.gradient(a, j)[lane]) * static_cast<double>(geometry.gradient(b, j)[lane]);
        half_edge_squared += std::pow(static_cast<double>(geometry.edges(j, 0)[lane]), 2);
    }
    for (int s = 0; s < 4; ++s)
        sum += static_cast<double>(geometry.gamma(a, s)[lane]) * static_cast<double>(geometry.gamma(b, s)[lane]) /
               half_edge_squared;
    return static_cast<double>(geometry.volume[lane]) * sum;
}

/// Adds the Laplacian of a block of cells, weighted with 2 mu + lambda of each cell.
template <class Geometry>
void add_laplacian(const model::PackedCells<Geometry>& cells, const model::Model& model,
                   std::vector<Eigen::Triplet<double>>& entries) {
    const std::vector<int>& free = model.body->pattern.free_index;
    for (int cell = 0; cell < cells.cell_count; ++cell) {
        const auto pack = static_cast<std::size_t>(cell / pack_width),
                   lane = static_cast<std::size_t>(cell % pack_width);
        const material::Moduli& m = model.moduli[static_cast<std::size_t>(cell)];
        // 2 mu + lambda with lambda = kappa - 2/3 mu.
        const double stiffness = 2.0 * m.mu + (m.kappa - 2.0 / 3.0 * m.mu);
        const auto node = [&](int a) {
            return free[static_cast<std::size_t>(cells.lane_nodes[pack][static_cast<std::size_t>(a)][lane])];
        };
        for (int b = 0; b < Geometry::nodes; ++b)
            for (int a = 0; a < Geometry::nodes; ++a)
                if (node(a) >= 0 && node(b) >= 0 && node(a) >= node(b))
                    entries.emplace_back(
                        node(a), node(b),
                        stiffness * gradient_product(cells.geometry(static_cast<int>(pack)), lane, a, b));
    }
}

}  // namespace

bool ProjectiveMetric::prepare(const StageProblem& problem, StageReport& report) {
    // One scalar matrix serves the three axes, so that it cannot hold a node along one of them only.
    if (!problem.pattern().held_unknowns.empty()) return false;
    const double inertia = problem.stage().inertia_1_s2;
    const model::MassSpan& span = problem.mass_span();
    if (factor_.has_factor() && inertia == inertia_1_s2_ && span.until_s == until_s_) return true;
    const model::Model& model = problem.model();
    const std::vector<int>& free = model.body->pattern.free_index;
    std::vector<Eigen::Triplet<double>> entries;
    std::visit([&](const auto& cells) { add_laplacian(cells, model, entries); }, model.body->cells);
    const auto add_mass = [&](Eigen::Index row, Eigen::Index column, double mass) {
        const int i = free[static_cast<std::size_t>(row)], j = free[static_cast<std::size_t>(column)];
        if (j >= 0 && i >= j) entries.emplace_back(i, j, inertia * mass);
    };
    const model::MassMatrix& mass = span.mass;
    for (int column = 0; column < mass.isotropic.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.isotropic, column); entry; ++entry)
            add_mass(entry.row(), column, entry.value());
    // The matrix is scalar, so directional masses contribute the trace of their 3 x 3 blocks, an upper bound of the
    // mass N N n n' along any direction n.
    for (int column = 0; column < mass.directional.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.directional, column); entry; ++entry)
            if (entry.row() % 3 == column % 3) add_mass(entry.row() / 3, column / 3, entry.value());
    solver::SymmetricSparse matrix(model.body->pattern.free_count, model.body->pattern.free_count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    inertia_1_s2_ = inertia;
    until_s_ = span.until_s;
    ++report.factorisations;
    return factor_.factorize(matrix);
}

Eigen::VectorXd ProjectiveMetric::solve(const Eigen::VectorXd& b) const {
    // The three coordinates are three right-hand sides of the scalar matrix.
    const Eigen::Index nodes = b.size() / 3;
    const Eigen::MatrixXd rows = Eigen::Map<const Eigen::MatrixXd>(b.data(), 3, nodes).transpose();
    const Eigen::MatrixXd solution = factor_.solve(rows).transpose();
    return Eigen::Map<const Eigen::VectorXd>(solution.data(), solution.size());
}

}  // namespace myo::dynamics
