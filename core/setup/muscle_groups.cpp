#include "setup/muscle_groups.hpp"

#include "experiment/read_experiment.hpp"
#include "fibre/fibres_along_line.hpp"
#include "fibre/painted_mask.hpp"
#include "setup/mask_on_mesh.hpp"

namespace myo::setup {
namespace {

/// point_on_mesh() for each column.
Eigen::Matrix3Xd points_on_mesh(const BodyMesh& mesh, Eigen::Matrix3Xd points) {
    for (auto point : points.colwise()) point = point_on_mesh(mesh, point);
    return points;
}

/// Visitor that turns each kind of declared muscle into fibres on the mesh.
struct GroupOf {
    const experiment::MuscleDeclaration& muscle;
    const BodyMesh& mesh;
    std::vector<std::string>& doubts;  // receives warnings about a mask

    Result<fibre::FibreGroup> operator()(const experiment::MuscleBox& part) const {
        return fibre::fibres_in_box(mesh.mesh, box_on_mesh(mesh, part.box_m), part.fibre, muscle.stiffness_Pa,
                                    muscle.name);
    }
    Result<fibre::FibreGroup> operator()(const experiment::MuscleMask& part) const {
        Result<fibre::PaintedMask> mask = mask_on_mesh(part.painted, mesh);
        if (!mask) return mask.error();
        doubts = mask_doubts(*mask, mesh);
        // One declared direction replaces the painted ones.
        if (part.fibre) mask->directions.colwise() = *part.fibre;
        return fibre::fibres_of_mask(mesh.mesh, *mask, muscle.stiffness_Pa, muscle.name);
    }
    Result<fibre::FibreGroup> operator()(const experiment::MuscleLine& part) const {
        const fibre::Polyline line{points_on_mesh(mesh, part.line.points_m)};
        return fibre::fibres_along_line(mesh.mesh, line, part.radius_m, muscle.stiffness_Pa, muscle.name);
    }
};

}  // namespace

Result<std::vector<fibre::FibreGroup>> muscle_groups(const experiment::Experiment& experiment, const BodyMesh& mesh,
                                                     std::vector<std::string>* warnings) {
    std::vector<fibre::FibreGroup> groups;
    for (std::size_t i = 0; i < experiment.muscles.size(); ++i) {
        const experiment::MuscleDeclaration& muscle = experiment.muscles[i];
        std::vector<std::string> doubts;
        Result<fibre::FibreGroup> group = std::visit(GroupOf{muscle, mesh, doubts}, muscle.part);
        if (!group) return group.error();
        const std::string table = "muscle[" + std::to_string(i) + "].";
        const auto* const mask = std::get_if<experiment::MuscleMask>(&muscle.part);
        const auto* const painted = mask ? std::get_if<std::shared_ptr<const fibre::PaintedMask>>(&mask->painted)
                                         : nullptr;
        // An empty mask is valid while a muscle is being painted.
        const bool nowhere = painted && (*painted)->count() == 0;
        // A muscle without material would have no effect, and a fit of its level no influence.
        if (group->points.empty() && mask && !nowhere)
            return experiment::declaration_error(experiment, table + "mask",
                                                 "no element of the mesh lies where the mask is painted; is it of this "
                                                 "body, in its rest frame, in metres?");
        if (group->points.empty() && std::holds_alternative<experiment::MuscleLine>(muscle.part))
            return experiment::declaration_error(experiment, table + "line_m",
                                                 "no material of the body lies within radius_m of the line");
        for (const std::string& doubt : doubts)
            if (warnings) warnings->push_back(table + "mask: " + doubt);
        groups.push_back(std::move(*group));
    }
    return groups;
}

}  // namespace myo::setup
