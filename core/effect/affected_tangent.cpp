#include "effect/affected_tangent.hpp"

namespace myo::effect {
namespace {

using Eigen::Matrix3Xd;

/// Start positions: given ones or the rest shape.
Matrix3Xd start_of(const Affected& affected) {
    return affected.options.initial.positions.size() > 0 ? affected.options.initial.positions
                                                         : affected.model.body->mesh.nodes;
}

/// Whether two models have the same unknowns and state variables.
bool same_structure(const model::Model& a, const model::Model& b) {
    return a.body->clamped == b.body->clamped && a.creep.has_value() == b.creep.has_value() &&
           a.softening.has_value() == b.softening.has_value();
}

}  // namespace

std::optional<sensitivity::ModelTangent> affected_tangent(const Affected& under, const Affected& between,
                                                          const Affected& over, double width) {
    // Runs with different unknowns have no common tangent.
    if (!(width > 0.0) || !same_structure(under.model, between.model) || !same_structure(over.model, between.model))
        return std::nullopt;
    sensitivity::ModelTangent tangent;
    // The tangent run evaluates forces and masses of both models and divides their difference by the width.
    tangent.between = std::make_shared<sensitivity::ModelPair>(sensitivity::ModelPair{under.model, over.model, width});
    tangent.start_m = (start_of(over) - start_of(under)) / width;
    // Held nodes stay; a change of their position acts through the pair of models.
    tangent.start_m = model::free_part(*between.model.body, tangent.start_m);
    return tangent;
}

}  // namespace myo::effect
