#include "support/run.hpp"

#include <algorithm>

namespace myo::test {

Trace run(const Model& model, const TimeScheme& scheme, double h, double end) {
    SimulationOptions options;
    options.integrator = scheme;
    options.h_s = h;
    options.end_s = end;
    options.solver.tolerance = 1e-9;
    Trace trace = simulate(model, options);
    EXPECT_TRUE(trace.complete()) << to_string(scheme.integrator) << ": " << trace.message;
    return trace;
}

SimulationOptions short_steps(StartKind start, double h, double end) {
    SimulationOptions options;
    options.start = start;
    options.h_s = h;
    options.end_s = end;
    options.solver.tolerance = 1e-10;
    return options;
}

double relative_difference(const Trace& a, const Trace& b) {
    double largest = 0.0, motion = 0.0;
    for (std::size_t k = 0; k < a.positions.size(); ++k) {
        largest = std::max(largest, (a.positions[k] - b.positions[k]).cwiseAbs().maxCoeff());
        motion = std::max(motion, (a.positions[k] - a.positions[0]).cwiseAbs().maxCoeff());
    }
    return largest / motion;
}

std::vector<NamedScheme> all_schemes() {
    return {{"tr_bdf2", Integrator::tr_bdf2},
            {"implicit_euler", Integrator::implicit_euler},
            {"bdf2", Integrator::bdf2},
            {"trapezoidal", Integrator::trapezoidal},
            {"generalized_alpha", Integrator::generalized_alpha},
            {"generalized_alpha_09", {Integrator::generalized_alpha, 0.9}}};
}

}  // namespace myo::test
