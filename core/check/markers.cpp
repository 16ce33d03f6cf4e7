#include <algorithm>

#include "check/checks.hpp"
#include "measurement/marker_binding.hpp"
#include "mesh/closest_point.hpp"
#include "mesh/quality.hpp"
#include "report/length.hpp"
#include "setup/setting_words.hpp"

namespace myo::check {
namespace {

struct MarkersPolicy {
    /// Markers closer than this share of an edge lie in one cell and only resolve its linear strain.
    double min_edge_share = 0.25;
};
constexpr MarkersPolicy markers_policy;

/// Markers farther from the mesh than they may be from the surface: its cells are too coarse to reach them.
std::vector<Finding> off_the_mesh(const setup::Setup& setup,
                                  const std::vector<experiment::MarkerDeclaration>& markers) {
    std::vector<Finding> findings;
    const mesh::BoundaryLocator locator(setup.mesh.mesh);
    const double reach_m = setup.experiment.markers.max_standoff_m;
    for (const experiment::MarkerDeclaration& marker : markers) {
        // The declared surface was checked when the experiment was read; here the surface of the mesh counts.
        const double standoff_m = measurement::bind_marker(setup.mesh.mesh, locator, marker.rest_m).standoff_m();
        if (standoff_m <= reach_m) continue;
        Finding finding = passed_finding(
            marker.name, "marker " + marker.name + " is " + report::length_words(standoff_m) +
                             " off the mesh, whose cells do not follow the body there; it may be off by " +
                             report::length_words(reach_m));
        finding.level = CheckLevel::doubtful;
        finding.figure = standoff_m;
        finding.threshold = reach_m;
        finding.unit = "m";
        finding.way_out = std::string("choose shorter edges (") + setup::edge_setting + ") or tetrahedra";
        findings.push_back(std::move(finding));
    }
    return findings;
}

/// The nearest two markers, against the length over which the mesh resolves a strain.
Finding nearest_markers(const setup::Setup& setup, const std::vector<experiment::MarkerDeclaration>& markers) {
    const double edge = mesh::mean_edge_length(setup.mesh.mesh);
    std::size_t first = 0, second = 0;
    double nearest = std::numeric_limits<double>::infinity();
    // All pairs: there are tens of markers at most.
    for (std::size_t a = 0; a < markers.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (const double distance = (markers[a].rest_m - markers[b].rest_m).norm(); distance < nearest) {
                nearest = distance;
                first = b;
                second = a;
            }
    // A single marker resolves no strain.
    if (markers.size() < 2) return passed_finding("", "one marker, which any mesh holds");
    const std::string pair = "markers " + markers[first].name + " and " + markers[second].name + " are " +
                             report::length_words(nearest) + " apart";
    Finding finding = passed_finding("", pair + ", the nearest ones, with edges of " + report::length_words(edge));
    finding.figure = nearest;
    finding.threshold = markers_policy.min_edge_share * edge;
    finding.unit = "m";
    if (nearest >= finding.threshold) return finding;
    finding.level = CheckLevel::doubtful;
    finding.sentence = pair + " and the mesh's edges " + report::length_words(edge) +
                       " long: the strain between them is lost";
    finding.way_out = std::string("choose shorter edges (") + setup::edge_setting + "), or compare one of them";
    return finding;
}

}  // namespace

std::vector<Finding> check_markers(const CheckedJob& job) {
    // Probes are compared with nothing, so they may lie anywhere.
    std::vector<experiment::MarkerDeclaration> markers = job.setup.experiment.markers.on_body;
    std::erase_if(markers, [](const experiment::MarkerDeclaration& marker) { return marker.probe; });
    std::vector<Finding> findings{nearest_markers(job.setup, markers)};
    for (Finding& finding : off_the_mesh(job.setup, markers)) findings.push_back(std::move(finding));
    return findings;
}

}  // namespace myo::check
