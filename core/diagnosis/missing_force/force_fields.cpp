#include "diagnosis/missing_force/force_fields.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "diagnosis/missing_force/timed_forces.hpp"
#include "measurement/rigid_motion.hpp"
#include "model/held_nodes.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Position of each node, 0 ... 1, from the centre of the supported nodes towards the centre of the body; along x if no
/// node is held, or all around.
VectorXd places(const model::Body& body, double min_offset) {
    const Matrix3Xd& X = body.mesh.nodes;
    const std::vector<int> held = model::support_nodes(body);
    Vector3d way = Vector3d::UnitX();
    if (!held.empty()) way = X.rowwise().mean() - Matrix3Xd(X(Eigen::all, held)).rowwise().mean();
    const double size = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
    if (!(way.norm() > min_offset * size)) way = Vector3d::UnitX();
    const VectorXd along = X.transpose() * way;
    const double lowest = along.minCoeff(), highest = along.maxCoeff();
    if (!(highest > lowest)) return VectorXd::Zero(X.cols());
    return (along.array() - lowest) / (highest - lowest);
}

/// Mean of a signal over 0 ... end_s from evenly spaced samples.
double mean_value(const fibre::Signal& signal, double end_s, int samples) {
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) sum += signal.value(end_s * k / (samples - 1));
    return sum / samples;
}

/// The trial at equilibrium under constant loads: activations and commands at their mean, forces that act at the middle
/// of the trial.
effect::Affected at_mean_state(effect::Affected trial, const MissingForcePolicy& policy) {
    const double end = trial.options.end_s;
    for (fibre::Signal& signal : trial.model.activation)
        signal = fibre::Signal::constant(mean_value(signal, end, policy.path_samples));
    for (model::ForceElementPointer& element : trial.model.force_elements)
        if (const fibre::Signal* const command = element->command())
            element = element->with_command(fibre::Signal::constant(mean_value(*command, end, policy.path_samples)));
    std::vector<model::DeadForce> steady;
    for (model::DeadForce force : trial.model.forces)
        // A load that acts at half time is taken as acting always, others as never.
        if (force.active(0.5 * end)) {
            force.from_s = -std::numeric_limits<double>::infinity();
            force.until_s = std::numeric_limits<double>::infinity();
            force.course = fibre::Signal::constant(mean_value(force.course, end, policy.path_samples));
            steady.push_back(force);
        }
    trial.model.forces = steady;
    trial.options.initial = {};
    trial.options.start = dynamics::StartKind::equilibrium;
    return trial;
}

/// The trial in its rest shape without loads, for trials that have no such equilibrium.
effect::Affected at_rest(effect::Affected trial) {
    for (fibre::Signal& signal : trial.model.activation) signal = fibre::Signal::constant(1.0);
    trial.model = model::with_constant_commands(trial.model, 0.0, 0.0);
    trial.model.forces.clear();
    trial.model.gravity_m_s2.setZero();
    trial.options.initial = {};
    trial.options.start = dynamics::StartKind::straight;
    return trial;
}

/// Two hat functions of time for each field: the half hat of the first knot and the hat of the second. If the trial
/// starts at equilibrium, the first one has always acted before.
std::vector<TimedForce> hats(const ForceFields& fields, double spacing, bool from_before) {
    std::vector<TimedForce> forces;
    for (const Matrix3Xd& pattern : fields.patterns)
        forces.push_back({pattern, from_before ? fibre::Signal{{0.0, spacing}, {1.0, 0.0}}
                                               : fibre::Signal{{0.0, 0.0, spacing}, {0.0, 1.0, 0.0}}});
    for (const Matrix3Xd& pattern : fields.patterns)
        forces.push_back({pattern, {{0.0, spacing, 2.0 * spacing}, {0.0, 1.0, 0.0}}});
    return forces;
}

/// Run of the trial with tangents by the size of each force, at size zero.
sensitivity::SensitiveTrace unit_run(const measurement::MarkerSet& markers, effect::Affected trial,
                                     std::vector<TimedForce> forces, const Progress& progress) {
    const std::size_t others = trial.model.force_elements.size(), count = forces.size();
    // The forces are one more element with factor 0: the motion stays, and its parameters are the factors.
    trial.model.force_elements.push_back(timed_forces(std::move(forces), 0.0));
    std::vector<sensitivity::ModelTangent> tangents(count);
    for (std::size_t p = 0; p < count; ++p) {
        tangents[p].force_elements.resize(others + 1);
        tangents[p].force_elements.back() = VectorXd::Unit(static_cast<Index>(count), static_cast<Index>(p));
    }
    return sensitivity::simulate_with_tangents(trial.model, trial.options, tangents, markers.nodes, progress);
}

}  // namespace

ForceFields force_fields(const model::Body& body, const MissingForcePolicy& policy) {
    ForceFields fields;
    fields.place = places(body, policy.min_offset);
    MatrixXd hats = MatrixXd::Zero(body.node_count(), policy.stations);
    for (Index i = 0; i < hats.rows(); ++i)
        for (Index j = 0; j < policy.stations; ++j)
            hats(i, j) = std::max(0.0,
                                  1.0 - std::abs((policy.stations - 1) * fields.place(i) - static_cast<double>(j)));
    // Consistent nodal forces of a body force field f: the mass matrix of unit density times its nodal values.
    const MatrixXd weighted = body.unit_mass * hats;
    const MatrixXd volume = hats.transpose() * weighted;
    fields.volume.setZero(3 * policy.stations, 3 * policy.stations);
    for (Index j = 0; j < policy.stations; ++j)
        for (Index axis = 0; axis < 3; ++axis) {
            Matrix3Xd pattern = Matrix3Xd::Zero(3, body.node_count());
            pattern.row(axis) = weighted.col(j).transpose();
            fields.patterns.push_back(model::free_part(body, pattern));
            for (Index k = 0; k < policy.stations; ++k) fields.volume(3 * j + axis, 3 * k + axis) = volume(j, k);
        }
    return fields;
}

KnotTimes knot_times(double end_s, const MissingForcePolicy& policy) {
    const int intervals = std::clamp(static_cast<int>(std::ceil(end_s / policy.knot_spacing_s)), policy.min_knots - 1,
                                     policy.max_knots - 1);
    return {end_s / intervals, intervals + 1};
}

fibre::Signal knot_signal(const KnotTimes& knots, const VectorXd& values) {
    assert(values.size() == knots.count);
    const VectorXd times = knots.times_s();
    return {{times.begin(), times.end()}, {values.begin(), values.end()}};
}

MatrixXd force_response(const setup::Setup& setup, const FitData& data, const prediction::ParameterValues& values,
                        const ForceBasis& basis, const MissingForcePolicy& policy, const Progress& progress) {
    const auto& [fields, knots] = basis;
    assert(data.trials.size() == 1);
    const std::size_t index = data.trials.front();
    const setup::PreparedTrial& trial = setup.trials[index];
    const effect::Affected affected = prediction::affected_trial(setup, index, values);
    const std::vector<TimedForce> forces = hats(fields, knots.spacing_s, affected.options.starts_at_equilibrium());
    const measurement::MarkerSet markers = measurement::seen_markers(setup.markers, affected.observation_error);
    sensitivity::SensitiveTrace run = unit_run(markers, at_mean_state(affected, policy), forces, progress);
    // A body without equilibrium under its mean loads, such as one that is not held.
    if (!run.trace.complete() && !progress.cancelled()) run = unit_run(markers, at_rest(affected), forces, progress);
    if (!run.trace.complete()) return {};

    const bool displacement = setup.experiment.markers.compare == experiment::Comparison::displacement;
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    const VectorXd times = measurement::true_times(affected.observation_error, trial.measured.time_s).array() -
                           values.start_shift_s[index];
    const measurement::SensitiveTracks origin = measurement::observe(run, markers, VectorXd::Zero(1));
    const std::size_t count = fields.patterns.size();
    MatrixXd response(data.layout.size(), static_cast<Index>(count) * knots.count);
    // About an equilibrium the response depends on the time since the force only: the hats of all later knots are those
    // of the second knot, delayed.
    for (int knot = 0; knot < knots.count; ++knot) {
        const double later = knot == 0 ? 0.0 : knots.spacing_s * (knot - 1);
        const std::size_t first = knot == 0 ? 0 : count;
        const measurement::SensitiveTracks tracks = measurement::observe(run, markers, times.array() - later);
        std::vector<prediction::TrialPrediction> prediction(1);
        for (std::size_t f = first; f < first + count; ++f) {
            std::vector<Matrix3Xd> d = measurement::observed_tangents(
                affected.observation_error,
                measurement::laboratory_tangents(affected.observation_error, tracks.tangents[f], times),
                measurement::laboratory_tracks(affected.observation_error, tracks.tracks.positions, times),
                trial.measured.time_s);
            const std::vector<Matrix3Xd> start = measurement::laboratory_tangents(
                affected.observation_error, origin.tangents[f], VectorXd::Zero(1));
            for (std::size_t m = 0; m < d.size(); ++m) {
                // Displacements are measured from the start, which the force of the first knot moves as well.
                if (displacement)
                    d[m].colwise() -= measurement::seen_by_place(affected.observation_error,
                                                                 origin.tracks.positions[m].col(0)) *
                                      Vector3d(start[m].col(0));
                else
                    d[m] = R * d[m];
            }
            prediction.front().tangents.push_back(std::move(d));
        }
        response.middleCols(static_cast<Index>(count) * knot, static_cast<Index>(count)) = flat_jacobian(
            data, prediction, count);
    }
    return response;
}

}  // namespace myo::diagnosis
