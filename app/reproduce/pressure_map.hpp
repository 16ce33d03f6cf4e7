#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::reproduce {

/// Signals over pressure: a polynomial for each.
struct PressureMap {
    Eigen::MatrixXd coefficients;  // signals x powers of the pressure in bar, from power 0

    Eigen::VectorXd at(double pressure_mbar) const;
};

/// The paper's: of degree 4 by least squares; of less where there are fewer than five pressures.
///
/// @param signals  signals x pressures
PressureMap polynomial_map(const std::vector<double>& pressures_mbar, const Eigen::MatrixXd& signals);

/// The same with all signals at 1, where nothing moves, without pressure, and with weights: a share of a small
/// displacement is to count as much as the same share of a large one.
///
/// @param displacements_m  lengths, one per pressure
PressureMap map_from_rest(const std::vector<double>& pressures_mbar, const Eigen::MatrixXd& signals,
                          const std::vector<double>& displacements_m);

}  // namespace myo::reproduce
