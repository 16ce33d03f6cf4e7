#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::reproduce {

/// Muscle signals as polynomials of the pressure.
struct PressureMap {
    Eigen::MatrixXd coefficients;  // signals x powers of the pressure in bar, from power 0

    /// Signals at a pressure [-]; not limited to the bounds of a signal.
    Eigen::VectorXd at(double pressure_mbar) const;
};

/// The paper's map: least squares of degree 4, of lower degree for fewer than five pressures.
///
/// @param pressures_mbar  not empty (asserted); no order is required
/// @param signals         signals x pressures
PressureMap polynomial_map(const std::vector<double>& pressures_mbar, const Eigen::MatrixXd& signals);

/// Least squares as in polynomial_map(), but with all signals equal to 1 (no motion) at zero pressure, and weighted:
/// equal relative errors of small and large displacements count equally.
///
/// @param displacements_m  norms, one per pressure, > 0
PressureMap map_from_rest(const std::vector<double>& pressures_mbar, const Eigen::MatrixXd& signals,
                          const std::vector<double>& displacements_m);

}  // namespace myo::reproduce
