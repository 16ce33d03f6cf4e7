#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

#include "solver/fast_cholesky.hpp"

namespace myo::solver {

/// Two-level overlapping Schwarz preconditioner, for matrices whose Cholesky factor would not fit in memory.
///
/// The nodes are divided into overlapping parts with one factor each. A coarse problem transports information across
/// parts:
///
///   M^-1 = Z (Z'AZ)^-1 Z' + sum_i R_i' (R_i A R_i')^-1 R_i,
///
/// R_i restricts to the unknowns of part i and its overlap. Z holds, part by part, the given smooth motions weighted by
/// a partition of unity.
/// Source: Toselli & Widlund 2005, ch. 3; Dohrmann & Widlund 2009 (overlap for nearly incompressible bodies).
class SchwarzPreconditioner {
public:
    /// Partitions the nodes if the pattern is new, then factorises all parts and the coarse matrix.
    ///
    /// @param lower   lower triangle, 3 unknowns per node in sequence
    /// @param smooth  coarse modes, n x m: motions of almost zero energy (translations, rotations, uniform strains)
    /// @return        false if a part or the coarse matrix is not positive definite
    bool factorize(const SymmetricSparse& lower, const Eigen::MatrixXd& smooth);

    bool has_factor() const { return !parts_.empty(); }

    /// Preconditioned vectors M^-1 B, n x k. Asserts has_factor(). Independent of the number of threads.
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const;

    /// Sum over the parts of the stored entries of their factors.
    double factor_entries() const;
    /// Sum over the parts of the floating-point operations of their factorisations.
    double factor_flops() const;

private:
    struct Part {
        std::vector<int> unknowns;  // unknowns of the part with its overlap, ascending
        Eigen::MatrixXd share;      // unknowns x m: weighted rows of the smooth motions
        FastCholesky factor;
    };
    /// Z'AZ and its LDL' factor. False if it is not positive definite.
    bool factorize_coarse(const SymmetricSparse& lower);

    std::vector<Part> parts_;
    std::vector<int> starts_, rows_;       // pattern of the partitioned matrix
    Eigen::LDLT<Eigen::MatrixXd> coarse_;  // factor of Z'AZ, dense, parts * m
};

}  // namespace myo::solver
