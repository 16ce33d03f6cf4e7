#include "base/text.hpp"
#include "check/checks.hpp"
#include "mesh/quality.hpp"
#include "project/mesh_suitability.hpp"

namespace myo {

std::vector<Finding> check_mesh(const CheckedJob& job) {
    const Study& study = job.study;
    std::vector<Finding> findings;
    for (const std::string& sentence : unsuitable({study.surface, study.mesh, study.experiment.effects})) {
        Finding finding = fine_finding("", sentence);   // which names its way out, too
        finding.level = CheckLevel::doubtful;
        finding.told = true;
        findings.push_back(std::move(finding));
    }
    if (findings.empty())
        findings.push_back(fine_finding("", std::to_string(study.mesh.mesh.cell_count()) + " cells with edges of " +
                                                format_number(1e3 * mean_edge_length(study.mesh.mesh), 3) +
                                                " mm bend and twist within a few percent"));
    return findings;
}

}  // namespace myo
