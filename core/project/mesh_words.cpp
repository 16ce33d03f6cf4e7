#include "project/mesh_words.hpp"

#include <cmath>

#include "base/text.hpp"
#include "project/mesh_suitability.hpp"
#include "project/study.hpp"
#include "report/length.hpp"

namespace myo {

std::string mesh_words(const Study& study) {
    const WallLayers layers = wall_layers({study.surface, study.mesh, study.experiment.effects});
    const bool counted = layers.count == std::round(layers.count);
    return std::to_string(study.mesh.mesh.cell_count()) + " " + to_string(study.body->kind) + " elements of " +
           format_number(1e3 * study.mesh.resolution_m, 3) + " mm, " + (counted ? "" : "about ") +
           format_number(layers.count, 2) + (layers.count == 1.0 ? " layer" : " layers") + " across " +
           length_words(layers.thickness_m) + ", " + std::to_string(3 * study.mesh.mesh.node_count()) +
           " degrees of freedom";
}

}  // namespace myo
