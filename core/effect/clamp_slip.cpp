#include <algorithm>
#include <limits>

#include "effect/changed_body.hpp"
#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "fibre/moved_fibres.hpp"
#include "mesh/cell_topology.hpp"

namespace myo::effect {
namespace clamp_slip_parts {

constexpr const char* length = "free_length_m";  // of the clamp's depth, from its front on

struct ClampSlipPolicy {
    /// The cells absorb the free length over at most this fraction of the body length.
    double farthest = 0.5;
    /// The shift is distributed over at least this fraction of the clamp depth, more for a long slip; and this fraction
    /// of the depth always remains clamped.
    double min_absorbing_part = 0.5;
    double left_of_depth = 0.05;
    /// A drawn slip is at most this part of the clamp's depth, so that the body is still held.
    double max_drawn_part = 0.8;
};
constexpr ClampSlipPolicy clamp_slip_policy;

/// Distance from the clamp to the first node that carries a marker or a muscle [m].
double first_load(const TrialContext& context, const model::Model& model, const ClampAxis& clamp) {
    const mesh::VolumeMesh& mesh = model.body->mesh;
    double first = clamp_slip_policy.farthest * clamp.length_m;
    // A fibre point acts on all nodes of its cell, so that none of them may stretch.
    const auto at = [&](int node) { first = std::min(first, clamp.ahead(mesh.nodes.col(node))); };
    for (const measurement::MarkerBinding& marker : context.markers)
        std::for_each(marker.nodes.begin(), marker.nodes.end(), at);
    for (const fibre::FibreGroup& group : *model.fibres)
        for (const fibre::FibrePoint& point : group.points)
            for (const int node : mesh.cells.col(point.cell)) at(node);
    return first;
}

/// Keeps mid-edge nodes at the middle of their edges: if such a node stayed behind while the end of its edge moved by
/// half the length, the cell would become singular.
void straighten(const mesh::VolumeMesh& mesh, Eigen::Matrix3Xd& shift) {
    if (mesh.type != mesh::CellType::tet10) return;
    for (const auto& cell : mesh.cells.colwise())
        for (std::size_t e = 0; e < mesh::tetrahedron_edges.size(); ++e)
            shift.col(cell(4 + static_cast<Eigen::Index>(e))) = 0.5 * (shift.col(cell(mesh::tetrahedron_edges[e][0])) +
                                                                       shift.col(cell(mesh::tetrahedron_edges[e][1])));
}

/// Nodal shift for a body whose clamp ends farther back, 3 x n [m].
///
/// Clamped nodes move backwards, the far end of the clamp stays, and the cells in front stretch to fill the space:
/// those next to the clamp, or all that carry no marker or muscle. Thus the free length grows continuously with the
/// same unknowns, whether it is a fraction of a cell or several cells. The cells at the clamp keep nearly the same
/// size, which matters because short cells restrain a nearly incompressible body more.
Eigen::Matrix3Xd set_back(const TrialContext& context, const model::Model& model, const ClampAxis& clamp,
                          double free_m) {
    const Eigen::Matrix3Xd& X = model.body->mesh.nodes;
    const double reach = first_load(context, model, clamp),
                 taken_up_m = std::clamp(free_m / (1.0 - 2.0 * clamp_slip_policy.left_of_depth),
                                         clamp_slip_policy.min_absorbing_part * clamp.held_m, clamp.held_m);
    Eigen::Matrix3Xd shift = Eigen::Matrix3Xd::Zero(3, X.cols());
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
        const double ahead = clamp.ahead(X.col(i));
        const bool held = context.body->clamped[static_cast<std::size_t>(i)];
        // Fraction of the slip: 1 at the front of the clamp, decreasing to 0 at its far end and over the cells in
        // front.
        const double part = held          ? std::min(1.0, (clamp.held_m + ahead) / taken_up_m)
                            : reach > 0.0 ? std::clamp(1.0 - ahead / reach, 0.0, 1.0)
                                          : 0.0;
        shift(clamp.axis, i) = -clamp.sign * part * free_m;
    }
    straighten(model.body->mesh, shift);
    return shift;
}

/// Lengthens the free part of the body backwards into the clamp, without new unknowns, see set_back().
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const ClampAxis clamp = clamp_axis(context);
    const double free_m = std::min(number(parameters, length), (1.0 - clamp_slip_policy.left_of_depth) * clamp.held_m);
    if (!(free_m > 0.0)) return;
    model::Model& model = affected.model;
    const mesh::VolumeMesh declared = model.body->mesh;
    const Eigen::Matrix3Xd shift = set_back(context, model, clamp, free_m);
    // Rest positions change, and with them mass and volumes: the cells are undeformed in their new shape.
    model.body = on_nodes(*model.body, declared.nodes + shift);
    // Fibres are defined per cell: adapt them to the moved nodes.
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const fibre::FibreGroup& group : *model.fibres)
        fibres->push_back(fibre::moved_fibres(declared, model.body->mesh, group));
    model.fibres = fibres;
    Eigen::Matrix3Xd& start = affected.options.initial.positions;
    // Given start positions follow the nodes.
    if (start.size() > 0) start += shift;

    // Markers on the shifted cells have not moved on the real body: compensate in the recording.
    for (std::size_t m = 0; m < context.markers.size(); ++m) {
        const Eigen::Vector3d moved = shift(Eigen::all, context.markers[m].nodes) * context.markers[m].weights;
        if (!moved.isZero(0.0))
            affected.observation_error.shifts.push_back({m, -moved, -std::numeric_limits<double>::infinity()});
    }
}

/// A short and a long slip: the response of a bent body is not proportional to the free length.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const ClampAxis clamp = clamp_axis(search.trials.front());
    std::vector<EffectProbe> list;
    // A clamp that consists of a face only has no part that could slip.
    if (clamp.held_m > 0.0)
        for (const double part : {0.05, 0.5}) list.push_back(probe({{length, part * clamp.held_m}}, length));
    return list;
}

/// Largest free length that is drawn [m].
double drawn_limit(const DrawContext& context) { return clamp_slip_policy.max_drawn_part * context.held_m; }

}  // namespace clamp_slip_parts

Effect clamp_slip() {
    using namespace clamp_slip_parts;
    return {
        .id = "clamp_slip",
        .kind = EffectKind::support,
        .summary = "the part of the clamp next to its free end does not hold",
        .parameters = {fitted_number(length, 0.0, 10.0, 0.003)},
        .apply = apply,
        .probes = probes,
        .clamp_shortening = length,
        .draw = {
            .needs = {.deep_clamp = true}, .amount = length, .lowest = 1e-3, .highest = 0.02, .limit = drawn_limit}};
}

}  // namespace myo::effect
