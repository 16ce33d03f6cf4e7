#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

#include "solver/fast_cholesky.hpp"

namespace myo::solver {

/// Two-level overlapping Schwarz preconditioner for matrices whose factor would not fit: the body is cut into parts
/// that are factored each on its own, and a coarse problem carries what must travel further than a part.
///
///   M^-1 = Z (Z'AZ)^-1 Z' + sum_i R_i' (R_i A R_i')^-1 R_i,
///
/// R_i takes the unknowns of part i and its neighbours, Z holds the parts' shares of given smooth motions.
/// Source: Toselli & Widlund 2005, ch. 3; Dohrmann & Widlund 2009 (overlap for nearly incompressible bodies).
class SchwarzPreconditioner {
public:
    /// `smooth`: n x m motions that cost next to no energy (translations, rotations, uniform strains) at each unknown.
    /// Unknowns come in groups of three, the directions of a node. False when a part is not positive definite.
    bool factorize(const SymmetricSparse& lower, const Eigen::MatrixXd& smooth);

    bool has_factor() const { return !parts_.empty(); }

    /// M^-1 B for B of n x k.
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const;

    double factor_entries() const;
    double factor_flops() const;

private:
    struct Part {
        std::vector<int> unknowns;  // of the part and its overlap, ascending
        Eigen::MatrixXd share;      // unknowns x m: its part of the smooth motions
        FastCholesky factor;
    };
    bool factorize_coarse(const SymmetricSparse& lower);

    std::vector<Part> parts_;
    std::vector<int> starts_, rows_;  // of the matrix that was cut
    Eigen::LDLT<Eigen::MatrixXd> coarse_;
};

}  // namespace myo::solver
