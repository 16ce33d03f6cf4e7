#pragma once

#include <string>

#include "setup/setup.hpp"

namespace myo::diagnosis {

/// Text that distinguishes setups in a FitStore: name, mesh, integrator, and a hash of what fits depend on apart from
/// steps and start values (recordings, loads, declared parameters).
std::string store_words(const setup::Setup& setup);

}  // namespace myo::diagnosis
