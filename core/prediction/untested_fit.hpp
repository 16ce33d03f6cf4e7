#pragma once

#include <optional>
#include <string>

namespace myo::setup {
struct Setup;
}  // namespace myo::setup

namespace myo::prediction {

/// A warning where no trial has the role validate: nothing is left to test a fit on. For what fits; a run of declared
/// values needs no test.
std::optional<std::string> untested_fit(const setup::Setup& setup);

}  // namespace myo::prediction
