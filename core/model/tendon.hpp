#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/material_point.hpp"
#include "fibre/signal.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// Guide of a tendon: it moves with the material, or stands still.
struct TendonGuide {
    std::optional<fem::MaterialPoint> on_body;  // in the material or on its surface; empty: a fixed guide
    Eigen::Vector3d rest_m;                     // rest position; of a fixed guide all along
};

/// A tendon without its command.
struct TendonRoute {
    std::vector<TendonGuide> guides;  // motor's end first
    std::size_t first_coupling = 0;   // index in Body::couplings of the first of tendon_couplings()
    /// Capstan coefficient >= 0, see capstan_factors(). The thread takes in while the command grows and pays out while
    /// it falls; a constant command leaves it as it was, at first taking in.
    double friction = 0.0;
    std::string words = "a tendon";  // for messages
};

/// Groups of nodes that a tendon couples, for make_body(): neighbouring guides of a prescribed tension; all guides of a
/// prescribed shortening, whose tension depends on the whole length.
std::vector<std::vector<int>> tendon_couplings(const std::vector<TendonGuide>& guides, bool by_shortening);

/// Thread under the prescribed tension T(t) [N] at the motor, through guides, straight between them. Without friction
/// it has the potential T L with the length L of the path.
///
/// Parameters: the knots of the command, the friction, then the places of the guides on the body at rest, to first
/// order in their shift. Source: Camarillo et al. 2008 (tension along the path).
ForceElementPointer tendon_of_tension(const TendonRoute& route, const fibre::Signal& tension_N);

/// Elastic thread of which the motor takes in the length s(t) [m]: tension k (L - L0 + s), L0 the length at rest. A
/// slack thread has no tension; within `slack_m` to both sides of the onset of tension the stiffness grows linearly
/// from 0 to k, so that the tension has a continuous derivative. With friction k times the stretch is the mean tension
/// over the thread, weighed with the legs' lengths at rest.
///
/// @param stiffness_N_m  k of the whole thread, > 0, parameter after the knots
/// @param slack_m        > 0 [m]; small against the stretches that matter
ForceElementPointer tendon_of_shortening(const TendonRoute& route, const fibre::Signal& shortening_m,
                                         double stiffness_N_m, double slack_m);

/// What a sensor at the motor sees.
struct TendonState {
    double tension_N = 0.0;     // at the motor
    double shortening_m = 0.0;  // of the path between the guides, from its rest length
};
/// State of a tendon at node positions x; asserts that the element is a tendon.
TendonState tendon_state(const ForceElement& tendon, const ForceState& at);

/// Route of a tendon; null if the element is none.
const TendonRoute* tendon_route(const ForceElement& element);
/// Copy of a tendon on another route, with its command and its law; asserts that the element is a tendon.
ForceElementPointer with_route(const ForceElement& tendon, TendonRoute route);
/// Whether a tendon has a prescribed shortening; asserts that the element is a tendon.
bool is_driven_by_shortening(const ForceElement& tendon);

/// Copy of a tendon with `added` to its capstan coefficient; null if the element is no tendon.
ForceElementPointer with_added_friction(const ForceElement& element, double added);

}  // namespace myo::model
