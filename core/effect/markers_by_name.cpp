#include "effect/markers_by_name.hpp"

#include <algorithm>

namespace myo::effect {

int marker_number(const TrialContext& context, const std::string& name) {
    const auto found = std::find(context.marker_names.begin(), context.marker_names.end(), name);
    return found == context.marker_names.end() ? -1 : static_cast<int>(found - context.marker_names.begin());
}

}  // namespace myo::effect
