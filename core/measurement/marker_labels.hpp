#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace myo::measurement {

/// Marker name of a label "subject:name": the part after the last colon; the whole label without one.
std::string_view without_subject(std::string_view label);

/// Indices of the labels that a name may mean: the label itself if the recording contains it, otherwise all labels
/// "subject:name". More than one: ambiguous.
std::vector<std::size_t> find_labels(const std::vector<std::string>& labels, std::string_view name);

/// Makes labels unique: repeated ones become "label (2)", "label (3)".
void make_unique(std::vector<std::string>& labels);

}  // namespace myo::measurement
