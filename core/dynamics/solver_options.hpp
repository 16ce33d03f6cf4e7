#pragma once

#include <string>
#include <vector>

namespace myo::dynamics {

/// Solution method of a stage. All methods share one stopping criterion, so that they can be compared, and fall back to
/// Newton's method if they do not converge.
enum class Strategy {
    automatic,      // lagged Newton; Newton with conjugate gradients if the factor would be too large
    lagged_newton,  // quasi-Newton in the metric of an earlier Hessian
    newton,         // Newton with the pressures as lagged unknowns
    projective,     // quasi-Newton in the metric of projective dynamics, factored once: the method of the paper
};

/// Name of a strategy in files and on the command line.
std::string to_string(Strategy strategy);
/// All strategy names, in the order of the enumeration.
std::vector<std::string> strategy_ids();
/// Sets `strategy` from its name. Returns false for an unknown name.
bool parse_strategy(const std::string& id, Strategy& strategy);

/// Tolerances and limits of the stage solver.
struct SolverOptions {
    Strategy strategy = Strategy::automatic;
    double tolerance = 1e-7;  // relative residual, see StageProblem::force_scale()
    /// Relative residual of the linear solves of sensitivities. The tangents of a run differ from those at 1e-12 by
    /// 5e-8 with this value; at 1e-10 every stage would need its own factor.
    double tangent_tolerance = 1e-8;
    int max_newton_iterations = 40;   // per stage
    double max_factor_entries = 4e8;  // 1.6 GB; larger bodies: subdomain factors and conjugate gradients
};

}  // namespace myo::dynamics
