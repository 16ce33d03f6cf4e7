#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// Index of a label; nullopt if the recording does not contain it.
std::optional<std::size_t> label_index(const Recording& recording, const std::string& label);

/// The recording transformed to another frame. Gaps stay gaps.
Recording transform(const Recording& recording, const RigidMotion& motion);

/// Samples first <= k < end; times are not shifted. Asserts that both bounds lie in [0, sample_count].
Recording slice(const Recording& recording, Eigen::Index first, Eigen::Index end);

/// Samples with from_s <= time <= to_s; times are not shifted.
Recording slice_time(const Recording& recording, double from_s, double to_s);

/// The recording with `by_s` added to all times.
Recording shift_time(const Recording& recording, double by_s);

/// Tracks of the given labels in the given order, optionally renamed.
///
/// @param new_names  as many as labels, or empty
/// Errors: a label that the recording does not contain; the closest one is suggested.
Result<Recording> select_labels(const Recording& recording, const std::vector<std::string>& labels,
                                const std::vector<std::string>& new_names = {});

}  // namespace myo::measurement
