#include "reproduce/pressure_map.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace myo::reproduce {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index highest_degree = 4;  // as the paper's curves

/// Vandermonde matrix of pressures in bar, from power `first`; bar keeps its entries near 1.
MatrixXd powers(const std::vector<double>& pressures_mbar, Index first, Index count) {
    // One row per pressure.
    MatrixXd A(static_cast<Index>(pressures_mbar.size()), count);
    for (Index i = 0; i < A.rows(); ++i)
        for (Index k = 0; k < count; ++k)
            A(i, k) = std::pow(1e-3 * pressures_mbar[static_cast<std::size_t>(i)], static_cast<double>(first + k));
    return A;
}

}  // namespace

VectorXd PressureMap::at(double pressure_mbar) const {
    return coefficients * powers({pressure_mbar}, 0, coefficients.cols()).transpose();
}

PressureMap polynomial_map(const std::vector<double>& pressures_mbar, const MatrixXd& signals) {
    assert(!pressures_mbar.empty() && signals.cols() == static_cast<Index>(pressures_mbar.size()));
    // At most as many coefficients as pressures: the curve passes through up to five of them.
    const MatrixXd A = powers(pressures_mbar, 0, std::min(highest_degree + 1, signals.cols()));
    return {A.colPivHouseholderQr().solve(signals.transpose()).transpose()};
}

PressureMap map_from_rest(const std::vector<double>& pressures_mbar, const MatrixXd& signals,
                          const std::vector<double>& displacements_m) {
    assert(!pressures_mbar.empty() && signals.cols() == static_cast<Index>(pressures_mbar.size()) &&
           displacements_m.size() == pressures_mbar.size());
    // Weights of the inverse displacement turn absolute errors into relative ones.
    const VectorXd weights = Eigen::Map<const VectorXd>(displacements_m.data(), signals.cols()).cwiseInverse();
    // Power 0 is left out: its coefficient is 1.
    const MatrixXd A = weights.asDiagonal() * powers(pressures_mbar, 1, std::min(highest_degree, signals.cols()));
    const MatrixXd b = weights.asDiagonal() * (signals.transpose().array() - 1.0).matrix();
    PressureMap map;
    map.coefficients.setOnes(signals.rows(), A.cols() + 1);
    map.coefficients.rightCols(A.cols()) = A.colPivHouseholderQr().solve(b).transpose();
    return map;
}

}  // namespace myo::reproduce
