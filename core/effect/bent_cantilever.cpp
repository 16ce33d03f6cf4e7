#include "effect/bent_cantilever.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace myo::effect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;  // rotation, curvature, along, across

/// Right-hand side of the differential equation along the arc length.
Vector4d slope(const Vector4d& y, double load, double shear) {
    const double c = std::cos(y(0)), s = std::sin(y(0)), g = load * shear * c;
    return {y(1), -load * (c - g * s), c - g * s, s + g * c};
}

/// One increment of the classical Runge-Kutta method of fourth order along the arc length.
Vector4d after(const Vector4d& y, double h, double load, double shear) {
    const Vector4d k1 = slope(y, load, shear), k2 = slope(y + 0.5 * h * k1, load, shear),
                   k3 = slope(y + 0.5 * h * k2, load, shear), k4 = slope(y + h * k3, load, shear);
    return y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

/// State at the free end for given curvature at the clamp and load.
Vector4d end_of(const Vector2d& curvature_and_load, double shear) {
    Vector4d y(0.0, curvature_and_load(0), 0.0, 0.0);
    for (int k = 0; k < bent_cantilever_policy.parts; ++k)
        y = after(y, 1.0 / bent_cantilever_policy.parts, curvature_and_load(1), shear);
    return y;
}

/// Shooting: curvature at the clamp and load such that the end has no moment and the given deflection, by Newton's
/// method from a nearby solution `at`.
Vector2d solve(double deflection, double shear, Vector2d at) {
    const auto error = [&](const Vector2d& p) {
        const Vector4d end = end_of(p, shear);
        return Vector2d(end(1), end(3) - deflection);
    };
    // Quadratic convergence from a nearby solution takes a few iterations; 30 only bound the loop.
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Vector2d now = error(at);
        if (now.norm() < 1e-15) break;
        const double width = 1e-5 * std::max(1.0, at(1));
        Eigen::Matrix2d J;
        for (int i = 0; i < 2; ++i)
            // Central differences; the shooting function is smooth.
            J.col(i) = (error(at + width * Vector2d::Unit(i)) - error(at - width * Vector2d::Unit(i))) / (2.0 * width);
        const Vector2d step = J.partialPivLu().solve(now);
        at -= step;
        if (step.norm() < 1e-14 * at.norm()) break;
    }
    return at;
}

/// Section of a state (rotation, curvature, along, across).
BeamSection section(const Vector4d& y) { return {y(0), y(1), y(2), y(3)}; }

}  // namespace

BeamSection BentCantilever::at(double s) const {
    assert(s >= 0.0 && sections.size() == bent_cantilever_policy.parts + 1);
    // One shorter increment from the section before s: the result is as accurate as the stored sections.
    const int before = std::clamp(static_cast<int>(s * bent_cantilever_policy.parts), 0, bent_cantilever_policy.parts);
    const BeamSection& from = sections[static_cast<std::size_t>(before)];
    return section(after({from.turn_rad, from.curvature, from.along, from.across},
                         s - static_cast<double>(before) / bent_cantilever_policy.parts, load, shear));
}

BentCantilever bent_cantilever(double deflection, double shear) {
    assert(deflection >= 0.0 && shear >= 0.0);
    const double wanted = std::min(deflection, bent_cantilever_policy.max_deflection);
    // Small deflections: bending contributes load / 3, shear contributes load times shear. Larger deflections are
    // reached by continuation.
    Vector2d at = Vector2d::Constant(std::min(wanted, 0.1) / (1.0 / 3.0 + shear));
    // Increments shrink towards the full length, where the load grows without bound.
    for (double reached = std::min(wanted, 0.1);; reached = std::min(wanted, reached + 0.2 * (1.0 - reached))) {
        at = solve(reached, shear, at);
        if (reached >= wanted) break;
    }
    BentCantilever result{at(1), shear, {}};
    Vector4d y(0.0, at(0), 0.0, 0.0);
    for (int k = 0; k <= bent_cantilever_policy.parts; ++k) {
        result.sections.push_back(section(y));
        y = after(y, 1.0 / bent_cantilever_policy.parts, at(1), shear);
    }
    return result;
}

}  // namespace myo::effect
