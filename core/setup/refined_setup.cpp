#include "setup/refined_setup.hpp"

namespace myo::setup {

Result<Setup> refined_setup(const Setup& setup, double ratio, const Progress& progress) {
    SetupSettings settings = setup.settings;
    // The element kind is fixed to the one in use, so that only the cell size changes.
    settings.mesh.element = setup.mesh.element;
    settings.mesh.refinement *= ratio;
    return prepare_setup(setup.experiment, settings, progress);
}

}  // namespace myo::setup
