#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "dynamics/integrator.hpp"
#include "effect/effect.hpp"
#include "experiment/experiment.hpp"
#include "fibre/signal.hpp"
#include "validation/case_choice.hpp"
#include "validation/synthetic_body.hpp"

namespace myo::validation {

/// A muscle that fills a box, fibres along x.
struct SyntheticMuscle {
    std::string name;
    // Holds the cells of the muscle; part of the body [m].
    Box box;
    double stiffness_Pa = 0.0;
};

/// A tendon of prescribed tension along the body, motor in the clamp.
struct SyntheticTendon {
    std::string name;
    Eigen::Matrix3Xd path_m;         // guides at rest, 3 x n
    double largest_tension_N = 0.0;  // of the trials
};

/// A trial of a case, with the ways in which its files may differ from the truth.
struct SyntheticTrial {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    experiment::StartState start = experiment::StartState::straight;
    double session_time_s = 0.0;  // within the session
    double end_s = 1.0;
    std::vector<experiment::LoadDeclaration> loads;
    std::vector<fibre::Signal> activation;   // one per muscle; empty: passive
    std::optional<fibre::Signal> tension_N;  // of the tendon; empty: at rest
    std::string recorded_as;                 // trial whose trace and actuation it uses; empty: its own
    double clock_s = 0.0;                    // time in the trace file at t = 0
    double signal_unit_s = 1.0;              // unit of the times in its actuation file

    bool has_actuation() const { return !activation.empty() || tension_N; }
    const std::string& recording() const { return recorded_as.empty() ? name : recorded_as; }
};

/// True material parameters and what the experiment declares.
struct SyntheticMaterial {
    double youngs_modulus_Pa = 0.0, declared_modulus_Pa = 0.0;
    double poissons_ratio = 0.0;
    double density_kg_m3 = 0.0;
    double damping_s = 0.0;
    bool damping_is_known = false;  // declared exactly and not fitted
};

/// Time integration of the truth; always different from that of the diagnosis.
struct TruthScheme {
    dynamics::TimeScheme scheme;
    int steps_per_sample = 4;
};

/// A synthetic experiment with one body and its truth. SI units, mesh frame.
struct SyntheticCase {
    int number = 0;
    CaseKind kind = CaseKind::none;
    SyntheticBody body;
    SyntheticMaterial material;
    std::vector<SyntheticMuscle> muscles;
    std::optional<SyntheticTendon> tendon;
    std::vector<Eigen::Vector3d> markers;
    // Standard deviation of each coordinate of a marker.
    double noise_m = 1e-4;
    bool noise_is_declared = true;
    double occluded = 0.0;  // share of the samples of one marker that are hidden
    // Sampling rate of the cameras.
    double rate_Hz = 100.0;
    Eigen::Vector3d gravity_m_s2{0.0, 0.0, -9.81};
    // Camera frame and mesh frame agree; otherwise the two numbers below are unknown to the diagnosis.
    bool registration_is_known = true;
    /// True registration, mesh to camera frame.
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero(), rotation_rad = Eigen::Vector3d::Zero();
    std::vector<SyntheticTrial> trials;  // fit trials first
    TruthScheme truth;
    std::vector<effect::EffectDeclaration> effects;  // empty for CaseKind::none
    std::vector<double> wanted_levels;               // intended sizes of the effects at the markers, in noise levels
    std::uint64_t seed = 0;                          // of the validation

    std::string name() const;  // "case_0007"
    /// Stream for camera noise and gaps.
    RandomStream noise() const;
};

/// Case `number` of a validation; independent of count, order and number of processes.
///
/// Among six consecutive cases the first has no effect and the fourth a deleted one; the effects of the others, and of
/// the deleted ones, cycle through the catalogue in a random order. Where several act together, those after the first
/// are drawn at random from the effects that one body can show with it.
///
/// @param choice   one that check_choice() accepts
/// @param attempt  another draw of the same kind and first effect, for a case whose effects are not visible enough
SyntheticCase drawn_case(const CaseChoice& choice, int number, int attempt = 0);

}  // namespace myo::validation
