#include "base/text.hpp"
#include "check/checks.hpp"

namespace myo::check {

std::vector<Finding> check_places(const CheckedJob& job) {
    std::vector<Finding> findings;
    if (job.calibration == nullptr || job.calibration->places.empty()) return findings;
    const double deviations = prediction::far_place_policy.max_deviations;
    const std::vector<Eigen::Vector3d>& places = job.calibration->after.values.places_m;
    for (const std::size_t marker : prediction::far_markers(job.setup, places)) {
        Finding finding = passed_finding(job.setup.marker_names[marker],
                                         prediction::far_marker_sentence(job.setup, marker, places[marker]));
        finding.level = CheckLevel::doubtful;
        // The deviation is declared per coordinate, so the largest coordinate of the shift is compared with it.
        finding.figure = places[marker].cwiseAbs().maxCoeff();
        finding.threshold = deviations * job.setup.experiment.markers.placement_m;
        finding.unit = "m";
        finding.way_out = "check its rest position and its name, or state a larger placement_m";
        findings.push_back(std::move(finding));
    }
    if (findings.empty())
        findings.push_back(passed_finding("", "the markers sit where they are declared, within " +
                                                  format_number(deviations) + " times markers.placement_m"));
    return findings;
}

}  // namespace myo::check
