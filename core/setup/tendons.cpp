#include "setup/tendons.hpp"

#include <cmath>
#include <utility>

#include "experiment/body_queries.hpp"
#include "experiment/check_robot_parts.hpp"

namespace myo::setup {

std::vector<Tendon> find_tendons(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                 const BodyMesh& mesh) {
    std::vector<Tendon> tendons;
    if (experiment.tendons.empty()) return tendons;
    const experiment::BodyQueries body(surface);
    const mesh::BoundaryLocator boundary(mesh.mesh);
    std::size_t coupling = 0;
    for (const experiment::TendonDeclaration& declared : experiment.tendons) {
        Tendon tendon;
        tendon.route = {{}, coupling, declared.friction, "tendon " + declared.name};
        tendon.by_shortening = declared.drive == experiment::TendonDrive::shortening;
        for (const auto& declared_guide : declared.path_m.colwise()) {
            const Eigen::Vector3d guide = declared_guide;
            model::TendonGuide& placed = tendon.route.guides.emplace_back();
            placed.rest_m = point_on_mesh(mesh, guide);
            if (experiment::guide_moves(experiment, body, guide))
                placed.on_body = fem::material_point(mesh.mesh, boundary, placed.rest_m);
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
