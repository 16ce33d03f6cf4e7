#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::measurement {

/// Index of a label, or nothing.
std::optional<std::size_t> label_index(const Recording& recording, const std::string& label);

/// The same recording seen from another frame; gaps stay gaps.
Recording transform(const Recording& recording, const RigidMotion& motion);

/// The samples first <= k < end; times are kept. Both bounds must lie in [0, sample_count].
Recording slice(const Recording& recording, Eigen::Index first, Eigen::Index end);

/// The samples with from_s <= time <= to_s; times are kept.
Recording slice_time(const Recording& recording, double from_s, double to_s);

/// Times moved by `by_s`: time_s + by_s.
Recording shift_time(const Recording& recording, double by_s);

/// The tracks of the given labels in the given order, optionally under new names (same length as labels, or empty).
/// Error: a label that the recording does not have; the closest one is named.
Result<Recording> select_labels(const Recording& recording, const std::vector<std::string>& labels,
                                const std::vector<std::string>& new_names = {});

}  // namespace myo::measurement
