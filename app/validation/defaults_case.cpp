#include "validation/defaults_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace myo::validation {
namespace {

using Eigen::Vector3d;

/// Second part of the key of a random stream.
enum DefaultsPurpose : std::uint64_t { the_body = 11, the_slip = 12 };

/// Proportions of a family of bodies.
struct Shape {
    const char* id;
    double min_slenderness, max_slenderness;  // length over thickness
    double min_width, max_width;              // width over thickness
    bool upright = false, tapered = false;
};

constexpr std::array<Shape, 5> shapes{{
    {"bar", 4.0, 12.0, 1.0, 1.8},
    {"strip", 12.0, 25.0, 2.5, 5.0},
    {"plate", 8.0, 16.0, 5.0, 10.0},
    {"column", 5.0, 15.0, 1.0, 1.2, true},
    {"finger", 3.0, 7.0, 0.8, 1.2, false, true},
}};

/// Three significant digits, as a person writes them.
double rounded_to_three_digits(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return unit * std::round(value / unit);
}

/// Body along +x with its clamp box and its loaded face; tapered bodies are centred on the x axis.
SyntheticBody shaped_body(const Shape& shape, double length, double thickness, double width, RandomStream& random) {
    SyntheticBody body;
    body.family = shape.tapered ? BodyFamily::tail : BodyFamily::beam;
    body.metres_per_unit = random.chance(0.5) ? 1.0 : 1e-3;
    body.thickness_m = thickness;
    const double y = shape.tapered ? -0.5 * width : 0.0, z = shape.tapered ? -0.5 * thickness : 0.0;
    body.surface = mesh::box_surface({{0.0, y, z}, {length, y + width, z + thickness}});
    body.bounds = mesh::bounding_box(body.surface.vertices);
    if (shape.tapered) {
        body.taper_y = random.uniform(0.5, 0.85);
        body.taper_z = random.uniform(0.5, 0.85);
        for (Eigen::Index i = 0; i < body.surface.vertices.cols(); ++i)
            body.surface.vertices.col(i) = body.tapered(body.surface.vertices.col(i));
    }
    // Boxes extend beyond the body, so that rounding does not exclude nodes of the face.
    const double beyond = 0.05 * thickness, face = 0.005 * length;
    body.clamp = {body.bounds.lowest - Vector3d::Constant(beyond), body.bounds.highest + Vector3d::Constant(beyond)};
    body.end = body.clamp;
    body.clamp.lowest(0) = -face;
    body.clamp.highest(0) = face;
    body.end.lowest(0) = length - face;
    body.end.highest(0) = length + face;
    return body;
}

/// Beam theory of a cantilever of constant cross section.
struct Cantilever {
    double E = 0.0, rho = 0.0, length = 0.0, thickness = 0.0, width = 0.0;

    double bending_stiffness() const { return E * width * std::pow(thickness, 3) / 12.0; }
    double weight_N() const { return rho * gravity_m_s2 * length * thickness * width; }
    /// Deflection under the own weight over the length.
    double sag() const { return weight_N() * std::pow(length, 2) / (8.0 * bending_stiffness()); }
    // Force that bends the free end by this share of the length, F = 3 EI u / L^3 with u = share L.
    double end_force_N(double share) const { return 3.0 * bending_stiffness() * share / std::pow(length, 2); }
    /// Weight over the buckling load of a column under its own weight (Greenhill): q L^3 = 7.837 EI.
    double column_load() const { return weight_N() * std::pow(length, 2) / (7.837 * bending_stiffness()); }
    /// First bending frequency, (1.8751)^2 / (2 pi) sqrt(EI / (rho A)) / L^2.
    double frequency_Hz() const {
        return std::pow(1.8751, 2) / (2.0 * std::numbers::pi) *
               std::sqrt(bending_stiffness() / (rho * width * thickness)) / std::pow(length, 2);
    }
};

/// Force at the free end in the flexible direction.
experiment::LoadDeclaration end_force(const SyntheticCase& c, double force_N, RandomStream& random) {
    experiment::LoadDeclaration load;
    load.kind = experiment::LoadKind::force;
    load.box_m = c.body.end;
    // Some force sideways, so that the motion does not stay in a plane.
    const double sign = random.sign(), sideways = 0.2 * random.uniform(-1.0, 1.0);
    load.force_N = rounded_to_three_digits(force_N) * Vector3d(0.0, sideways, sign);
    return load;
}

/// Activation that drops by `depth`, holds, and returns.
fibre::Signal contraction(double depth, double end_s) {
    return {{0.0, 0.2 * end_s, 0.3 * end_s, 0.6 * end_s, 0.7 * end_s, end_s},
            {1.0, 1.0, 1.0 - depth, 1.0 - depth, 1.0, 1.0}};
}

/// Two antagonists along the body, one of which contracts.
void add_muscles(SyntheticCase& c, RandomStream& random) {
    Box box = c.body.clamp;
    box.highest = c.body.end.highest;
    const double middle = 0.5 * (c.body.bounds.lowest(2) + c.body.bounds.highest(2));
    SyntheticMuscle low{"low", box, rounded_to_three_digits(random.uniform(0.2, 0.4) * c.material.youngs_modulus_Pa)},
        high = low;
    high.name = "high";
    low.box.highest(2) = high.box.lowest(2) = middle;
    c.muscles = {low, high};
    SyntheticTrial& trial = c.trials.front();
    trial.activation.assign(2, fibre::Signal::constant(1.0));
    trial.activation[static_cast<std::size_t>(random.below(2))] = contraction(random.uniform(0.04, 0.12), trial.end_s);
}

/// Four kinds: released straight; hanging at rest, then loaded; loaded and released at t = 0; held, then released.
SyntheticTrial drawn_trial(const SyntheticCase& c, const Cantilever& beam, double end_s, bool upright,
                           RandomStream& random) {
    SyntheticTrial trial;
    trial.name = "motion";
    trial.end_s = end_s;
    const double swing = random.uniform(defaults_policy.min_swing, defaults_policy.max_swing);
    experiment::LoadDeclaration load = end_force(c, beam.end_force_N(swing), random);
    const int first = upright || beam.sag() < defaults_policy.min_swing ? 1 : 0;  // its weight alone must excite it
    // 0: straight, without a load.
    switch (first + random.below(4 - first)) {
        case 0: return trial;
        case 1: load.from_s = rounded_to_three_digits(0.1 * end_s); break;
        case 2: load.until_s = 0.0; break;
        default: load.until_s = rounded_to_three_digits(0.3 * end_s); break;
    }
    trial.start = experiment::StartState::equilibrium;
    trial.loads.push_back(load);
    return trial;
}

/// Poisson's ratio: half of the cases have one that people write, the others any.
double drawn_ratio(RandomStream& random) {
    constexpr std::array<double, 4> common{0.3, 0.45, 0.49, 0.4995};
    if (random.chance(0.5)) return common[static_cast<std::size_t>(random.below(4))];
    return 0.001 * std::round(random.uniform(0.5, 499.5));  // Poisson's ratio 0 is rejected by the schema
}

/// Draws body, material and camera; false if nobody would record it that way (too soft, too slow or too many periods).
bool draw_experiment(DefaultsCase& d, RandomStream& random) {
    const DefaultsPolicy& p = defaults_policy;
    const Shape& shape = shapes[static_cast<std::size_t>(random.below(static_cast<int>(shapes.size())))];
    d.shape = shape.id;
    SyntheticCase& c = d.truth;
    Cantilever beam;
    beam.length = rounded_to_three_digits(random.log_uniform(p.min_length_m, p.max_length_m));
    beam.thickness = rounded_to_three_digits(beam.length /
                                             random.uniform(shape.min_slenderness, shape.max_slenderness));
    beam.width = rounded_to_three_digits(beam.thickness * random.uniform(shape.min_width, shape.max_width));
    beam.E = rounded_to_three_digits(random.log_uniform(p.min_modulus_Pa, p.max_modulus_Pa));
    beam.rho = 10.0 * std::round(random.uniform(90.0, 130.0));
    d.frequency_Hz = beam.frequency_Hz();
    // Columns stand or hang: gravity along -x or +x.
    const bool hangs = shape.upright && random.chance(0.3);
    if (shape.upright && !hangs && beam.column_load() > p.max_column_load) return false;
    if (!shape.upright && beam.sag() > p.max_sag) return false;
    // Independent of the frequency: cameras that are too slow or too fast are part of the study.
    c.rate_Hz = rounded_to_three_digits(random.log_uniform(p.min_rate_Hz, p.max_rate_Hz));
    // A few periods, but enough samples for a slow camera and not too many of a fast one.
    double end_s = random.uniform(p.min_periods, p.max_periods) / d.frequency_Hz;
    end_s = std::min(std::max(end_s, p.min_samples / c.rate_Hz), p.max_samples / c.rate_Hz);
    const double periods = end_s * d.frequency_Hz;
    if (periods < 0.5 * p.min_periods || periods > p.longest_periods) return false;
    end_s = std::ceil(end_s * c.rate_Hz) / c.rate_Hz;

    c.body = shaped_body(shape, beam.length, beam.thickness, beam.width, random);
    if (shape.upright) c.gravity_m_s2 = Vector3d(hangs ? gravity_m_s2 : -gravity_m_s2, 0.0, 0.0);
    c.material.youngs_modulus_Pa = beam.E;
    // The declared modulus is a guess within the tolerance of 30 %.
    c.material.declared_modulus_Pa = rounded_to_three_digits(beam.E * random.uniform(0.8, 1.25));
    c.material.poissons_ratio = drawn_ratio(random);
    c.material.density_kg_m3 = beam.rho;
    // Damping ratio = omega damping / 2.
    c.material.damping_s = rounded_to_three_digits(random.log_uniform(p.min_damping_ratio, p.max_damping_ratio) /
                                                   (std::numbers::pi * d.frequency_Hz));
    c.markers = drawn_markers(c.body, 3 + random.below(4), random);
    c.trials = {drawn_trial(c, beam, end_s, shape.upright, random)};
    if (!shape.upright && random.chance(p.muscles)) add_muscles(c, random);
    // Noise relative to the amplitude, as a camera is chosen for the motion.
    const double swing = c.trials.front().loads.empty() ? beam.sag() : p.min_swing;
    c.noise_m = rounded_to_three_digits(random.log_uniform(p.min_noise, p.max_noise) * swing * beam.length);
    return true;
}

/// Every third case has a declaration error, in the order of the catalogue.
const Slip* slip_of(int number) {
    const auto round = static_cast<int>(std::lround(1.0 / defaults_policy.slips));
    if (number % round != round - 1) return nullptr;
    return &slips()[static_cast<std::size_t>(number / round) % slips().size()];
}

}  // namespace

DefaultsCase drawn_defaults_case(std::uint64_t seed, int number) {
    DefaultsCase d;
    // The declaration error depends on the number only.
    const Slip* const slip = slip_of(number);
    // Rejection sampling: draws until the experiment is plausible and the declaration error applies to it.
    for (std::uint64_t attempt = 0;; ++attempt) {
        d = {};
        RandomStream random{seed, the_body, static_cast<std::uint64_t>(number), attempt};
        if (draw_experiment(d, random) && (slip == nullptr || slip->fits(d.truth))) break;
    }
    d.truth.number = number;
    d.truth.seed = seed;
    d.slip = slip;
    d.declared = d.truth;
    RandomStream random{seed, the_slip, static_cast<std::uint64_t>(number)};
    if (d.slip != nullptr) d.slip->make(d.declared, random);
    return d;
}

}  // namespace myo::validation
