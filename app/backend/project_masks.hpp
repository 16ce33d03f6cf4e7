#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "fibre/painted_mask.hpp"

// Files of painted masks in the folder of a project.

namespace myo::backend {

/// File name from the muscle or part and the content of the mask, "left-0123456789abcdef.csv", so that a file never
/// changes after it was written.
std::string mask_name(const std::string& muscle, const fibre::PaintedMask& mask);

/// Names of the masks that a project file references in its own folder of files; none if the file is missing or
/// unreadable. Masks with other names, as made by the user, are left out.
///
/// @param file   of the project
/// @param files  its folder `<name>.files`
std::set<std::string> named_masks(const std::filesystem::path& file, const std::filesystem::path& files);

/// Whether another project file in the folder, such as a backup, references this mask. The text is searched, so that
/// files that cannot be parsed count as well.
bool is_named_beside(const std::filesystem::path& file, const std::string& mask);

}  // namespace myo::backend
