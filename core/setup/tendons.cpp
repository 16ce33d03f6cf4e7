#include "setup/tendons.hpp"

#include <utility>

#include "experiment/body_queries.hpp"
#include "experiment/check_robot_parts.hpp"
#include "mesh/quality.hpp"
#include "model/tendon_channel.hpp"

namespace myo::setup {
namespace {

/// A point of the path at rest [m].
struct PathPoint {
    Eigen::Vector3d place;
    bool declared = true;
};

/// Guides of a tendon, and the points between those of a thread in a channel.
std::vector<PathPoint> path_points(const experiment::TendonDeclaration& tendon, double mean_edge_m) {
    std::vector<PathPoint> points;
    for (Eigen::Index g = 0; g < tendon.path_m.cols(); ++g) {
        const Eigen::Vector3d guide = tendon.path_m.col(g);
        if (g > 0 && tendon.channel) {
            const Eigen::Vector3d last = tendon.path_m.col(g - 1);
            const int legs = model::channel_legs(mean_edge_m, (guide - last).norm());
            for (int i = 1; i < legs; ++i) points.push_back({last + (guide - last) * i / legs, false});
        }
        points.push_back({guide, true});
    }
    return points;
}

}  // namespace

std::vector<Tendon> find_tendons(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                 const BodyMesh& mesh) {
    std::vector<Tendon> tendons;
    if (experiment.tendons.empty()) return tendons;
    const experiment::BodyQueries body(surface);
    const mesh::BoundaryLocator boundary(mesh.mesh);
    const double mean_edge_m = mesh::mean_edge_length(mesh.mesh);
    std::size_t coupling = 0;
    for (const experiment::TendonDeclaration& declared : experiment.tendons) {
        Tendon tendon;
        tendon.route = {{}, coupling, declared.friction, "tendon " + declared.name};
        tendon.by_shortening = declared.drive == experiment::TendonDrive::shortening;
        for (const PathPoint& point : path_points(declared, mean_edge_m)) {
            const bool moves = experiment::guide_moves(experiment, body, point.place);
            // A channel holds a thread in the material that moves: not off the body, not in the clamp box.
            if (!moves && !point.declared) continue;
            model::TendonGuide& placed = tendon.route.guides.emplace_back();
            placed.rest_m = point_on_mesh(mesh, point.place);
            if (moves) placed.on_body = fem::material_point(mesh.mesh, boundary, placed.rest_m);
            tendon.declared.push_back(point.declared);
        }
        // Length of the thread at rest [m], and the axial stiffness E V / L^2 of a bar of the body's volume and that
        // length.
        const double length = (declared.path_m.rightCols(declared.path_m.cols() - 1) -
                               declared.path_m.leftCols(declared.path_m.cols() - 1))
                                  .colwise()
                                  .norm()
                                  .sum();
        const double of_body = experiment.material.youngs_modulus_Pa * mesh::enclosed_volume(surface) /
                               (length * length);
        tendon.stiffness_N_m = declared.stiffness_N_m.value_or(tendon_policy.rigid_stiffness * of_body);
        // Stretch of the thread under the tension that strains the body by smoothed_strain.
        tendon.slack_m = tendon_policy.smoothed_strain * length * of_body / tendon.stiffness_N_m;
        // Couplings of a tendon follow those of the tendons before it, in the order of couplings().
        coupling += model::tendon_couplings(tendon.route.guides, tendon.by_shortening).size();
        tendons.push_back(std::move(tendon));
    }
    return tendons;
}

std::size_t moving_guides(const Tendon& tendon) {
    std::size_t count = 0;
    for (std::size_t g = 0; g < tendon.declared.size(); ++g)
        if (tendon.declared[g] && tendon.route.guides[g].on_body) ++count;
    return count;
}

std::vector<std::vector<int>> couplings(const std::vector<Tendon>& tendons) {
    std::vector<std::vector<int>> all;
    for (const Tendon& tendon : tendons)
        for (std::vector<int>& group : model::tendon_couplings(tendon.route.guides, tendon.by_shortening))
            all.push_back(std::move(group));
    return all;
}

model::ForceElementPointer tendon_element(const Tendon& tendon, const fibre::Signal& command) {
    return tendon.by_shortening
               ? model::tendon_of_shortening(tendon.route, command, tendon.stiffness_N_m, tendon.slack_m)
               : model::tendon_of_tension(tendon.route, command);
}

}  // namespace myo::setup
