#include "model/held_nodes.hpp"

namespace myo::model {

std::vector<int> held_nodes(const Body& body) {
    std::vector<int> held;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) held.push_back(i);
    return held;
}

std::vector<int> support_nodes(const Body& body) {
    std::vector<int> nodes = held_nodes(body);
    if (nodes.empty())
        for (const GuidedNode& guided : body.guided) nodes.push_back(guided.node);
    return nodes;
}

}  // namespace myo::model
