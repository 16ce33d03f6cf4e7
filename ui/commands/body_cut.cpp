#include "commands/body_cut.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {

void BodyCut::apply(const WorkbenchState& state, MotionSummary& motion) {
    // The centres of the cells come with the data for painting.
    if (!state.body || !state.ground || !motion.body) return;
    // Without a cut the original boundary is restored, but only if a cut is shown: a new pointer would upload it again.
    const ClipPlane& plane = state.view.clip;
    if (!plane.on) {
        if (motion.body->kept.empty()) return;
        motion.body = std::make_shared<viewport::DrawnBody>(viewport::DrawnBody{state.body->boundary, {}});
    } else {
        if (body_ == state.body && plane_ == plane && motion.body == cut_) return;
        // The table of faces depends on the mesh only. Building it is the slow part, so it is kept while the plane
        // moves.
        if (body_ != state.body) table_ = mesh::face_table(state.body->mesh);
        body_ = state.body;
        plane_ = plane;
        const Eigen::Matrix3Xd& centres = state.ground->places.centre_m;
        std::vector<char> kept(static_cast<std::size_t>(centres.cols()));
        for (Eigen::Index c = 0; c < centres.cols(); ++c)
            kept[static_cast<std::size_t>(c)] = plane.removes(centres.col(c)) ? 0 : 1;
        mesh::BoundaryFaces faces = mesh::boundary_of_part(table_, kept);
        cut_ = motion.body = std::make_shared<viewport::DrawnBody>(
            viewport::DrawnBody{std::move(faces), std::move(kept)});
    }
    motion.surface = std::make_shared<viewport::DrawnSurface>(viewport::drawn_surface(motion.body->faces));
}

Eigen::Matrix3Xd outline_of(const ClipPlane& plane, const Box& box) {
    // Intersections of the plane with the edges of the box, sorted by their angle about the middle.
    std::vector<Eigen::Vector3d> points;
    for (const viewport::DrawnLine& edge : viewport::box_lines(box, viewport::Color::Ones(), 1.0)) {
        for (Eigen::Index i = 0; i + 1 < edge.points.cols(); ++i) {
            const double a = plane.normal.dot(edge.points.col(i)) - plane.position_m,
                         b = plane.normal.dot(edge.points.col(i + 1)) - plane.position_m;
            // Both ends on the same side: the edge is not cut.
            if ((a > 0.0) == (b > 0.0)) continue;
            points.push_back(edge.points.col(i) + a / (a - b) * (edge.points.col(i + 1) - edge.points.col(i)));
        }
    }
    // The plane only touches the box, or misses it.
    if (points.size() < 3) return Eigen::Matrix3Xd(3, 0);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) middle += p / static_cast<double>(points.size());
    // Two axes in the plane, for the angles.
    const Eigen::Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
    const auto angle = [&](const Eigen::Vector3d& p) { return std::atan2(v.dot(p - middle), u.dot(p - middle)); };
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
    points.push_back(points.front());
    return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
}

}  // namespace myo::ui::commands
