#include <algorithm>
#include <limits>

#include "effect/changed_body.hpp"
#include "effect/effects.hpp"
#include "effect/places.hpp"
#include "fibre/moved_fibres.hpp"

namespace myo {
namespace {

constexpr const char* length = "free_length_m";

/// Cells take up the free length as far as so much of the body's length.
constexpr double farthest = 0.5;

/// How far in front of the clamp the first node lies that a marker or a muscle hangs on.
double first_load(const EffectSite& site, const Model& model, const ClampAxis& clamp) {
    const VolumeMesh& mesh = model.body->mesh;
    double first = farthest * clamp.length_m;
    const auto at = [&](int node) { first = std::min(first, clamp.ahead(mesh.nodes.col(node))); };
    for (const MarkerBinding& marker : site.markers) std::for_each(marker.nodes.begin(), marker.nodes.end(), at);
    for (const FibreGroup& group : *model.fibres)
        for (const FibrePoint& point : group.points)
            for (const int node : mesh.cells.col(point.cell)) at(node);
    return first;
}

/// The clamp stands further back: what it holds moves there, and the cells in front of it reach as far, those next to it alone or all that carry nothing. So the
/// free length grows evenly, with the same unknowns, whether it is a part of a cell or several, and the cells at the clamp hardly change, which hold a nearly
/// incompressible body the firmer the shorter they are.
void apply(const EffectSite& site, const EffectParameters& parameters, Affected& affected) {
    const ClampAxis clamp = clamp_axis(site);
    const double free_m = std::min(number(parameters, length), clamp.held_m);
    if (!(free_m > 0.0)) return;
    Model& model = affected.model;
    const VolumeMesh declared = model.body->mesh;
    const double reach = first_load(site, model, clamp);
    const std::vector<bool>& held = site.body->clamped;
    Eigen::Vector3d back = Eigen::Vector3d::Zero();
    back(clamp.axis) = -clamp.sign * free_m;
    const auto moved = [&](Eigen::Matrix3Xd nodes) {
        for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
            const double ahead = clamp.ahead(declared.nodes.col(i));
            if (held[static_cast<std::size_t>(i)]) nodes.col(i) += back;
            else if (reach > 0.0) nodes.col(i) += std::clamp(1.0 - ahead / reach, 0.0, 1.0) * back;
        }
        return nodes;
    };

    model.body = on_nodes(*model.body, moved(declared.nodes));
    auto fibres = std::make_shared<std::vector<FibreGroup>>();
    for (const FibreGroup& group : *model.fibres) fibres->push_back(moved_fibres(declared, model.body->mesh, group));
    model.fibres = fibres;
    Eigen::Matrix3Xd& start = affected.options.initial.positions;
    if (start.size() > 0) start = moved(start);

    // Nobody moved the markers on the first cells.
    for (std::size_t m = 0; m < site.markers.size(); ++m) {
        const MarkerBinding& marker = site.markers[m];
        double share = 0.0;
        for (std::size_t a = 0; a < marker.nodes.size(); ++a)
            if (held[static_cast<std::size_t>(marker.nodes[a])]) share += marker.weights(static_cast<Eigen::Index>(a));
        if (share != 0.0) affected.seen.shifts.push_back({m, -share * back, -std::numeric_limits<double>::infinity()});
    }
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    const ClampAxis clamp = clamp_axis(search.sites.front());
    std::vector<EffectProbe> list;
    // A clamp that is a face alone has no part that could slip.
    if (clamp.held_m > 0.0)
        for (const double part : {0.05, 0.5}) list.push_back(probe({{length, part * clamp.held_m}}, length));
    return list;
}

}  // namespace

Effect clamp_slip() {
    return {"clamp_slip", EffectStage::support, "the part of the clamp next to its free end does not hold", {fitted_number(length, 0.0, 10.0, 0.003)}, apply, probes};
}

}  // namespace myo
