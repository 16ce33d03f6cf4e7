#include "diagnosis/missing_force/effect_forces.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

#include "model/force_element.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

/// Positions [m], velocities [m/s] and accelerations [m/s2] of the nodes at a step, 3 x n each.
struct StateView {
    const Matrix3Xd& x;
    const Matrix3Xd& v;
    Matrix3Xd a;
    double time_s = 0.0;
};

/// State at step k. The acceleration is a central difference of the velocities, one-sided at the ends.
StateView moment_of(const dynamics::Trace& motion, std::size_t k) {
    const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, motion.times_s.size() - 1);
    const double span = motion.times_s[after] - motion.times_s[before];
    return {motion.positions[k], motion.velocities[k], (motion.velocities[after] - motion.velocities[before]) / span,
            motion.times_s[k]};
}

/// Sum of the nodal forces of one model, inertia included.
class Forces {
public:
    explicit Forces(model::Model model) : model_(std::move(model)) {
        // Memory of past motion is the same in both models and cancels.
        model_.creep.reset();
        model_.softening.reset();
        stiffness_ = model::stiffness(model_);
        masses_ = model::mass_spans(model_);
    }

    /// External, velocity, elastic and viscous forces minus inertia, 3 x n [N].
    Matrix3Xd at(const StateView& m) const {
        const std::vector<double> activation = model::activations(model_, m.time_s);
        model::InternalInput input;
        input.stiffness = &stiffness_;
        input.activation = &activation;
        const Eigen::VectorXd rate = model::strain_tangent(model_, m.x, m.v);
        input.rate = {0.0, &rate};
        model::InternalEnergy internal = model::internal_energy(model_, m.x, input, model::HessianKind::none);
        // The velocity factor scales potentials of velocity-dependent forces, not their gradients.
        model::add_force_elements(model_, {m.x, &m.v, 1.0, m.time_s, false}, model::HessianKind::none, internal);
        const model::MassMatrix& mass = masses_[model::span_at(masses_, m.time_s)].mass;
        return model::external_forces(model_, mass, m.time_s) +
               model_.velocity_force_1_s * model::times_mass(m.v, mass) - internal.gradient -
               model::times_mass(m.a, mass);
    }

    const model::Body& body() const { return *model_.body; }

private:
    model::Model model_;
    model::Stiffness stiffness_;
    std::vector<model::MassSpan> masses_;
};

}  // namespace

NodalForces effect_forces(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                          std::size_t first, const dynamics::Trace& motion, int most) {
    assert(first <= values.effects.size() && most > 0);
    NodalForces result;
    if (motion.times_s.size() < 2) {
        result.failure = "the trial was not run";
        return result;
    }
    prediction::ParameterValues plain = values;
    // Both models share values and declared effects; only the effects from `first` on differ.
    plain.effects.resize(first);
    const effect::Affected affected = prediction::affected_trial(setup, trial, values),
                           unaffected = prediction::affected_trial(setup, trial, plain);
    if (affected.model.creep.has_value() != unaffected.model.creep.has_value() ||
        affected.model.softening.has_value() != unaffected.model.softening.has_value()) {
        result.failure = "it is a memory of the past motion";
        return result;
    }
    const Forces with(affected.model), without(unaffected.model);
    const std::size_t stride = std::max<std::size_t>(1, motion.times_s.size() / static_cast<std::size_t>(most));
    for (std::size_t k = 0; k < motion.times_s.size(); k += stride) {
        const StateView m = moment_of(motion, k);
        // An effect may change the support: nodes held in either model carry no force.
        Matrix3Xd force = model::free_part(with.body(), model::free_part(without.body(), with.at(m) - without.at(m)));
        result.times_s.push_back(m.time_s);
        result.force_N.push_back(std::move(force));
    }
    return result;
}

Matrix3Xd BodyPatches::sums(const Matrix3Xd& of_nodes) const {
    assert(of_nodes.cols() == patch_of_node.size());
    Matrix3Xd result = Matrix3Xd::Zero(3, count);
    for (Index i = 0; i < of_nodes.cols(); ++i) result.col(patch_of_node(i)) += of_nodes.col(i);
    return result;
}

BodyPatches body_patches(const model::Body& body, int about) {
    const Matrix3Xd& X = body.mesh.nodes;
    const Eigen::Vector3d lowest = X.rowwise().minCoeff(), extent = X.rowwise().maxCoeff() - lowest;
    // Boxes of the bounding box: the body fills only a part of them, so that their number is approximate.
    const double edge = std::cbrt(body.volume_m3 / about);
    const Eigen::Array3d cubes = (extent.array() / edge).round().max(1.0);
    std::map<std::array<int, 3>, int> number;
    BodyPatches patches;
    patches.patch_of_node.resize(X.cols());
    for (Index i = 0; i < X.cols(); ++i) {
        std::array<int, 3> cube{};
        for (Index axis = 0; axis < 3; ++axis) {
            const double place = extent(axis) > 0.0 ? (X(axis, i) - lowest(axis)) / extent(axis) : 0.0;
            cube[static_cast<std::size_t>(axis)] = std::clamp(static_cast<int>(place * cubes(axis)), 0,
                                                              static_cast<int>(cubes(axis)) - 1);
        }
        patches.patch_of_node(i) = number.emplace(cube, static_cast<int>(number.size())).first->second;
    }
    patches.count = static_cast<int>(number.size());
    return patches;
}

BodyPatches patches_on(const model::Body& other, const model::Body& body, const BodyPatches& patches) {
    BodyPatches result{Eigen::VectorXi(other.mesh.nodes.cols()), patches.count};
    for (Index i = 0; i < other.mesh.nodes.cols(); ++i) {
        Index nearest = 0;
        (body.mesh.nodes.colwise() - other.mesh.nodes.col(i)).colwise().squaredNorm().minCoeff(&nearest);
        result.patch_of_node(i) = patches.patch_of_node(nearest);
    }
    return result;
}

}  // namespace myo::diagnosis
