#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"

namespace myo::setup {
struct Setup;
}  // namespace myo::setup

namespace myo::prediction {

/// Error if no trial has role fit: there is nothing to compare a model with.
Result<void> require_fit_trial(const setup::Setup& setup);

/// Warning if no trial has role validate, so that a fit cannot be tested. For commands that fit; a run with declared
/// values needs no test.
std::optional<std::string> untested_fit(const setup::Setup& setup);

}  // namespace myo::prediction
