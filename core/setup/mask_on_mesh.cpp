#include "setup/mask_on_mesh.hpp"

#include "fibre/mask_check.hpp"

namespace myo::setup {

Result<fibre::PaintedMask> mask_on_mesh(
    const std::variant<std::filesystem::path, std::shared_ptr<const fibre::PaintedMask>>& painted,
    const BodyMesh& mesh) {
    const auto* const file = std::get_if<std::filesystem::path>(&painted);
    Result<fibre::PaintedMask> mask = file ? fibre::read_painted_mask(*file)
                                           : Result<fibre::PaintedMask>(*std::get<1>(painted));
    if (mask)
        for (auto place : mask->centroids_m.colwise()) place = point_on_mesh(mesh, place);
    return mask;
}

std::vector<std::string> mask_doubts(const fibre::PaintedMask& mask, const BodyMesh& mesh) {
    std::vector<std::string> doubts = fibre::contradictions(mask);
    // Paint outside the body is usually a mask in another unit or frame.
    const Eigen::Index off = fibre::elements_off_mesh(mesh.mesh, mask), painted = (mask.weights.array() > 0.0).count();
    if (off > 0)
        doubts.push_back(std::to_string(off) + " of " + std::to_string(painted) +
                         " painted elements lie where the body has none; is the mask of this body, in its rest "
                         "frame, in metres, with its axes in order?");
    return doubts;
}

}  // namespace myo::setup
