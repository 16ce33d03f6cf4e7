#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// Writes the body in one frame; see Backend::write_shape().
///
/// .vtu: the deformed volume mesh [m] with the point fields `displacement` [m] and the frame's values. .stl: its
/// surface in the frame's unit. .glb: its surface [m] with normals and the frame's colours, turned to y upwards.
///
/// @param frame  positions 3 x nodes of the body's mesh [m] (asserted); values and colours may be empty
/// Errors: another extension, the file cannot be written.
Result<void> write_shape_file(const std::filesystem::path& file, const ui::commands::MeshedBody& body,
                              const ui::commands::ShapeFrame& frame);

}  // namespace myo::backend
