#include "effect/markers_by_name.hpp"

#include <algorithm>

namespace myo::effect {

int marker_number(const EffectSite& site, const std::string& name) {
    const auto found = std::find(site.marker_names.begin(), site.marker_names.end(), name);
    return found == site.marker_names.end() ? -1 : static_cast<int>(found - site.marker_names.begin());
}

}  // namespace myo::effect
