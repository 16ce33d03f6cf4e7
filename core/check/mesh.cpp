#include "base/text.hpp"
#include "check/checks.hpp"
#include "mesh/quality.hpp"
#include "setup/mesh_suitability.hpp"

namespace myo::check {

std::vector<Finding> check_mesh(const CheckedJob& job) {
    const setup::Setup& setup = job.setup;
    std::vector<Finding> findings;
    // prepare_setup() warns by these checks already, hence `warned`.
    for (const std::string& sentence : setup::unsuitable({setup.surface, setup.mesh, setup.experiment.effects})) {
        Finding finding = passed_finding("", sentence);  // the sentence contains the remedy
        finding.level = CheckLevel::doubtful;
        finding.warned = true;
        findings.push_back(std::move(finding));
    }
    if (findings.empty())
        findings.push_back(passed_finding("", std::to_string(setup.mesh.mesh.cell_count()) + " cells with edges of " +
                                                  format_number(1e3 * mesh::mean_edge_length(setup.mesh.mesh), 3) +
                                                  " mm bend and twist within a few percent"));
    return findings;
}

}  // namespace myo::check
