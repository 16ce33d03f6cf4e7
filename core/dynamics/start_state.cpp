#include "dynamics/start_state.hpp"

#include <cassert>

#include "dynamics/hold.hpp"
#include "dynamics/statics.hpp"

namespace myo::dynamics {

using Eigen::Matrix3Xd;

namespace {

/// Whether these velocities change a distance between nodes of a cell by more than half within h.
bool tears(const model::Body& body, const Matrix3Xd& v, double h) {
    const Matrix3Xd& X = body.mesh.nodes;
    for (const auto& cell : body.mesh.cells.colwise())
        for (const int a : cell)
            for (const int b : cell)
                if (h * (v.col(a) - v.col(b)).norm() > 0.5 * (X.col(a) - X.col(b)).norm()) return true;
    return false;
}

/// Appends the dashpot strains: relaxed (equal to those of the body at rest) or still at zero. Rates follow from the
/// evolution law dE_v/dt = (E - E_v) / tau.
void add_dashpots(const material::MaxwellBranch& branch, bool relaxed, Kinematics& state) {
    const Eigen::Index count = state.strain.size();
    state.strain.conservativeResize(2 * count);
    state.rate.conservativeResize(2 * count);
    if (relaxed)
        state.strain.tail(count) = state.strain.head(count);
    else
        state.strain.tail(count).setZero();
    state.rate.tail(count) = (state.strain.head(count) - state.strain.tail(count)) / branch.relaxation_time_s;
}

}  // namespace

void count(const StageReport& report, Trace& trace) {
    ++trace.stages;
    trace.newton_iterations += report.newton_iterations;
    trace.linear_iterations += report.linear_iterations;
    trace.factorisations += report.factorisations;
    trace.times += report.times;
}

Matrix3Xd held_by(const model::Body& body, Matrix3Xd x) {
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) x.col(i) = body.mesh.nodes.col(i);
    for (const model::GuidedNode& guided : body.guided)
        for (int axis = 0; axis < 3; ++axis)
            if (guided.held[static_cast<std::size_t>(axis)]) x(axis, guided.node) = body.mesh.nodes(axis, guided.node);
    return x;
}

void set_start_strains(const model::Model& model, StartKind start, Kinematics& state) {
    state.strain = model::strains(model, state.x);
    state.rate = model::strain_tangent(model, state.x, state.v);
    if (model.creep) add_dashpots(*model.creep, start == StartKind::equilibrium, state);
}

bool set_start(const SimulationOptions& options, StageSolver& solver, Kinematics& state, Trace& trace) {
    const model::Body& body = *solver.model().body;
    const InitialState& initial = options.initial;
    assert(initial.positions.size() == 0 || initial.positions.cols() == body.node_count());
    assert(initial.velocities.size() == 0 || initial.velocities.cols() == body.node_count());
    state.x = held_by(body, initial.positions.size() > 0 ? initial.positions : body.mesh.nodes);
    state.v = Matrix3Xd::Zero(3, body.node_count());
    if (initial.velocities.size() > 0) state.v = model::free_part(body, initial.velocities);
    trace.status = RunStatus::failed;
    if (!state.x.allFinite() || !state.v.allFinite()) {
        trace.message = "the initial positions or velocities are not finite";
        return false;
    }
    if (solver.model().softening) solver.soften({});
    if (options.starts_at_equilibrium()) {
        // A run without steps is a hold; the pose of a similar one is near.
        const bool hold = options.end_s == 0.0;
        const Matrix3Xd* const similar = hold && options.warm_start ? options.warm_start->at(0.0, options.h_s)
                                                                    : nullptr;
        const StageReport report = hold ? solve_hold(solver, 0.0, similar, state.x)
                                        : solve_equilibrium(solver, 0.0, state.x);
        count(report, trace);
        trace.message = report.message;
        if (!report.ok()) return false;
    }
    set_start_strains(solver.model(), options.start, state);
    return true;
}

bool needs_euler(const model::Model& model, double h_s, Kinematics& state) {
    // Regular start: implicit Euler only for violent initial velocities of a viscous body.
    if (state.force.allFinite() && state.strain.allFinite())
        return model::is_viscous(model) && tears(*model.body, state.v, h_s);
    // Inverted cells: start from zero force and rest strains; implicit Euler uses neither.
    state.force.setZero();
    state.strain = model::strains(model, model.body->mesh.nodes);
    if (model.creep) state.strain = state.strain.replicate(2, 1).eval();
    state.rate.setZero();
    return true;
}

}  // namespace myo::dynamics
