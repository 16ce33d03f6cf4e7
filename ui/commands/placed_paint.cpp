#include "commands/placed_paint.hpp"

#include <algorithm>

namespace myo::ui::commands {
namespace {

constexpr std::size_t max_kept = 32;  // entries; undo rarely goes back further

}  // namespace

std::shared_ptr<const fibre::CellPaint> PlacedPaint::of(const Muscle& muscle,
                                                        const std::shared_ptr<const MeshedBody>& body) {
    // Declared muscles are already placed by the backend; they share the ownership of the body.
    if (!muscle.paint) {
        const auto declared = body->muscles.find(muscle.declared);
        if (declared != body->muscles.end()) return {body, &declared->second};
    }
    return of(muscle.paint, body);
}

std::shared_ptr<const fibre::CellPaint> PlacedPaint::of(const std::shared_ptr<const fibre::PaintedMask>& mask,
                                                        const std::shared_ptr<const MeshedBody>& body) {
    // Masks never change once they are made, so that the pointer identifies one.
    const auto known = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return entry.body == body && entry.mask == mask; });
    if (known != entries_.end()) return known->paint;
    const auto placed = std::make_shared<const fibre::CellPaint>(mask ? fibre::paint_of_mask(body->mesh, *mask)
                                                                      : fibre::blank_paint(body->mesh));
    remember(body, mask, placed);
    return placed;
}

void PlacedPaint::remember(const std::shared_ptr<const MeshedBody>& body,
                           const std::shared_ptr<const fibre::PaintedMask>& mask,
                           const std::shared_ptr<const fibre::CellPaint>& paint) {
    entries_.push_back({body, mask, paint});
    // The oldest goes first, whatever it is used for: it is made again when it is needed.
    if (entries_.size() > max_kept) entries_.pop_front();
}

}  // namespace myo::ui::commands
