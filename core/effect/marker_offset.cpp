#include <algorithm>

#include "effect/effect.hpp"
#include "effect/markers_by_name.hpp"
#include "measurement/marker_places.hpp"

namespace myo::effect {
namespace marker_offset_parts {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct MarkerOffsetPolicy {
    double probed_m = 1e-3;  // as well as markers are stuck on by eye
};
constexpr MarkerOffsetPolicy marker_offset_policy;

/// Place in the list of the error at which the place of a marker stands; a new one, as declared, if there is none.
measurement::MarkerPlace& place_of(const TrialContext& context, std::size_t marker,
                                   measurement::ObservationError& error) {
    const auto found = std::find_if(error.places.begin(), error.places.end(),
                                    [&](const measurement::MarkerPlace& place) { return place.marker == marker; });
    if (found != error.places.end()) return *found;
    error.places.push_back({marker, Vector3d::Zero(), context.markers[marker]});
    return error.places.back();
}

/// Binds the marker at the shifted place, so that it moves with the material there; a stalk keeps its length. Markers
/// that are not on the body (fixed ones) are not compared and are ignored.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const int marker = marker_number(context, text(parameters, "marker"));
    if (marker < 0) return;
    measurement::MarkerPlace& place = place_of(context, static_cast<std::size_t>(marker), affected.observation_error);
    // Offsets of one marker by several declarations add.
    place.shift_m += vector(parameters, "shift_m");
    const mesh::VolumeMesh& mesh = context.body->mesh;
    place.binding = measurement::moved_binding(mesh, mesh::BoundaryLocator(mesh),
                                               context.markers[static_cast<std::size_t>(marker)], place.shift_m);
}

/// Shifts add like vectors.
EffectParameters joined(const std::vector<EffectParameters>& columns, const VectorXd& multiples) {
    Vector3d shift = Vector3d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i)
        shift += multiples(static_cast<Eigen::Index>(i)) * vector(columns[i], "shift_m");
    EffectParameters result = columns.front();
    result["shift_m"] = VectorXd(shift);
    return result;
}

/// Three columns per marker.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    for (const std::string& marker : search.trials.front().marker_names) {
        EffectProbe& probe = list.emplace_back();
        for (int axis = 0; axis < 3; ++axis)
            probe.columns.push_back(
                {{"marker", marker}, {"shift_m", VectorXd(marker_offset_policy.probed_m * Vector3d::Unit(axis))}});
        probe.joined = joined;
    }
    return list;
}

/// A random marker, shifted in a random direction; the amount scales the length.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const int marker = random.below(static_cast<int>(context.marker_names.size()));
    return {{"marker", context.marker_names[static_cast<std::size_t>(marker)]},
            {"shift_m", VectorXd(1e-3 * drawn_direction(random))}};
}

}  // namespace marker_offset_parts

Effect marker_offset() {
    using namespace marker_offset_parts;
    return {.id = "marker_offset",
            .kind = EffectKind::measurement,
            .summary = "a marker sits elsewhere on the body than declared, all along",
            .parameters = {{"marker", EffectParameterKind::marker},
                           {"shift_m", EffectParameterKind::vector3, false, -10.0, 10.0, 1e-3}},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = "shift_m", .lowest = 5e-4, .highest = 0.02, .others = drawn}};
}

}  // namespace myo::effect
