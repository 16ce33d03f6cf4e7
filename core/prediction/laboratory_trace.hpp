#pragma once

#include <cstddef>
#include <optional>

#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Positions and velocities of a run in the laboratory, where cameras stand, instead of in the frame of its mount; none
/// where the mount stands still and both are the same.
///
/// @param values  of the run
std::optional<dynamics::Trace> laboratory_trace(const setup::Setup& setup, std::size_t trial,
                                                const ParameterValues& values, const dynamics::Trace& trace);

}  // namespace myo::prediction
