#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "fem/element_block.hpp"

namespace myo::effect {
namespace intrinsic_curvature_parts {

/// Mesh in which each cell has its own nodes.
mesh::VolumeMesh exploded(const mesh::VolumeMesh& mesh) {
    mesh::VolumeMesh result{mesh.type, Eigen::Matrix3Xd(3, mesh.cells.size()),
                            Eigen::MatrixXi(mesh.cells.rows(), mesh.cells.cols())};
    for (Eigen::Index i = 0; i < mesh.cells.size(); ++i) {
        result.nodes.col(i) = mesh.nodes.col(mesh.cells.data()[i]);
        result.cells.data()[i] = static_cast<int>(i);
    }
    return result;
}

/// Gives each cell a trapezoidal stress-free shape. The shapes are not compatible with each other, so that the rest
/// shape of the body is under residual stress.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double k = number(parameters, "curvature_1_m");
    const auto across = static_cast<Eigen::Index>(number(parameters, "axis"));
    const Eigen::Index along = clamp_axis(context).axis;
    const Eigen::RowVectorXd s = context.body->mesh.nodes.row(across);
    // Distances from the middle of the body's extent, where the stress-free length is unchanged.
    const double middle = 0.5 * (s.minCoeff() + s.maxCoeff());
    mesh::VolumeMesh free_cells = exploded(affected.model.body->mesh);
    const Eigen::Index per_cell = free_cells.cells.rows();
    for (Eigen::Index c = 0; c < free_cells.cells.cols(); ++c) {
        auto nodes = free_cells.nodes.middleCols(c * per_cell, per_cell);
        const double centre = nodes.row(along).mean();
        // Length along the axis scaled by 1 + k (distance from the middle): curvature k of the stress-free body.
        nodes.row(along) = centre +
                           (nodes.row(along).array() - centre) * (1.0 + k * (nodes.row(across).array() - middle));
    }
    // Only the reference shapes of the cells are replaced; nodes, mass and boundary stay those of the rest shape.
    auto bent = std::make_shared<model::Body>(*affected.model.body);
    const model::PackedElements shapes = model::pack_elements(
        fem::make_elements(free_cells, bent->kind, bent->surroundings));
    std::visit(
        [&](auto& cells) {
            const auto& shape = std::get<std::decay_t<decltype(cells)>>(shapes);
            cells.shapes = shape.shapes;
            cells.shape_of_pack = shape.shape_of_pack;
            cells.surroundings = shape.surroundings;
        },
        bent->cells);
    affected.model.body = bent;
}

/// The two axes perpendicular to the clamp axis.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const int along = clamp_axis(search.trials.front()).axis;
    std::vector<EffectProbe> list;
    for (int axis = 0; axis < 3; ++axis)
        if (axis != along)
            list.push_back(probe({{"curvature_1_m", 0.1}, {"axis", static_cast<double>(axis)}}, "curvature_1_m"));
    return list;
}

/// Curvature across y or z.
EffectParameters drawn(const DrawContext&, RandomStream& random) { return {{"axis", drawn_cross_axis(random)}}; }

}  // namespace intrinsic_curvature_parts

Effect intrinsic_curvature() {
    using namespace intrinsic_curvature_parts;
    return {.id = "intrinsic_curvature",
            .kind = EffectKind::material,
            .summary = "the stress-free shape is bent",
            .parameters = {fitted_number("curvature_1_m", -100.0, 100.0, 1.0), {"axis", EffectParameterKind::axis}},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = "curvature_1_m", .lowest = 0.05, .highest = 8.0, .has_sign = true, .others = drawn}};
}

}  // namespace myo::effect
