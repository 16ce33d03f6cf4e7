#pragma once

#include <deque>
#include <memory>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// Cache of the paint of muscles and parts, resampled on meshes. Resampling a mask takes the time of several frames;
/// undo and redo return to earlier masks, so the last ones are kept.
class PlacedPaint {
public:
    /// Paint of a muscle on the cells of a body, rest frame. Blank if the muscle is neither painted nor declared.
    std::shared_ptr<const fibre::CellPaint> of(const Muscle& muscle, const std::shared_ptr<const MeshedBody>& body);

    /// Paint of a mask on the cells of a body; null: blank.
    std::shared_ptr<const fibre::CellPaint> of(const std::shared_ptr<const fibre::PaintedMask>& mask,
                                               const std::shared_ptr<const MeshedBody>& body);

    /// Stores paint together with the mask that was made from it, so that of() does not resample it.
    void remember(const std::shared_ptr<const MeshedBody>& body, const std::shared_ptr<const fibre::PaintedMask>& mask,
                  const std::shared_ptr<const fibre::CellPaint>& paint);

private:
    /// Paint of one mask on one mesh. Masks are compared by pointer.
    struct Entry {
        std::shared_ptr<const MeshedBody> body;
        std::shared_ptr<const fibre::PaintedMask> mask;  // null: blank paint
        std::shared_ptr<const fibre::CellPaint> paint;
    };
    std::deque<Entry> entries_;  // newest last
};

}  // namespace myo::ui::commands
