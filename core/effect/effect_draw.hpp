#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "effect/effect_declaration.hpp"

namespace myo::effect {

// Synthetic experiments of known answer draw their effects from the catalogue: every entry states the range of its
// amount, what an experiment needs to show it, and how its other parameters are drawn.

/// Features that an experiment needs to show an effect.
struct EffectNeeds {
    bool muscles = false;
    bool tendon = false;       // pulled tight around its guides
    bool far_guides = false;   // of that tendon, in a body that it bends far
    bool deep_clamp = false;   // otherwise clamped at the face
    bool hung_weight = false;  // a permanent force
    bool known_damping = false;
    bool straight_start = false;
};

/// A trial for which an effect is drawn.
struct DrawTrial {
    std::string name;
    bool is_fitted = false;
    bool starts_straight = false;
    double end_s = 0.0;
};

/// Body and trials for which an effect is drawn: a body that extends from its clamp at x = 0 along x. Mesh frame.
struct DrawContext {
    double length_m = 0.0;
    double held_m = 0.0;                                 // depth of the clamp; 0: clamped at the face
    double thickness_m = 0.0;                            // in the bending direction under gravity
    Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();  // of the body; y and z of the part along x
    double density_kg_m3 = 0.0;
    double youngs_modulus_Pa = 0.0;
    std::vector<std::string> marker_names;
    std::vector<DrawTrial> trials;  // fitted trials first
    /// Random point on the surface of the outer part of the body, independent of the markers [m].
    std::function<Eigen::Vector3d(RandomStream&)> surface_point;
};

/// How an effect is drawn and scaled.
struct EffectDraw {
    EffectNeeds needs{};
    std::string amount{};                // parameter that scales it; empty: not scalable
    double lowest = 0.0, highest = 0.0;  // plausible range of the amount, in the unit of the parameter
    bool has_sign = false;               // the amount may be negative
    bool grows = true;                   // a larger amount has a larger effect
    /// All parameters but the amount; null: none.
    EffectParameters (*others)(const DrawContext&, RandomStream&) = nullptr;
    /// Limit of the amount for a body; null: `highest`.
    double (*limit)(const DrawContext&) = nullptr;
};

/// Random unit vector.
Eigen::Vector3d drawn_direction(RandomStream& random);
/// Number of the axis y or z.
double drawn_cross_axis(RandomStream& random);
/// Name of a fitted trial; the context must contain one.
std::string drawn_fitted_trial(const DrawContext& context, RandomStream& random);
/// A time in the middle of the first trial, in full hundredths of a second [s].
double drawn_time_s(const DrawContext& context, RandomStream& random);
/// The parameter position_m on the surface.
EffectParameters drawn_position(const DrawContext& context, RandomStream& random);

}  // namespace myo::effect
