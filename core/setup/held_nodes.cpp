#include "setup/held_nodes.hpp"

#include <set>

#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/region.hpp"

namespace myo::setup {

Result<HeldNodes> held_nodes(const experiment::Experiment& experiment, const BodyMesh& mesh, const Box& body) {
    // The mesh conforms to the part of the body that a box really holds, see held_part().
    const auto nodes_in = [&](const Box& box) {
        return mesh::nodes_in_box(mesh.mesh, box_on_mesh(mesh, held_part(box, body)));
    };
    const auto none = [&](const std::string& key) {
        return experiment::declaration_error(
            experiment, key, "no node of the mesh lies in the box; choose a finer resolution or a deeper box");
    };
    HeldNodes held;
    if (experiment::has_clamp(experiment)) {
        held.clamped = nodes_in(experiment.clamp_box_m);
        if (held.clamped.empty()) return none("clamp.box_m");
    }
    for (std::size_t i = 0; i < experiment.supports.size(); ++i) {
        const experiment::SupportDeclaration& support = experiment.supports[i];
        const std::vector<int> nodes = nodes_in(support.box_m);
        if (nodes.empty()) return none("support[" + std::to_string(i) + "].box_m");
        for (const int node : nodes)
            if (support.clamps())
                held.clamped.push_back(node);
            else
                held.guided.push_back({node, support.held});
    }
    // Boxes may overlap, so nodes are counted once.
    const std::set<int> distinct(held.clamped.begin(), held.clamped.end());
    if (static_cast<Eigen::Index>(distinct.size()) == mesh.mesh.node_count())
        return experiment::holds_whole_body(experiment);
    return held;
}

}  // namespace myo::setup
