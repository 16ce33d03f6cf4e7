#include "model/mass_matrix.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "model/model.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;

/// Mean cell volume on the diagonal, for density 1.
Eigen::SparseMatrix<double> equal_vertex_mass(const Body& body) {
    Eigen::SparseMatrix<double> mass(body.node_count(), body.node_count());
    mass.setIdentity();
    mass *= body.volume_m3 / body.cell_count();
    return mass;
}

/// Consistent mass of cells of different densities, in units of Model::density_kg_m3 [m3].
Eigen::SparseMatrix<double> mixed_mass(const Body& body, const std::vector<double>& factors) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (const fem::MassEntry& entry : fem::consistent_mass(body.mesh))
        triplets.emplace_back(entry.row, entry.column, factors[static_cast<std::size_t>(entry.cell)] * entry.value);
    Eigen::SparseMatrix<double> mass(body.node_count(), body.node_count());
    mass.setFromTriplets(triplets.begin(), triplets.end());
    return mass;
}

/// Mass matrix of the body plus attached masses, identical for the three directions.
Eigen::SparseMatrix<double> isotropic_mass(const Model& model) {
    Eigen::SparseMatrix<double> mass = model.mass_model != MassModel::consistent ? equal_vertex_mass(*model.body)
                                       : model.density_factors.empty()           ? model.body->unit_mass
                                                                       : mixed_mass(*model.body, model.density_factors);
    mass *= model.density_kg_m3;
    // Attached masses are lumped on the diagonal.
    for (const AttachedMass& attached : model.masses)
        for (int i = 0; i < model.body->node_count(); ++i)
            if (attached.share(i) != 0.0) mass.coeffRef(i, i) += attached.mass_kg * attached.share(i);
    mass.makeCompressed();
    return mass;
}

/// Sum of the directional masses active at a time; 0 x 0 if there are none.
Eigen::SparseMatrix<double> directional_mass(const Model& model, double at_s) {
    Eigen::SparseMatrix<double> sum(model.body->dofs(), model.body->dofs());
    for (const DirectionalMass& mass : model.directional_masses) {
        assert(mass.inertia_kg.rows() == sum.rows() && mass.inertia_kg.cols() == sum.cols());
        if (mass.active(at_s)) sum += mass.inertia_kg;
    }
    sum.prune(0.0);  // masses of 0 cost nothing
    return sum.nonZeros() > 0 ? sum : Eigen::SparseMatrix<double>();
}

}  // namespace

MassMatrix mass_matrix(const Eigen::SparseMatrix<double>& isotropic, const Eigen::SparseMatrix<double>& directional) {
    return {isotropic, directional, isotropic * Eigen::VectorXd::Ones(isotropic.cols())};
}

MassMatrix mass_matrix(const Model& model, double at_s) {
    return mass_matrix(isotropic_mass(model), directional_mass(model, at_s));
}

// The mass matrix is piecewise constant in time. Spans end at the times at which a directional mass starts or stops.
std::vector<MassSpan> mass_spans(const Model& model) {
    std::vector<double> ends{std::numeric_limits<double>::infinity()};
    for (const DirectionalMass& mass : model.directional_masses)
        // Times before the start of the run do not split it.
        for (const double t : {mass.from_s, mass.until_s})
            if (std::isfinite(t) && t > 0.0) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    // Several masses may start or stop at the same time.
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<MassSpan> spans;
    double from_s = 0.0;
    // The mass at the start of a span holds until its end.
    for (const double until_s : ends) {
        spans.push_back({until_s, mass_matrix(model, from_s)});
        from_s = until_s;
    }
    return spans;
}

std::size_t span_at(const std::vector<MassSpan>& spans, double at_s) {
    std::size_t k = 0;
    while (k + 1 < spans.size() && at_s >= spans[k].until_s) ++k;
    return k;
}

// Node by node instead of row by row: several times faster than Eigen's product of dense rows and a sparse matrix. A
// fourth row makes each nodal vector one SIMD register.
Matrix3Xd times_mass(const Matrix3Xd& X, const MassMatrix& mass) {
    Eigen::Matrix4Xd padded(4, X.cols());
    padded.topRows<3>() = X;
    padded.row(3).setZero();
    Matrix3Xd result(3, mass.isotropic.cols());
    const double* const values = mass.isotropic.valuePtr();
    const int* const rows = mass.isotropic.innerIndexPtr();
    const int* const starts = mass.isotropic.outerIndexPtr();
    const int* const counts = mass.isotropic.innerNonZeroPtr();  // null for a compressed matrix
    parallel_ranges(static_cast<int>(mass.isotropic.outerSize()), 1000, [&](int first, int end) {
        for (int j = first; j < end; ++j) {
            Eigen::Vector4d sum = Eigen::Vector4d::Zero();
            const int last = counts ? starts[j] + counts[j] : starts[j + 1];
            for (int k = starts[j]; k < last; ++k) sum += values[k] * padded.col(rows[k]);
            result.col(j) = sum.head<3>();
        }
    });
    if (mass.has_directional()) add_directional(mass.directional, X, result);
    return result;
}

void add_directional(const Eigen::SparseMatrix<double>& directional, const Eigen::Ref<const Eigen::MatrixXd>& X,
                     Eigen::Ref<Eigen::MatrixXd> result) {
    assert(directional.cols() == 3 * X.cols() && X.rows() == result.rows() && X.cols() == result.cols());
    // The matrix is symmetric, so its columns serve as rows: each node gathers its own sum without conflicts between
    // threads.
    parallel_ranges(static_cast<int>(X.cols()), 1000, [&](int first, int end) {
        for (int j = first; j < end; ++j)
            for (int s = 0; s < 3; ++s)
                for (Eigen::SparseMatrix<double>::InnerIterator entry(directional, 3 * j + s); entry; ++entry)
                    for (Eigen::Index p = 0; p < X.rows(); p += 3)
                        result(p + s, j) += entry.value() * X(p + entry.row() % 3, entry.row() / 3);
    });
}

}  // namespace myo::model
