#pragma once

#include <optional>
#include <string>

namespace myo::setup {
struct Setup;
}  // namespace myo::setup

namespace myo::prediction {

/// Warning if no trial has role validate, so that a fit cannot be tested. For commands that fit; a run with declared
/// values needs no test.
std::optional<std::string> untested_fit(const setup::Setup& setup);

}  // namespace myo::prediction
