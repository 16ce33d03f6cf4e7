#include "validation/slip.hpp"

#include <algorithm>
#include <cmath>

namespace myo::validation {
namespace {

/// Conditions of Slip::fits.
bool any_experiment(const SyntheticCase&) { return true; }
bool has_muscles(const SyntheticCase& c) { return !c.muscles.empty(); }
/// Whether the first trial starts in this state.
bool starts(const SyntheticCase& c, experiment::StartState start) { return c.trials.front().start == start; }

/// Deflection of a cantilever under its weight, relative to its length: rho g L^3 / (8 E h^2 / 12).
double sag_share(const SyntheticCase& c) {
    const double length = c.body.length_m(), h = c.body.thickness_m;
    return 1.5 * c.material.density_kg_m3 * c.gravity_m_s2.tail<2>().norm() * std::pow(length, 3) /
           (c.material.youngs_modulus_Pa * h * h);
}

/// Whether the straight and the sagging start differ by much more than the noise.
bool sag_is_seen(const SyntheticCase& c) { return sag_share(c) * c.body.length_m() > 20.0 * c.noise_m; }

/// Clamps only the lower edge of the face, about which the body can rotate.
void hold_on_a_line(SyntheticCase& declared, RandomStream&) {
    const double height = declared.body.bounds.size()(2);
    declared.body.clamp.highest(2) = declared.body.bounds.lowest(2) + 1e-3 * height;
}

/// Declares a modulus outside the tolerance of 30 % that is declared with it.
void declare_another_modulus(SyntheticCase& declared, RandomStream& random) {
    const double factor = random.uniform(1.7, 3.0);
    declared.material.declared_modulus_Pa *= random.chance(0.5) ? factor : 1.0 / factor;
}

/// A validation trial that reuses the recording of the fit trial.
void predict_what_was_fitted(SyntheticCase& declared, RandomStream&) {
    SyntheticTrial again = declared.trials.front();
    again.recorded_as = again.name;
    again.name = "again";
    again.role = experiment::TrialRole::validate;
    declared.trials.push_back(std::move(again));
}

}  // namespace

const std::vector<Slip>& slips() {
    static const std::vector<Slip> all{
        {"modulus_in_MPa",
         {"units"},
         "youngs_modulus_Pa",
         any_experiment,
         [](SyntheticCase& declared, RandomStream&) { declared.material.declared_modulus_Pa *= 1e-6; }},
        {"density_in_g_cm3",
         {"units"},
         "density_kg_m3",
         any_experiment,
         [](SyntheticCase& declared, RandomStream&) { declared.material.density_kg_m3 *= 1e-3; }},
        {"straight_for_sagging",
         {"start"},
         "",
         [](const SyntheticCase& c) { return starts(c, experiment::StartState::equilibrium) && sag_is_seen(c); },
         [](SyntheticCase& declared, RandomStream&) {
             declared.trials.front().start = experiment::StartState::straight;
         }},
        {"sagging_for_straight",
         {"start"},
         "",
         [](const SyntheticCase& c) { return starts(c, experiment::StartState::straight) && sag_is_seen(c); },
         [](SyntheticCase& declared, RandomStream&) {
             declared.trials.front().start = experiment::StartState::equilibrium;
         }},
        {"held_on_a_line",
         {"support"},
         "clamp",
         [](const SyntheticCase& c) { return c.body.family != BodyFamily::tail; },
         hold_on_a_line},
        {"modulus_beyond_tolerance", {"bounds"}, "", any_experiment, declare_another_modulus},
        {"fit_trial_predicted", {"recordings"}, "", any_experiment, predict_what_was_fitted},
        {"trace_in_another_clock",
         {},
         "start_s",
         any_experiment,
         [](SyntheticCase& declared, RandomStream& random) {
             declared.trials.front().clock_s = std::round(random.log_uniform(100.0, 1e5));
         }},
        {"signals_in_ms",
         {"signals"},
         "actuation",
         has_muscles,
         [](SyntheticCase& declared, RandomStream&) { declared.trials.front().signal_unit_s = 1e-3; }},
    };
    return all;
}

const Slip* find_slip(const std::string& id) {
    const auto found = std::find_if(slips().begin(), slips().end(), [&](const Slip& slip) { return slip.id == id; });
    return found != slips().end() ? &*found : nullptr;
}

}  // namespace myo::validation
