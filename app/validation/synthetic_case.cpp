#include "validation/synthetic_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mesh/surface_mesh.hpp"
#include "validation/synthetic_effects.hpp"

namespace myo::validation {
namespace {

using Eigen::Vector3d;

/// Modulus from a drawn deflection under the own weight: clearly visible, but within the range of the model.
SyntheticMaterial drawn_material(const SyntheticBody& body, bool known_damping, RandomStream& random) {
    SyntheticMaterial material;
    material.density_kg_m3 = std::round(random.uniform(1000.0, 1200.0));
    material.poissons_ratio = 0.005 * std::round(random.uniform(0.45, 0.495) / 0.005);
    const double sag = random.uniform(0.035, 0.11), length = body.length_m() - body.held_m;
    // Deflection of a cantilever under its weight, rho g L^4 / (8 E h^2 / 12); the second leg of the L hangs at the
    // end.
    const double heavier = body.family == BodyFamily::ell ? 2.0 : 1.0;
    material.youngs_modulus_Pa = heavier * 1.5 * material.density_kg_m3 * gravity_m_s2 * std::pow(length, 3) /
                                 (body.thickness_m * body.thickness_m * sag);
    material.declared_modulus_Pa = std::round(material.youngs_modulus_Pa * random.uniform(0.87, 1.15) / 1e3) * 1e3;
    material.damping_s = random.log_uniform(1.5e-3, 6e-3);
    material.damping_is_known = known_damping;
    return material;
}

/// Two antagonists, above and below or left and right of the middle.
std::vector<SyntheticMuscle> drawn_muscles(const SyntheticBody& body, const SyntheticMaterial& material,
                                           RandomStream& random) {
    const Eigen::Index axis = random.chance(0.5) ? 1 : 2;
    const Vector3d middle = 0.5 * (body.bounds.lowest + body.bounds.highest);
    Box box{body.bounds.lowest - Vector3d::Constant(1e-3), body.bounds.highest + Vector3d::Constant(1e-3)};
    const double length = body.length_m() - body.held_m;
    box.lowest(0) = body.held_m + random.uniform(0.05, 0.15) * length;
    box.highest(0) = body.held_m + random.uniform(0.65, 0.85) * length;
    SyntheticMuscle low{"low", box, std::round(random.uniform(0.2, 0.4) * material.youngs_modulus_Pa)}, high = low;
    high.name = "high";
    low.box.highest(axis) = middle(axis);
    high.box.lowest(axis) = middle(axis);
    return {low, high};
}

/// A thread above the middle of the body, bent at every guide so that friction matters, whose largest tension lifts the
/// end by a tenth to a fifth of the free length.
SyntheticTendon drawn_tendon(const SyntheticBody& body, const SyntheticMaterial& material, RandomStream& random) {
    constexpr int guides = 5;
    constexpr double above_middle = 0.25, wave = 0.15, last = 0.95;  // of the thickness, twice; of the length
    SyntheticTendon tendon{"thread", Eigen::Matrix3Xd(3, guides)};
    const Vector3d size = body.bounds.size(), middle = body.bounds.lowest + 0.5 * size;
    for (Eigen::Index i = 0; i < guides; ++i)
        tendon.path_m.col(i) = Vector3d(last * size.x() * static_cast<double>(i) / (guides - 1), middle.y(),
                                        middle.z() + (above_middle + (i % 2 == 0 ? wave : -wave)) * size.z());
    // A constant moment T e bends a beam by T e L^2 / (2 E I) at its end.
    const double length = body.length_m() - body.held_m, inertia = size.y() * std::pow(size.z(), 3) / 12.0;
    tendon.largest_tension_N = 1e-3 * std::round(1e3 * 2.0 * random.uniform(0.1, 0.2) * material.youngs_modulus_Pa *
                                                 inertia / (length * above_middle * size.z()));
    return tendon;
}

/// Times in whole ms, activations to four decimals, as files store them.
fibre::Signal rounded(fibre::Signal signal) {
    for (double& t : signal.times_s) t = 1e-3 * std::round(1e3 * t);
    for (double& a : signal.values) a = 1e-4 * std::round(1e4 * a);
    return signal;
}

/// Fast contraction, hold, release.
fibre::Signal drawn_step(double depth, double end_s, RandomStream& random) {
    const double on = random.uniform(0.05, 0.15) * end_s, off = random.uniform(0.55, 0.7) * end_s,
                 rise = random.uniform(0.01, 0.04);
    return rounded({{0.0, on, on + rise, off, off + rise, end_s}, {1.0, 1.0, 1.0 - depth, 1.0 - depth, 1.0, 1.0}});
}

/// Two or three contractions of different depth.
fibre::Signal drawn_sweep(double depth, double end_s, RandomStream& random) {
    fibre::Signal signal{{0.0}, {1.0}};
    const int waves = 2 + random.below(2);
    for (int i = 0; i < waves; ++i) {
        const double begin = end_s * i / waves, wave = end_s / waves, part = random.uniform(0.5, 1.0);
        signal.times_s.insert(signal.times_s.end(), {begin + 0.45 * wave, begin + 0.95 * wave});
        signal.values.insert(signal.values.end(), {1.0 - part * depth, 1.0});
    }
    return rounded(signal);
}

/// Builds the trials of one case.
class TrialMaker {
public:
    TrialMaker(const SyntheticCase& c, RandomStream& random) : case_(c), random_(random) {
        weight_N_ = c.material.density_kg_m3 * gravity_m_s2 * mesh::enclosed_volume(c.body.surface);
    }

    SyntheticTrial release() { return begun("release", experiment::StartState::straight); }
    SyntheticTrial weight() {
        SyntheticTrial trial = begun("weight", experiment::StartState::straight);
        trial.loads.push_back(load(experiment::LoadKind::mass));
        trial.loads.back().mass_kg = 1e-4 * std::round(1e4 * random_.uniform(0.12, 0.4) * weight_N_ / gravity_m_s2);
        return trial;
    }
    SyntheticTrial pull() {
        SyntheticTrial trial = begun("pull", experiment::StartState::equilibrium);
        trial.loads.push_back(load(experiment::LoadKind::force));
        const double up = random_.uniform(-0.1, 0.3), sign = random_.sign(), sideways = random_.uniform(0.2, 0.5);
        trial.loads.back().force_N = rounded_force(Vector3d(0.0, sign * sideways, up));
        trial.loads.back().until_s = 0.0;
        return trial;
    }
    SyntheticTrial thread() {
        SyntheticTrial trial = begun("thread", experiment::StartState::straight);
        trial.loads.push_back(load(experiment::LoadKind::force));
        const double down = random_.uniform(0.15, 0.4), sideways = random_.uniform(-0.1, 0.1);
        trial.loads.back().force_N = rounded_force(Vector3d(0.0, sideways, -down));
        return trial;
    }
    /// One muscle steps or sweeps, the other stays passive.
    SyntheticTrial step() { return moved("step", drawn_step); }
    SyntheticTrial sweep() { return moved("sweep", drawn_sweep); }
    /// The tendon pulls in a step or in sweeps.
    SyntheticTrial pulled_step() { return pulled("step", drawn_step); }
    SyntheticTrial pulled_sweep() { return pulled("sweep", drawn_sweep); }

private:
    SyntheticTrial begun(const std::string& name, experiment::StartState start) {
        SyntheticTrial trial;
        trial.name = name;
        trial.start = start;
        trial.end_s = 0.1 * std::round(10.0 * random_.uniform(0.9, 1.3));
        return trial;
    }
    SyntheticTrial moved(const std::string& name, fibre::Signal (*course)(double, double, RandomStream&)) {
        SyntheticTrial trial = begun(name, experiment::StartState::equilibrium);
        trial.end_s = 1.3;
        trial.activation.assign(case_.muscles.size(), fibre::Signal::constant(1.0));
        trial.activation[static_cast<std::size_t>(random_.below(2))] = course(random_.uniform(0.08, 0.2), trial.end_s,
                                                                              random_);
        return trial;
    }
    SyntheticTrial pulled(const std::string& name, fibre::Signal (*course)(double, double, RandomStream&)) {
        SyntheticTrial trial = begun(name, experiment::StartState::equilibrium);
        trial.end_s = 1.3;
        trial.tension_N = course(random_.uniform(0.6, 1.0), trial.end_s, random_);
        for (double& value : trial.tension_N->values)
            value = 1e-3 * std::round(1e3 * case_.tendon->largest_tension_N * (1.0 - value));
        return trial;
    }
    experiment::LoadDeclaration load(experiment::LoadKind kind) const {
        experiment::LoadDeclaration load;
        load.kind = kind;
        load.box_m = case_.body.end;
        return load;
    }
    /// Force from shares of the body's weight, in whole mN.
    Vector3d rounded_force(const Vector3d& shares) const {
        return 1e-3 * (1e3 * weight_N_ * shares).array().round().matrix();
    }

    const SyntheticCase& case_;
    RandomStream& random_;
    double weight_N_ = 0.0;
};

/// Two trials to fit and one to predict.
std::vector<SyntheticTrial> drawn_trials(const SyntheticCase& c, const effect::EffectNeeds& needs,
                                         RandomStream& random) {
    TrialMaker make(c, random);
    std::vector<SyntheticTrial> trials;
    if (c.tendon)
        trials = {needs.tendon || random.chance(0.5) ? make.pulled_sweep() : make.release(), make.pulled_step(),
                  make.pulled_sweep()};
    else if (!c.muscles.empty())
        trials = {needs.muscles || random.chance(0.5) ? make.sweep() : make.release(), make.step(), make.sweep()};
    else if (needs.hung_weight)
        trials = {make.release(), make.thread(), make.thread()};
    else if (random.chance(0.5))
        trials = {make.release(), make.weight(), make.pull()};
    else
        trials = {make.release(), make.pull(), make.weight()};
    // With muscles, the passive release provides a straight start.
    if (needs.straight_start && trials.front().start != experiment::StartState::straight)
        trials.front() = make.release();
    // Trials are minutes apart, which matters for effects that drift during a session.
    double session_s = 0.0;
    for (SyntheticTrial& trial : trials) {
        trial.session_time_s = session_s;
        session_s += 60.0 * std::round(random.uniform(4.0, 10.0));
    }
    trials.back().role = experiment::TrialRole::validate;
    trials.back().name += "_again";
    return trials;
}

// Schemes with little numerical damping, each different from the default TR-BDF2.
TruthScheme drawn_scheme(RandomStream& random) {
    switch (random.below(3)) {
        case 0: return {{dynamics::Integrator::trapezoidal}, 4};
        case 1: return {{dynamics::Integrator::generalized_alpha, 0.8}, 4};
        default: return {{dynamics::Integrator::generalized_alpha, 0.9}, 5};
    }
}

}  // namespace

std::string SyntheticCase::name() const {
    char text[24];
    std::snprintf(text, sizeof text, "case_%04d", number);
    return text;
}

RandomStream SyntheticCase::noise() const { return RandomStream{seed, the_noise, static_cast<std::uint64_t>(number)}; }

SyntheticCase drawn_case(const CaseChoice& choice, int number, int attempt) {
    SyntheticCase c;
    c.number = number;
    c.kind = kind_of(number);
    RandomStream random{choice.seed, the_case, static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(attempt)};
    // Kind and effect depend on choice and number only, so that another attempt keeps them.
    const std::vector<std::string> ids = effects_of(choice, number, attempt);
    const effect::EffectNeeds needs = needs_of(ids);
    const BodyFamily family = drawn_family(choice, needs, random);
    // Some cases have muscles that their effect does not need.
    const bool muscles = needs.muscles || (may_have_muscles(family) && !needs.hung_weight && random.chance(0.3));
    c.body = drawn_body(family, needs.deep_clamp, random);
    c.material = drawn_material(c.body, needs.known_damping || random.chance(0.25), random);
    if (muscles) c.muscles = drawn_muscles(c.body, c.material, random);
    if (family == BodyFamily::threaded) c.tendon = drawn_tendon(c.body, c.material, random);
    c.markers = drawn_markers(c.body, 4 + random.below(5), random);
    c.noise_m = 1e-6 * std::round(1e6 * random.uniform(5e-5, 1.5e-4));
    c.noise_is_declared = random.chance(0.75);
    c.occluded = random.chance(0.2) ? random.uniform(0.02, 0.1) : 0.0;
    // A quarter of the cases has an unknown registration, within the declared limits.
    c.registration_is_known = random.chance(0.75);
    if (!c.registration_is_known) {
        for (double& t : c.translation_m) t = random.uniform(-8e-4, 8e-4);
        for (double& w : c.rotation_rad) w = random.uniform(-6e-3, 6e-3);
    }
    // After the body and what drives it, on which loads and signals depend.
    c.trials = drawn_trials(c, needs, random);
    c.truth = drawn_scheme(random);
    for (const std::string& id : ids) {
        c.effects.push_back(drawn_effect(id, c, random));
        // Within the range of min_level and max_level.
        c.wanted_levels.push_back(random.log_uniform(3.5, 13.0));
    }
    c.seed = choice.seed;
    return c;
}

}  // namespace myo::validation
