#include "backend/fields.hpp"

#include <algorithm>

#include "fibre/cell_paint.hpp"
#include "mesh/volume_mesh.hpp"
#include "model/cell_means.hpp"

namespace myo::backend {
namespace {

using Eigen::VectorXd;

/// One frame of a trial.
struct FieldInput {
    const mesh::VolumeMesh& mesh;
    const ui::commands::SimulatedTrial& motion;
    std::size_t frame;
    const RunModels* models;  // null for a run without models
    // Model of the trial; null only for fields that need none.
    const model::Model* model;

    // Node positions, 3 x n [m].
    const Eigen::Matrix3Xd& x() const { return motion.frames[frame]; }
    double time_s() const { return motion.frame_time_s(static_cast<Eigen::Index>(frame)); }
    model::CellMeans means() const { return model::cell_means(*model, x(), model::activations(*model, time_s())); }
    // Stresses exist at quadrature points; colours need one value per node.
    VectorXd at_nodes(const VectorXd& cell_values) const {
        return myo::model::at_nodes(mesh, cell_values, mesh::cell_volumes(mesh));
    }
};

/// Distance of each node from its rest position [m].
VectorXd displacement(const FieldInput& in) { return (in.x() - in.mesh.nodes).colwise().norm(); }

/// Speed of each node [m/s]: central difference of the displayed frames, one-sided at both ends; 0 for a single frame.
/// Frames may be thinned, see shown_run(), so the stored velocities of the steps are not at hand.
VectorXd velocity(const FieldInput& in) {
    const std::size_t before = in.frame > 0 ? in.frame - 1 : 0,
                      after = std::min(in.frame + 1, in.motion.frames.size() - 1);
    const double span = in.motion.frame_time_s(static_cast<Eigen::Index>(after)) -
                        in.motion.frame_time_s(static_cast<Eigen::Index>(before));
    if (!(span > 0.0)) return VectorXd::Zero(in.mesh.node_count());
    return (in.motion.frames[after] - in.motion.frames[before]).colwise().norm() / span;
}

/// Target shortening 1 - a [-], weighted by the share of the cell that is muscle and summed over the muscles.
VectorXd activation(const FieldInput& in) {
    const std::vector<double> a = model::activations(*in.model, in.time_s());
    VectorXd cells = VectorXd::Zero(in.mesh.cell_count());
    for (std::size_t g = 0; g < in.model->fibres->size(); ++g)
        cells += (1.0 - a[g]) * fibre::paint_of_group(in.mesh, (*in.model->fibres)[g]).weights;
    return in.at_nodes(cells);
}

/// A displayable field.
struct Field {
    ui::commands::FieldKind kind;
    bool of_model;  // requires the models of the run
    // One value per node, SI.
    VectorXd (*values)(const FieldInput&);
};

/// All fields; a new one is a function and a line here.
const std::vector<Field>& catalogue() {
    static const std::vector<Field> all{
        {{"displacement", "Displacement |u|", "mm", 1e-3, false,
          "|u| = |x \xe2\x88\x92 X|: distance of a point x from its rest position X."},
         false,
         displacement},
        {{"velocity", "Velocity |v|", "mm/s", 1e-3, false,
          "|v| = |dx/dt|: speed of a point, by central differences of the shown frames."},
         false,
         velocity},
        {{"stretch", "Stretch \xce\xbb\xe2\x82\x81", "", 1.0, false,
          "Largest principal stretch, the largest singular value of F: the square root of the largest eigenvalue of "
          "F\xe1\xb5\x80"
          "F, mean over a cell."},
         true,
         [](const FieldInput& in) { return in.at_nodes(in.means().stretch); }},
        {{"von_mises", "Von Mises stress", "kPa", 1e3, false,
          "\xcf\x83\xe1\xb5\xa5 = \xe2\x88\x9a(3/2 s : s), s = \xcf\x83 \xe2\x88\x92 tr(\xcf\x83)/3 I, of Cauchy's "
          "stress \xcf\x83, law and fibres together, mean over a cell; at a node the mean of the surrounding cells."},
         true,
         [](const FieldInput& in) { return in.at_nodes(in.means().von_mises_Pa); }},
        {{"pressure", "Pressure p", "kPa", 1e3, true,
          "p = \xe2\x88\x92tr(\xcf\x83)/3 of Cauchy's stress \xcf\x83: positive in compression."},
         true,
         [](const FieldInput& in) { return in.at_nodes(in.means().pressure_Pa); }},
        {{"activation", "Contraction 1 \xe2\x88\x92 a", "%", 0.01, true,
          "Target shortening of the muscle relative to rest, 1 \xe2\x88\x92 a(t), times the share of a cell that "
          "is muscle; negative where it lengthens."},
         true,
         activation}};
    return all;
}

}  // namespace

const std::vector<ui::commands::FieldKind>& field_catalogue() {
    static const std::vector<ui::commands::FieldKind> kinds = [] {
        std::vector<ui::commands::FieldKind> result;
        for (const Field& field : catalogue()) result.push_back(field.kind);
        return result;
    }();
    return kinds;
}

VectorXd field_values(const std::string& id, const ui::commands::MeshedBody& body, const ui::commands::RunResult& run,
                      std::size_t trial, std::size_t frame) {
    const auto field = std::find_if(catalogue().begin(), catalogue().end(),
                                    [&](const Field& each) { return each.kind.id == id; });
    // Every run of this backend has RunModels or nothing as its source.
    const auto models = std::static_pointer_cast<const RunModels>(run.source);
    const model::Model* const model = models && trial < models->trials.size() ? &models->trials[trial] : nullptr;
    // A run may be older than the displayed mesh: its models are used only if their nodes can be those of the mesh.
    if (field == catalogue().end() ||
        (field->of_model && !(model && model->body && model->body->node_count() == body.mesh.node_count())))
        return {};
    return field->values({body.mesh, run.trials[trial], frame, models.get(), model});
}

}  // namespace myo::backend
