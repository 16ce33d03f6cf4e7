#include "setup/first_vibration.hpp"

#include <memory>
#include <optional>

#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "dynamics/natural_modes.hpp"

namespace myo::setup {
namespace {

/// A solver with the model that it refers to.
struct Assembly {
    model::Model model;
    std::optional<dynamics::StageSolver> solver;
};

}  // namespace

double first_vibration_rad_s(const model::Model& model) {
    const std::vector<double> found = slowest_vibrations_rad_s(model, 1);
    return found.empty() ? 0.0 : found.front();
}

std::vector<double> slowest_vibrations_rad_s(const model::Model& model, int count) {
    if (cancellation_requested()) return {};
    // Mass and stiffness of a large body are assembled for seconds: a cancelled caller leaves them to end by
    // themselves.
    const auto job = std::make_shared<Assembly>(Assembly{model, {}});
    if (!run_abandonable([job] { job->solver.emplace(job->model); })) return {};
    // Linearised about the rest shape: no equilibrium has to be found first.
    const dynamics::NaturalModes modes = dynamics::natural_modes(*job->solver, model.body->mesh.nodes, count);
    std::vector<double> omega_rad_s;
    if (modes.ok())
        for (const dynamics::NaturalMode& mode : modes.modes) omega_rad_s.push_back(mode.omega_rad_s);
    return omega_rad_s;
}

}  // namespace myo::setup
