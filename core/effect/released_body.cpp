#include "effect/released_body.hpp"

namespace myo {

BodyPointer released_body(const Body& body, const std::vector<int>& nodes) {
    auto released = std::make_shared<Body>(body);
    for (const int node : nodes) released->clamped[static_cast<std::size_t>(node)] = false;
    released->pattern = block_pattern(released->mesh, released->clamped);
    return released;
}

}  // namespace myo
