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
#include "validation/synthetic_body.hpp"

namespace myo::validation {

enum class CaseKind {
    none,     // the declared model is enough
    named,    // one effect acts that the diagnosis knows
    deleted,  // one effect acts that the diagnosis is not told of
};
std::string to_string(CaseKind kind);
bool parse_case_kind(const std::string& id, CaseKind& kind);

/// Of which cases a trust study is drawn.
struct CaseChoice {
    std::uint64_t seed = 1;
    std::vector<BodyFamily> families;  // empty: all
    std::vector<std::string> effects;  // ids; empty: the whole catalogue
};

/// Error: an effect that is not known, or that no body of the choice can show.
Result<void> check_choice(const CaseChoice& choice);

struct SyntheticMuscle {
    std::string name;
    Box box;
    double stiffness_Pa = 0.0;
};

struct SyntheticTrial {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    experiment::StartState start = experiment::StartState::straight;
    double session_time_s = 0.0;
    double end_s = 1.0;
    std::vector<experiment::LoadDeclaration> loads;
    std::vector<fibre::Signal> activation;  // one per muscle; empty: passive
    std::string recorded_as;                // the trial whose trace and actuation it has; empty: its own
    double clock_s = 0.0;                   // time of its trace's file at t = 0
    double signal_unit_s = 1.0;             // of the times in its actuation file

    const std::string& recording() const { return recorded_as.empty() ? name : recorded_as; }
};

/// What is true of a material, and what the experiment says of it.
struct SyntheticMaterial {
    double youngs_modulus_Pa = 0.0, declared_modulus_Pa = 0.0;
    double poissons_ratio = 0.0;
    double density_kg_m3 = 0.0;
    double damping_s = 0.0;
    bool damping_is_known = false;  // declared exactly, and not fitted
};

/// How the truth is simulated: never as the diagnosis does.
struct TruthScheme {
    dynamics::TimeScheme scheme;
    int steps_per_sample = 4;
};

/// A laboratory's experiment with one body, and what is true of it. SI units, mesh frame.
struct SyntheticCase {
    int number = 0;
    CaseKind kind = CaseKind::none;
    SyntheticBody body;
    SyntheticMaterial material;
    std::vector<SyntheticMuscle> muscles;
    std::vector<Eigen::Vector3d> markers;
    double noise_m = 1e-4;
    bool noise_is_declared = true;
    double occluded = 0.0;  // share of a marker's samples that are hidden
    double rate_Hz = 100.0;
    Eigen::Vector3d gravity_m_s2{0.0, 0.0, -9.81};
    bool registration_is_known = true;
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero(), rotation_rad = Eigen::Vector3d::Zero();
    std::vector<SyntheticTrial> trials;  // those to fit first
    TruthScheme truth;
    std::optional<effect::EffectDeclaration> effect;  // none for CaseKind::none
    double wanted_level = 0.0;                        // size of what it does to the markers, in noise levels
    std::uint64_t seed = 0;                           // of the study

    std::string name() const;  // "case_0007"
    /// What the cameras' noise and gaps are drawn from.
    RandomStream noise() const;
};

/// Case `number` of a study: the same for any count, order and number of processes. Of six in a row the first has no
/// effect and the fourth one that is deleted; the effects of the others, and of the deleted, go round the catalogue in
/// a random order.
///
/// @param attempt  another draw of the same kind and effect, for a case whose effect cannot be seen well enough
SyntheticCase drawn_case(const CaseChoice& choice, int number, int attempt = 0);

}  // namespace myo::validation
