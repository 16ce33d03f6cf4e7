#include "commands/region_drawing.hpp"

#include <utility>

#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

/// How a region is drawn.
struct RegionLookPolicy {
    float tint = 0.75f;       // opacity of the colour on the faces
    double line_width = 2.0;  // of the box [pixels]
};
constexpr RegionLookPolicy region_look_policy;

}  // namespace

void add_region(viewport::DrawnScene& drawn, const Box& box_m, const viewport::Color& color) {
    for (viewport::DrawnLine& line : viewport::box_lines(box_m, color, region_look_policy.line_width))
        drawn.lines.push_back(std::move(line));
    if (!drawn.body) return;
    const Eigen::MatrixXi& faces = drawn.body->faces.nodes;
    // Tints of muscles and chambers stay on the other faces.
    if (drawn.tints.cols() != faces.cols()) drawn.tints = Eigen::Matrix4Xf::Zero(4, faces.cols());
    for (Eigen::Index f = 0; f < faces.cols(); ++f) {
        bool inside = true;
        // Whole faces only: what is tinted is what the box holds.
        for (const int node : faces.col(f)) inside = inside && box_m.contains(drawn.positions.col(node));
        if (inside) drawn.tints.col(f) << color.head<3>(), region_look_policy.tint;
    }
}

}  // namespace myo::ui::commands
