#include <cmath>
#include <limits>

#include "effect/bent_cantilever.hpp"
#include "effect/effect.hpp"
#include "effect/places.hpp"

namespace myo::effect {
namespace held_pose_parts {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* offset = "offset_m";  // of the centre of the free end

/// Centre of the bounding box of the nodes in the plane of the free end.
Vector3d end_centre(const TrialContext& context, const ClampAxis& clamp) {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const auto& X : context.body->mesh.nodes.colwise()) {
        // Nodes of the end plane within rounding.
        if (clamp.ahead(X) < (1.0 - 1e-6) * clamp.length_m) continue;
        low = low.cwiseMin(X);
        high = high.cwiseMax(X);
    }
    return 0.5 * (low + high);
}

/// Shear parameter E I / (k G A L^2) of the mean cross-section for bending along a unit vector, with Cowper's shear
/// coefficient k of a rectangle (1966).
double shear_of(const TrialContext& context, const model::Model& model, const ClampAxis& clamp, const Vector3d& along) {
    const Eigen::SparseMatrix<double>& volume = context.body->unit_mass;
    const VectorXd y = context.body->mesh.nodes.transpose() * along, of_node = volume * VectorXd::Ones(y.size());
    const double whole = of_node.sum(), middle = of_node.dot(y) / whole;
    const VectorXd off = y.array() - middle;
    material::Moduli sum;
    for (const material::Moduli& m : model.moduli) {
        sum.mu += m.mu;
        sum.kappa += m.kappa;
    }
    // The ratio of the sums suffices for Poisson's ratio. E / G = 2 (1 + nu); I / A is the variance of y over the
    // volume.
    const double nu = material::young_from_moduli(sum).poissons_ratio, k = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    return 2.0 * (1.0 + nu) / k * off.dot(volume * off) / whole / (clamp.length_m * clamp.length_m);
}

/// Default direction of the offset: against gravity, perpendicular to the axis; if gravity is parallel to the axis, the
/// next coordinate.
Vector3d upwards(const Vector3d& gravity, const Vector3d& axis, int axis_number) {
    // Without gravity: along z.
    const Vector3d up = gravity.norm() > 0.0 ? Vector3d(-gravity.normalized()) : Vector3d(Vector3d::UnitZ());
    const Vector3d across = up - up.dot(axis) * axis;
    return across.norm() > 1e-3 ? Vector3d(across.normalized()) : Vector3d(Vector3d::Unit((axis_number + 1) % 3));
}

/// Start positions of a cantilever bent by a transverse force at its end, such that the centre of the end is displaced
/// by `offset`.
///
/// Sections rotate and stay plane and undeformed; the axis keeps its length, so that the end also approaches the clamp.
/// The axial component of the offset is therefore not independent and is ignored. Bending is in the plane of axis and
/// offset.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    // Other trials do not start from the rest shape.
    if (context.start != dynamics::StartKind::straight) return;
    const ClampAxis clamp = clamp_axis(context);
    const Vector3d axis = clamp.sign * Vector3d::Unit(clamp.axis);
    Vector3d end = upwards(affected.model.gravity_m_s2, axis, clamp.axis);
    // A plain number is an offset in the default direction.
    if (std::holds_alternative<VectorXd>(parameters.at(offset)))
        end = vector(parameters, offset);
    else
        end *= number(parameters, offset);
    end -= end.dot(axis) * axis;
    if (end.norm() == 0.0) return;
    const Vector3d across = end.normalized();
    const BentCantilever bent = bent_cantilever(end.norm() / clamp.length_m,
                                                shear_of(context, affected.model, clamp, across));
    const Vector3d centre = end_centre(context, clamp);
    Matrix3Xd x = affected.options.initial.positions.size() > 0 ? affected.options.initial.positions
                                                                : affected.model.body->mesh.nodes;
    // Added to the start as it is, which an earlier effect may have changed; sections refer to the declared body.
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        const Vector3d X = context.body->mesh.nodes.col(i);
        const double s = clamp.ahead(X) / clamp.length_m;
        if (s <= 0.0) continue;  // within the clamp
        // Displacement of the section centre plus rotation about it; r is the distance from the neutral axis.
        const BeamSection section = bent.at(s);
        const double r = (X - centre).dot(across);
        x.col(i) += (clamp.length_m * (section.along - s) - r * std::sin(section.turn_rad)) * axis;
        x.col(i) += (clamp.length_m * section.across + r * (std::cos(section.turn_rad) - 1.0)) * across;
    }
    affected.options.initial.positions = std::move(x);
}

/// The offset is a vector: columns add linearly.
EffectParameters joined(const std::vector<EffectParameters>& columns, const VectorXd& multiples) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i)
        sum += multiples(static_cast<Eigen::Index>(i)) * vector(columns[i], offset);
    EffectParameters result = columns.front();
    result[offset] = VectorXd(sum);
    return result;
}

/// Per trial that starts from the straight shape: the two transverse directions.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    for (const TrialContext& context : search.trials) {
        if (context.start != dynamics::StartKind::straight) continue;
        EffectProbe probe;
        const int along = clamp_axis(context).axis;
        for (int axis = 0; axis < 3; ++axis)
            if (axis != along)
                probe.columns.push_back({{offset, VectorXd(1e-3 * Vector3d::Unit(axis))}, {"trial", context.trial}});
        probe.joined = joined;
        list.push_back(std::move(probe));
    }
    return list;
}

/// An offset across the body, in the first trial that starts straight.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    for (const DrawTrial& trial : context.trials)
        if (trial.starts_straight)
            return {{offset, VectorXd(1e-3 * Vector3d(0.0, std::cos(angle), std::sin(angle)))}, {"trial", trial.name}};
    return {{offset, VectorXd(Vector3d(0.0, 0.0, 1e-3))}};
}

}  // namespace held_pose_parts

Effect held_pose() {
    using namespace held_pose_parts;
    return {.id = "held_pose",
            .kind = EffectKind::support,
            .summary = "the body was not held in its rest shape before the release",
            .parameters = {{offset, EffectParameterKind::number_or_vector3, false, -1.0, 1.0, 2e-3},
                           {"trial", EffectParameterKind::trial, true}},
            .apply = apply,
            .probes = probes,
            .draw = {
                .needs = {.straight_start = true}, .amount = offset, .lowest = 3e-4, .highest = 0.02, .others = drawn}};
}

}  // namespace myo::effect
