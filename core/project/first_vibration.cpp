#include "project/first_vibration.hpp"

#include "dynamics/natural_modes.hpp"

namespace myo {

double first_vibration_rad_s(const Model& model) {
    StageSolver solver(model);
    const NaturalModes modes = natural_modes(solver, model.body->mesh.nodes, 1);
    return modes.ok() ? modes.modes.front().omega_rad_s : 0.0;
}

}  // namespace myo
