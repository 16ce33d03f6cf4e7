#pragma once

#include <deque>
#include <memory>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// Paint of muscles on the body that is shown. Resampling a mask takes some frames' time, so the last ones are kept:
/// undo and redo go back to them.
class PlacedPaint {
public:
    /// The muscle on the body, rest frame; blank where it is nowhere.
    std::shared_ptr<const fibre::CellPaint> of(const Muscle& muscle, const std::shared_ptr<const MeshedBody>& body);

    /// A mask was made from this paint.
    void remember(const std::shared_ptr<const MeshedBody>& body, const std::shared_ptr<const fibre::PaintedMask>& mask,
                  const std::shared_ptr<const fibre::CellPaint>& paint);

private:
    struct Entry {
        std::shared_ptr<const MeshedBody> body;
        std::shared_ptr<const fibre::PaintedMask> mask;  // null: no paint at all
        std::shared_ptr<const fibre::CellPaint> paint;
    };
    std::deque<Entry> entries_;  // newest last
};

}  // namespace myo::ui::commands
