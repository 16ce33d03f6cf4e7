#include "sensitivity/adjoint_run.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "dynamics/step_grid.hpp"
#include "sensitivity/adjoint_step.hpp"
#include "sensitivity/run_parts.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;

/// Forward run in parts, loss, then the parts backwards. Parts other than the last are run a second time for their
/// tape.
class GradientOfRun {
public:
    GradientOfRun(const model::Model& model, const dynamics::SimulationOptions& options, const LossOfMotion& loss,
                  const AdjointOptions& adjoint, const Progress& progress)
        : model_(model),
          options_(options),
          loss_(loss),
          progress_(progress),
          with_strains_(model::is_viscous(model) || model.creep || adjoint.damping_of_undamped),
          follower_(model, with_strains_, adjoint.fibre_points) {
        options_.solver.tangent_tolerance = adjoint.tolerance;
    }

    GradientRun run(double budget_bytes) {
        steps_ = static_cast<int>(dynamics::step_ends(model_, options_.h_s, options_.end_s).size());
        const Result<RunParts> plan = plan_parts(steps_, tape_bytes(model_, options_.integrator, with_strains_),
                                                 budget_bytes);
        if (!plan) return failed(plan.error().what);
        plan_ = *plan;
        result_.parts = plan_.parts;
        result_.tape_bytes = plan_.bytes;
        for (int part = 0; part < plan_.parts; ++part)
            if (!run_part(part, true)) return std::move(result_);
        result_.steps = static_cast<int>(result_.motion.times_s.size()) - 1;
        const MotionLoss loss = loss_.evaluate(result_.motion);
        result_.loss = loss.value;
        for (int part = plan_.parts - 1; part >= 0; --part) {
            // The last part is still on the tape of the forward run.
            if (part + 1 < plan_.parts && !run_part(part, false)) return std::move(result_);
            if (!transpose_part(loss)) return std::move(result_);
        }
        result_.gradient = follower_.take();
        result_.status = dynamics::RunStatus::complete;
        return std::move(result_);
    }

private:
    GradientRun failed(const std::string& message) {
        result_.status = dynamics::RunStatus::failed;
        result_.message = message;
        return std::move(result_);
    }

    /// Steps forwards and backwards are one count: whoever extrapolates from it sees it grow only.
    void report(double done) const { progress_.report({"gradient", done, 2.0 * steps_, "steps", {}}); }

    Progress forward_progress() const {
        return progress_.with_sink([this](const ProgressEvent& event) {
            if (event.total > 0.0) report(steps_ * std::clamp(event.done / event.total, 0.0, 1.0));
        });
    }

    /// Runs a part and records its tape. Each part starts with a new solver, so that its second run is identical to the
    /// first.
    bool run_part(int part, bool first_time) {
        tape_ = std::make_unique<RunTape>(plan_.points_every, with_strains_);
        solver_ = std::make_unique<dynamics::StageSolver>(model_, options_.solver);
        dynamics::RunPart of_run;
        if (part > 0) of_run.from = &cuts_[static_cast<std::size_t>(part - 1)];
        of_run.until_step = static_cast<std::size_t>((part + 1) * plan_.steps_per_part);
        of_run.keep_motion = false;
        dynamics::RunObserver observer;
        tape_->record(observer);
        dynamics::RunPoint end;
        bool repeated = part > 0;  // the first point of a part is the last one of the part before
        observer.reached = [&, taped = std::move(observer.reached)](const dynamics::RunPoint& point) {
            taped(point);
            if (!first_time) return;
            if (!std::exchange(repeated, false)) keep_motion(point);
            if (point.step == of_run.until_step && part + 1 < plan_.parts) end = point;
        };
        const dynamics::Trace trace = dynamics::simulate_part(
            *solver_, options_, of_run, first_time ? forward_progress() : progress_.with_sink({}), observer);
        result_.status = trace.status;
        result_.message = trace.message;
        if (!trace.complete()) return false;
        // Non-finite start forces mean inverted cells: the run starts with implicit Euler from data without derivative.
        if (tape_->start() && !tape_->start()->state.force.allFinite()) {
            failed("the start has cells turned inside out, so that the run has no gradient");
            return false;
        }
        if (first_time && part + 1 < plan_.parts) cuts_.push_back(std::move(end));
        return true;
    }

    void keep_motion(const dynamics::RunPoint& point) {
        // Only the observed nodes are stored for all times; whole states only at the splits.
        result_.motion.times_s.push_back(point.time_s);
        result_.motion.positions.emplace_back(point.state.x(Eigen::all, loss_.nodes));
        result_.motion.velocities.emplace_back(point.state.v(Eigen::all, loss_.nodes));
    }

    /// Takes the tape of a part backwards, adding the loss derivative at each state.
    bool transpose_part(const MotionLoss& loss) {
        while (!tape_->empty()) {
            if (progress_.cancelled()) {
                result_.status = dynamics::RunStatus::cancelled;
                result_.message = "stopped on the way back";
                return false;
            }
            std::vector<StepRecord> records = tape_->take_last(*solver_);
            for (; !records.empty(); records.pop_back(), ++transposed_) {
                const StepRecord& record = records.back();
                if (record.jump) follower_.jump(*solver_, *record.jump);
                add_loss(loss);
                if (!follower_.step(*solver_, record)) return no_derivative(record.time_s + record.h_s);
            }
            // A step that was halved is two on the tape.
            report(steps_ * (1.0 + static_cast<double>(transposed_) / result_.steps));
        }
        if (!tape_->start()) return true;
        follower_.jump(*solver_, *tape_->start());
        add_loss(loss);
        return follower_.start(*solver_, options_, *tape_->start()) || no_derivative(0.0);
    }

    /// Message for a stage or start whose Hessian cannot be solved.
    bool no_derivative(double time_s) {
        failed("at t = " + std::to_string(time_s) + " s the equilibrium is singular, so that the run has no gradient");
        return false;
    }

    /// Adds the loss derivative at the state that the backward pass has reached.
    void add_loss(const MotionLoss& loss) {
        // States are visited in reverse order.
        const auto at = static_cast<std::size_t>(result_.steps - transposed_);
        const auto add = [&](const std::vector<Matrix3Xd>& d, NodalField field) {
            if (at >= d.size() || d[at].size() == 0) return;
            Matrix3Xd& adjoint = follower_.state().nodal[field];
            if (adjoint.size() == 0) adjoint = Matrix3Xd::Zero(3, model_.body->node_count());
            for (std::size_t k = 0; k < loss_.nodes.size(); ++k)
                adjoint.col(loss_.nodes[k]) += d[at].col(static_cast<Eigen::Index>(k));
        };
        add(loss.d_positions, x_field);
        add(loss.d_velocities, v_field);
    }

    const model::Model& model_;
    dynamics::SimulationOptions options_;
    const LossOfMotion& loss_;
    const Progress& progress_;
    bool with_strains_;
    AdjointFollower follower_;
    RunParts plan_;
    std::vector<dynamics::RunPoint> cuts_;           // start states of the parts but the first
    std::unique_ptr<dynamics::StageSolver> solver_;  // of the current part
    std::unique_ptr<RunTape> tape_;
    int steps_ = 0;       // of the run
    int transposed_ = 0;  // number of steps
    GradientRun result_;
};

}  // namespace

GradientRun simulate_with_gradient(const model::Model& model, const dynamics::SimulationOptions& options,
                                   const LossOfMotion& loss, const AdjointOptions& adjoint, const Progress& progress) {
    return GradientOfRun(model, options, loss, adjoint, progress).run(adjoint.memory_bytes);
}

}  // namespace myo::sensitivity
