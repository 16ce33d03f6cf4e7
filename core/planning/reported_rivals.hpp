#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "diagnosis/diagnosis.hpp"
#include "planning/rivals.hpp"

namespace myo::planning {

/// The two sets of effects of a finished diagnosis, from its JSON report, that are most worth telling apart: the
/// heaviest fits that hold one and not the other of the first effects `not_told_apart`, or else the two heaviest fits.
///
/// Errors (place: the file): it cannot be read; it is no report of a diagnosis; it has fewer than two fits, or names an
/// effect that is not known.
Result<std::array<RivalStart, 2>> reported_rivals(const std::filesystem::path& report, const effect::Laws& laws = {});

/// The two rivals of a diagnosis that has just ended, for its effects `not_told_apart`. Empty if there are none, or if
/// one of them was not fitted without the other.
std::optional<std::array<Rival, 2>> diagnosed_rivals(const diagnosis::Diagnosis& diagnosis);

}  // namespace myo::planning
