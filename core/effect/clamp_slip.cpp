#include <algorithm>
#include <cmath>

#include "effect/effects.hpp"
#include "effect/places.hpp"
#include "effect/released_body.hpp"
#include "mesh/region.hpp"
#include "model/anchorage.hpp"

namespace myo {
namespace {

constexpr const char* length = "free_length_m";

/// How fast the anchorage lets go: stiff beside the material, so that what is held stands still.
constexpr double stiffer_than_material = 300.0;

/// As a share of those of a cell that is held altogether, the springs of one whose part f is held: it bends like one of length (1 - f) h, which
/// springs of E / h f / (1 - f) per area of its free face make of it, in series with those that hold a cell altogether. Lumped at the nodes, half of a
/// cell's springs are there. So the free length moves evenly through the cells, which springs of f alone would hold nearly rigidly.
double held_share(double f, double relative_modulus) {
    const double springs = 2.0 * relative_modulus / stiffer_than_material * f;
    return f < 1.0 ? springs / (1.0 - f + springs) : 1.0;
}

/// Everything inside the clamp is released, and what still holds is tied to its place cell by cell.
void apply(const EffectSite& site, const EffectParameters& parameters, Affected& affected) {
    const Body& body = *site.body;
    const ClampAxis clamp = clamp_axis(site);
    const double free_m = std::min(number(parameters, length), clamp.held_m);
    if (!(free_m > 0.0) || !(clamp.held_m > 0.0)) return;
    const double edge = clamp.begin_m - clamp.sign * free_m;
    std::vector<int> released;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)] && clamp.sign * (body.mesh.nodes(clamp.axis, i) - edge) > -0.5 * clamp.held_m) released.push_back(i);
    Box held = bounding_box(body.mesh.nodes);
    (clamp.sign > 0.0 ? held.highest : held.lowest)(clamp.axis) = edge;
    const Moduli& material = affected.model.moduli.front();
    const double spread = std::cbrt(body.unit_mass.sum() / body.cell_count());
    const double relative_modulus = young_from_moduli(material).youngs_modulus_Pa / material.mu;
    const Eigen::VectorXd share = volume_fractions(body.mesh, held).unaryExpr([&](double f) { return held_share(f, relative_modulus); });
    affected.model.body = released_body(*affected.model.body, released);
    affected.model.force_elements.push_back(anchorage(body, share, stiffer_than_material * material.mu / (spread * spread)));
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    const ClampAxis clamp = clamp_axis(search.sites.front());
    std::vector<EffectProbe> list;
    // A clamp that is a face alone has no part that could slip.
    if (clamp.held_m > 0.0)
        for (const double part : {0.25, 0.6}) list.push_back(probe({{length, part * clamp.held_m}}, length));
    return list;
}

}  // namespace

Effect clamp_slip() {
    return {"clamp_slip", EffectStage::support, "the part of the clamp next to its free end does not hold", {fitted_number(length, 0.0, 10.0, 0.003)}, apply, probes};
}

}  // namespace myo
