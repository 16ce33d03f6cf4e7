#pragma once

#include <string>
#include <vector>

namespace myo::dynamics {

/// How a stage is solved. All stop on the same residual, so that they compare, and all fall back on Newton where they
/// do not converge.
enum class Strategy {
    automatic,      // lagged Newton; Newton with conjugate gradients where the factor would be too large
    lagged_newton,  // quasi-Newton in the metric of an earlier Hessian
    newton,         // Newton with the pressures as lagged unknowns
    projective,     // quasi-Newton in the metric of projective dynamics, factored once: the paper's
};

std::string to_string(Strategy strategy);
std::vector<std::string> strategy_ids();
/// False when there is no strategy of this name.
bool parse_strategy(const std::string& id, Strategy& strategy);

struct SolverOptions {
    Strategy strategy = Strategy::automatic;
    double tolerance = 1e-7;  // residual over the forces on the body
    /// Relative residual of the linear solves of sensitivities. Tangents of a run differ from those at 1e-12 by 5e-8
    /// here, and at 1e-10 every stage would need a factor of its own.
    double tangent_tolerance = 1e-8;
    int max_newton_iterations = 40;
    double most_factor_entries = 4e8;  // 1.6 GB; larger bodies are factored in parts and solved by conjugate gradients
};

}  // namespace myo::dynamics
