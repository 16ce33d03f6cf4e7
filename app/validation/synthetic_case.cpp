#include "validation/synthetic_case.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/name_table.hpp"
#include "effect/catalogue.hpp"
#include "mesh/surface_mesh.hpp"
#include "validation/synthetic_effects.hpp"

namespace myo::validation {
namespace {

using Eigen::Vector3d;

constexpr NameTable<CaseKind, 3> kinds{
    {{{CaseKind::none, "none"}, {CaseKind::named, "named"}, {CaseKind::deleted, "deleted"}}}};
/// A cycle of cases: none, named, named, deleted, named, named.
constexpr int round_length = 6, deleted_at = 3, named_in_round = 4;

/// Second part of the key of a random stream.
enum Purpose : std::uint64_t { order_of_effects = 1, the_case = 2, the_noise = 3 };

/// Kind of a case by its place in the cycle.
CaseKind kind_of(int number) {
    const int place = number % round_length;
    return place == 0 ? CaseKind::none : place == deleted_at ? CaseKind::deleted : CaseKind::named;
}

/// Index of a case among those of its kind.
int turn_of(int number) {
    const int round = number / round_length, place = number % round_length;
    if (kind_of(number) != CaseKind::named) return round;
    return named_in_round * round + place - (place < deleted_at ? 1 : 2);
}

// Bodies that bend by an antagonist pair along their length.
bool may_have_muscles(BodyFamily family) { return family == BodyFamily::beam || family == BodyFamily::tail; }

/// Families of the choice; of all of them, bodies with a tendon serve the effects that need one only.
std::vector<BodyFamily> families_of(const CaseChoice& choice, const effect::EffectNeeds& needs) {
    if (!choice.families.empty()) return choice.families;
    if (needs.tendon) return {BodyFamily::threaded};
    return {BodyFamily::beam, BodyFamily::plate, BodyFamily::ell, BodyFamily::tail};
}

/// Tetrahedra do not conform to the inner plane of a clamp: a tail clamped over a part of its length would be clamped
/// less in its model.
bool may_be_held_deep(BodyFamily family) { return family != BodyFamily::tail; }

/// Whether a body of the family can have what an effect needs.
bool fits(BodyFamily family, const effect::EffectNeeds& needs) {
    const bool threaded = family == BodyFamily::threaded;
    // The trials of a thread have no other loads. No body is bent far between two guides: between them a straight
    // thread and one in a channel are the same within the noise.
    return !needs.far_guides && (!needs.tendon || threaded) && (!needs.hung_weight || !threaded) &&
           (!needs.muscles || may_have_muscles(family)) && (!needs.deep_clamp || may_be_held_deep(family));
}

/// Whether some body of the choice can show an effect.
bool can_show(const CaseChoice& choice, const std::string& id) {
    const effect::EffectNeeds& needs = effect_draw(id).needs;
    const std::vector<BodyFamily> families = families_of(choice, needs);
    return std::any_of(families.begin(), families.end(), [&](BodyFamily family) { return fits(family, needs); });
}

/// Each effect once per cycle through the catalogue, in a new random order each time (Fisher-Yates).
std::string effect_of(const CaseChoice& choice, int number) {
    std::vector<std::string> ids = choice.effects;
    if (ids.empty())
        for (const std::string& id : effect::effect_ids())
            if (can_show(choice, id)) ids.push_back(id);
    const int count = static_cast<int>(ids.size()), turn = turn_of(number);
    RandomStream random{choice.seed, order_of_effects, static_cast<std::uint64_t>(kind_of(number)),
                        static_cast<std::uint64_t>(turn / count)};
    for (int i = count - 1; i > 0; --i)
        std::swap(ids[static_cast<std::size_t>(i)], ids[static_cast<std::size_t>(random.below(i + 1))]);
    return ids[static_cast<std::size_t>(turn % count)];
}

/// Random family of those that fit; there must be one.
BodyFamily drawn_family(const CaseChoice& choice, const effect::EffectNeeds& needs, RandomStream& random) {
    std::vector<BodyFamily> fitting;
    for (const BodyFamily family : families_of(choice, needs))
        if (fits(family, needs)) fitting.push_back(family);
    assert(!fitting.empty());
    return fitting[static_cast<std::size_t>(random.below(static_cast<int>(fitting.size())))];
}

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

std::string to_string(CaseKind kind) { return kinds.name(kind); }
bool parse_case_kind(const std::string& id, CaseKind& kind) { return kinds.find(id, kind); }

Result<void> check_choice(const CaseChoice& choice) {
    for (const std::string& id : choice.effects) {
        if (effect::find_effect(id) == nullptr) return Error{"no effect '" + id + "' is known", "--effects"};
        if (!can_show(choice, id))
            return Error{
                id + (effect_draw(id).needs.far_guides    ? " needs a body that a thread bends far, which none is"
                      : effect_draw(id).needs.tendon      ? " needs a tendon, which only threaded has"
                      : effect_draw(id).needs.hung_weight ? " needs a hung weight, which threaded has not"
                      : effect_draw(id).needs.muscles     ? " needs muscles, which only beam and tail have"
                                                      : " needs a clamp over a part of the length, which tail has not"),
                "--geometry"};
    }
    return {};
}

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
    const std::string id = c.kind == CaseKind::none ? "" : effect_of(choice, number);
    const effect::EffectNeeds needs = id.empty() ? effect::EffectNeeds{} : effect_draw(id).needs;
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
    if (!id.empty()) {
        c.effect = drawn_effect(id, c, random);
        // Within the range of min_level and max_level.
        c.wanted_level = random.log_uniform(3.5, 13.0);
    }
    c.seed = choice.seed;
    return c;
}

}  // namespace myo::validation
