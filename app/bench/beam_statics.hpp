#pragma once

#include <Eigen/Core>

#include <array>

#include "base/result.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_case.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// Gravity at the place where the paper's beam was measured [m/s2].
inline constexpr double beam_gravity_m_s2 = 9.80709;

/// Mesh-independent deflection of the lower edge of the tip of bench_beam() under gravity.
struct ConvergedBeam {
    double poissons_ratio = 0.0;
    double dz_mm = 0.0;  // along z
};
/// Source at nu = 0.499: a quadratic element with linear pressures (-6.745 at 91 thousand unknowns) puts it at -6.755
/// +- 0.01. At the others: `myoloop bench converged`, where hex8 extrapolates to it (at 0.499 to -6.759) and tet10 is
/// within 0.2 % on its last mesh.
inline constexpr std::array<ConvergedBeam, 3> converged_beam{{{0.3, -7.000}, {0.49, -6.775}, {0.499, -6.755}}};

/// bench_beam() with beam_gravity_m_s2 and this Poisson's ratio.
model::Model static_beam(const BenchBeam& beam, double poissons_ratio);

/// Static equilibrium under the loads of the model, by Newton's method from the rest shape.
///
/// @return   node positions, 3 x n [m]
/// Errors: no equilibrium was found.
Result<Eigen::Matrix3Xd> beam_equilibrium(const model::Model& model);

/// Mean displacement [m] of the nodes on the lower edge of the tip, at the highest x. The end face rotates, so its
/// upper edge sinks 0.1 mm more under gravity.
///
/// @param x  node positions, 3 x n [m]
Eigen::Vector3d tip_displacement(const model::Model& model, const Eigen::Matrix3Xd& x);

/// dz of tip_displacement() [mm] in equilibrium; adds the time to `figures` and sets the size of the mesh there, also
/// if no equilibrium is found, which is the error.
Result<double> measured_tip_dz_mm(const model::Model& model, BenchFigures& figures);

}  // namespace myo::bench
