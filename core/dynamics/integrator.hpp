#pragma once

#include <string>
#include <vector>

#include "dynamics/bdf2.hpp"
#include "dynamics/generalized_alpha.hpp"
#include "dynamics/implicit_euler.hpp"
#include "dynamics/kinematics.hpp"
#include "dynamics/tr_bdf2.hpp"
#include "dynamics/trapezoidal.hpp"

namespace myo::dynamics {

/// Time integrators of a run. Each is one header of this module.
enum class Integrator { tr_bdf2, implicit_euler, bdf2, trapezoidal, generalized_alpha };

/// Name of an integrator in files and on the command line.
std::string to_string(Integrator integrator);
/// All integrator names, in the order of the enumeration.
std::vector<std::string> integrator_ids();
/// Sets `integrator` from its name. Returns false for an unknown name.
bool parse_integrator(const std::string& id, Integrator& integrator);

/// An integrator with its parameter. Converts implicitly from an Integrator, as most have no parameter.
struct TimeScheme {
    Integrator integrator = Integrator::tr_bdf2;
    double rho_inf = 0.5;  // spectral radius at infinity, generalized_alpha only, 0 ... 1

    TimeScheme() = default;
    TimeScheme(Integrator which, double spectral_radius_at_infinity = 0.5)
        : integrator(which), rho_inf(spectral_radius_at_infinity) {}
    friend bool operator==(const TimeScheme&, const TimeScheme&) = default;
};

/// One step of the scheme from `start` to `next`, with one or two stage solves.
///
/// @return  false if a stage solve failed; `next` is then invalid
template <class Solve>
bool take_step(const TimeScheme& scheme, const StepProblem<Solve>& p, const Kinematics& start, Kinematics& next) {
    switch (scheme.integrator) {
        case Integrator::tr_bdf2: return tr_bdf2_step(p, start, next);
        case Integrator::implicit_euler: return implicit_euler_step(p, start, next);
        case Integrator::bdf2: return single_stage_step(p, bdf2_formula(p.h, start.step_before_s), start, next);
        case Integrator::trapezoidal: return single_stage_step(p, trapezoidal_formula(p.h), start, next);
        case Integrator::generalized_alpha:
            return single_stage_step(p, generalized_alpha_formula(p.h, scheme.rho_inf), start, next);
    }
    return false;
}

}  // namespace myo::dynamics
