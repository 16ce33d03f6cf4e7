#include "setup/held_nodes.hpp"

#include <set>
#include <string>

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
    std::set<int> distinct;  // boxes may overlap, so nodes are counted once
    // Whether these nodes leave none free.
    const auto clamp = [&](const std::vector<int>& nodes) {
        held.clamped.insert(held.clamped.end(), nodes.begin(), nodes.end());
        distinct.insert(nodes.begin(), nodes.end());
        return static_cast<Eigen::Index>(distinct.size()) == mesh.mesh.node_count();
    };
    if (experiment::has_clamp(experiment)) {
        const std::vector<int> nodes = nodes_in(experiment.clamp_box_m);
        if (nodes.empty()) return none("clamp.box_m");
        if (clamp(nodes)) return experiment::holds_whole_body(experiment, "clamp.box_m");
    }
    for (std::size_t i = 0; i < experiment.supports.size(); ++i) {
        const experiment::SupportDeclaration& support = experiment.supports[i];
        const std::string key = "support[" + std::to_string(i) + "].box_m";
        const std::vector<int> nodes = nodes_in(support.box_m);
        if (nodes.empty()) return none(key);
        if (!support.clamps())
            for (const int node : nodes) held.guided.push_back({node, support.held});
        else if (clamp(nodes))
            return experiment::holds_whole_body(experiment, key);
    }
    return held;
}

}  // namespace myo::setup
