#include "model/held_nodes.hpp"

namespace myo::model {

std::vector<int> held_nodes(const Body& body) {
    std::vector<int> held;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) held.push_back(i);
    return held;
}

}  // namespace myo::model
