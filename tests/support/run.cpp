#include "support/run.hpp"

#include <algorithm>

namespace myo::test {

dynamics::Trace run(const model::Model& model, const dynamics::TimeScheme& scheme, double h, double end) {
    dynamics::SimulationOptions options;
    options.integrator = scheme;
    options.h_s = h;
    options.end_s = end;
    options.solver.tolerance = 1e-9;
    dynamics::Trace trace = dynamics::simulate(model, options);
    // A test that compares motions must not compare incomplete ones.
    EXPECT_TRUE(trace.complete()) << to_string(scheme.integrator) << ": " << trace.message;
    return trace;
}

dynamics::SimulationOptions short_steps(dynamics::StartKind start, double h, double end) {
    dynamics::SimulationOptions options;
    options.start = start;
    options.h_s = h;
    options.end_s = end;
    options.solver.tolerance = 1e-10;
    return options;
}

double relative_difference(const dynamics::Trace& a, const dynamics::Trace& b) {
    // Relative to the motion, not to the positions, whose size depends on the origin.
    double largest = 0.0, motion = 0.0;
    for (std::size_t k = 0; k < a.positions.size(); ++k) {
        largest = std::max(largest, (a.positions[k] - b.positions[k]).cwiseAbs().maxCoeff());
        motion = std::max(motion, (a.positions[k] - a.positions[0]).cwiseAbs().maxCoeff());
    }
    return largest / motion;
}

std::vector<NamedScheme> all_schemes() {
    // Generalised-alpha appears twice: its spectral radius changes the scheme.
    return {{"tr_bdf2", dynamics::Integrator::tr_bdf2},
            {"implicit_euler", dynamics::Integrator::implicit_euler},
            {"bdf2", dynamics::Integrator::bdf2},
            {"trapezoidal", dynamics::Integrator::trapezoidal},
            {"generalized_alpha", dynamics::Integrator::generalized_alpha},
            {"generalized_alpha_09", {dynamics::Integrator::generalized_alpha, 0.9}}};
}

}  // namespace myo::test
