#include "setup/mesh_words.hpp"

#include <cmath>

#include "base/text.hpp"
#include "report/length.hpp"
#include "setup/mesh_suitability.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

std::string mesh_words(const Setup& setup) {
    const WallLayers layers = wall_layers({setup.surface, setup.mesh, setup.experiment.effects});
    // A whole number comes from counted layers; an estimate is one only by chance.
    const bool counted = layers.count == std::round(layers.count);
    return std::to_string(setup.mesh.mesh.cell_count()) + " " + to_string(setup.body->kind) + " elements of " +
           format_number(1e3 * setup.mesh.resolution_m, 3) + " mm, " + (counted ? "" : "about ") +
           format_number(layers.count, 2) + (layers.count == 1.0 ? " layer" : " layers") + " across " +
           report::length_words(layers.thickness_m) + ", " + std::to_string(3 * setup.mesh.mesh.node_count()) +
           " degrees of freedom";
}

}  // namespace myo::setup
