#pragma once

#include <string>
#include <vector>

#include "experiment/experiment.hpp"
#include "mesh/surface_mesh.hpp"
#include "model/tendon.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// A tendon on the mesh of its body.
struct Tendon {
    model::TendonRoute route;    // guides on the mesh or in space, friction, and the first coupling of the body
    std::vector<bool> declared;  // per guide of the route: of the experiment, or one on the way through a channel
    bool by_shortening = false;
    double stiffness_N_m = 0.0;  // driven by shortening only
    double slack_m = 0.0;        // see model::tendon_of_shortening()
};

struct TendonPolicy {
    /// Stiffness of a thread that does not stretch, over the stiffness E V / L^2 of the body along it: the thread
    /// yields by a thousandth of what the body does, less where the body bends.
    double rigid_stiffness = 1000.0;
    /// Strain of the body along the thread whose tension is smoothed around its onset.
    double smoothed_strain = 1e-4;
};
inline constexpr TendonPolicy tendon_policy;

/// All declared tendons: guides in the material or as close to it as markers may be move with it, the others stand
/// still. A thread in a channel is bound to the material on its way between them, too. Couplings are numbered from 0 in
/// this order.
std::vector<Tendon> find_tendons(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                 const BodyMesh& mesh);

/// Number of declared guides that move with the body; the others stand still.
std::size_t moving_guides(const Tendon& tendon);

/// Couplings of all tendons, for model::make_body().
std::vector<std::vector<int>> couplings(const std::vector<Tendon>& tendons);

/// The tendon as force element.
model::ForceElementPointer tendon_element(const Tendon& tendon, const fibre::Signal& command);

}  // namespace myo::setup
