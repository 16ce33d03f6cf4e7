#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/result.hpp"
#include "fibre/painted_mask.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// Painted mask of a muscle or part, a file or in memory, with its elements mapped to the mesh like point_on_mesh().
///
/// Errors: those of read_painted_mask().
Result<fibre::PaintedMask> mask_on_mesh(
    const std::variant<std::filesystem::path, std::shared_ptr<const fibre::PaintedMask>>& painted,
    const BodyMesh& mesh);

/// Contradictions of a mask in itself and with the mesh, as sentences for the user.
///
/// @param mask  from mask_on_mesh()
std::vector<std::string> mask_doubts(const fibre::PaintedMask& mask, const BodyMesh& mesh);

}  // namespace myo::setup
