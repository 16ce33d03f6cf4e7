#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands/workbench_state.hpp"

// Texts of parts for the experiment's declaration.

namespace myo::ui::commands {

/// Text of a new part with a free name and the modulus of the body, so that nothing changes until it is edited.
///
/// @param place  line that says where it is, "box_m = ..."; empty: an edit that follows says it
std::string new_part(const WorkbenchState& state, const std::string& place);

/// Gives parts the masks of equal content that parts of the same index had before: a mask is identified by its pointer.
void keep_masks(const std::vector<ScenePart>& before, std::vector<ScenePart>& parts);

/// Whether as many parts are at the same places, whatever their materials.
bool same_places(const std::vector<ScenePart>& a, const std::vector<ScenePart>& b);

/// Key that says where a part is.
const char* place_key(const ScenePart& part);

/// Name of a file in a declaration, in TOML: from the experiment's folder if the file lies in it.
///
/// @param file  absolute
std::string declared_file(const Scene& scene, const std::filesystem::path& file);

}  // namespace myo::ui::commands
