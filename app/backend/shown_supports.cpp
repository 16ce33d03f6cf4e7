#include "backend/shown_supports.hpp"

#include "setup/parts.hpp"

namespace myo::backend {

ui::commands::SceneSupports shown_supports(const experiment::Experiment& experiment) {
    ui::commands::SceneSupports shown;
    for (const experiment::SupportDeclaration& support : experiment.supports)
        shown.push_back({support.box_m, support.held});
    return shown;
}

std::vector<Box> mesh_boxes(const experiment::Experiment& experiment) {
    // scene_of() compares two lists entry by entry, so their order is fixed.
    std::vector<Box> boxes = setup::part_boxes(experiment);
    boxes.push_back(experiment.clamp_box_m);
    for (const experiment::SupportDeclaration& support : experiment.supports) boxes.push_back(support.box_m);
    return boxes;
}

}  // namespace myo::backend
