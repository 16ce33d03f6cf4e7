#include <Eigen/QR>

#include <cmath>

#include "inverse/bounded_step.hpp"
#include "inverse/fit_evaluations.hpp"
#include "inverse/least_squares.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct SecantDescentPolicy {
    /// Limits of the prediction error: a larger error of an update requests a new Jacobian; at the end, a larger error
    /// of the last requested (or given) Jacobian over the way from there requests one.
    double bad_secant = 0.5;
    double trusted_end = 0.1;
};
constexpr SecantDescentPolicy secant_descent_policy;

/// Residuals with their Jacobian at a point, with respect to internal values.
struct Linear {
    VectorXd u, r;
    MatrixXd J;
};

/// Relative prediction error of the change from one point to another.
double surprise(const Linear& from, const VectorXd& u, const VectorXd& r) {
    const VectorXd change = r - from.r;
    const double length = change.norm();
    return length > 0.0 ? (change - from.J * (u - from.u)).norm() / length : 0.0;
}

/// Trust-region Gauss-Newton method with Broyden updates; see fit_by_secants().
class SecantDescent {
public:
    SecantDescent(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                  const JacobianFunction& jacobian, const LeastSquaresOptions& options, const Progress& progress)
        : parameters_(parameters),
          jacobian_(jacobian),
          options_(options),
          progress_(progress),
          evaluations_(residuals, options, progress, report_) {}

    LeastSquaresReport run() {
        const auto n = static_cast<Index>(parameters_.size());
        report_.start.resize(n);
        here_.u.resize(n);
        for (Index i = 0; i < n; ++i) {
            const Parameter& parameter = parameters_[static_cast<std::size_t>(i)];
            report_.start(i) = parameter.value;
            here_.u(i) = internal_value(parameter, parameter.value);
        }
        report_.values = report_.start;
        const ResidualEvaluation first = evaluations_.at(physical(here_.u));
        set_covariance(parameters_, {}, report_);
        if (!first.ok) return stop(FitStatus::failed, first.message), std::move(report_);
        here_.r = first.residuals;
        if (options_.jacobian_guess.size() > 0 && options_.jacobian_guess.allFinite()) {
            here_.J = options_.jacobian_guess * slopes().asDiagonal();
            anchor_ = here_;
        } else if (!ask())
            return stop(FitStatus::failed, no_derivatives), std::move(report_);
        if (n > 0)
            descend();
        else
            report_.status = FitStatus::converged;
        report_.jacobian = here_.J * slopes().cwiseInverse().asDiagonal();
        set_covariance(parameters_, {true, {}, here_.r, report_.jacobian}, report_);
        return std::move(report_);
    }

private:
    static constexpr const char* no_derivatives = "the model could not be run near these values";

    VectorXd physical(const VectorXd& u) const { return physical_values(parameters_, u); }
    VectorXd slopes() const { return physical_slopes(parameters_, here_.u); }

    bool may_ask() const { return report_.jacobians < options_.max_jacobians; }
    bool is_exact() const { return report_.jacobians > 0 && anchor_.u == here_.u; }

    /// Requests the Jacobian at the present point. Returns false if the model could not be run.
    bool ask() {
        MatrixXd J = jacobian_(physical(here_.u), {true, {}, here_.r, {}}, progress_.with_sink({}));
        ++report_.jacobians;
        if (J.rows() != here_.r.size() || !J.allFinite()) return false;
        here_.J = J * slopes().asDiagonal();
        anchor_ = here_;
        return true;
    }

    /// Whether a given or requested Jacobian is valid at the present point, so that convergence can be accepted.
    bool knows_the_end() const {
        return !may_ask() || is_exact() ||
               (anchor_.u != here_.u && surprise(anchor_, here_.u, here_.r) < secant_descent_policy.trusted_end);
    }

    /// Step that minimises the linearised residual within bounds and radius, and the predicted squared residual `left`.
    /// `scale`: column norms.
    VectorXd best_step(const VectorXd& scale, double& left) const {
        const Index n = here_.u.size();
        // Pad with zero rows if there are fewer residuals than parameters.
        const Index rows = std::max(n, here_.r.size());
        MatrixXd J = MatrixXd::Zero(rows, n);
        VectorXd r = VectorXd::Zero(rows);
        J.topRows(here_.r.size()) = here_.J;
        r.head(here_.r.size()) = here_.r;
        const Eigen::HouseholderQR<MatrixXd> qr(J);
        const MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
        const VectorXd c = (qr.householderQ().adjoint() * r).head(n);
        StepBounds bounds = internal_step_bounds(parameters_, here_.u);
        // Do not move parameters without influence: their columns are errors of the derivatives.
        const std::vector<bool> flat = without_influence(parameters_, here_.J * slopes().cwiseInverse().asDiagonal());
        for (Index i = 0; i < n; ++i)
            if (flat[static_cast<std::size_t>(i)]) bounds.lower(i) = bounds.upper(i) = 0.0;
        // Marquardt's damping: bisection for the lambda that brings the update within the radius.
        MatrixXd A(2 * n, n);
        VectorXd b = VectorXd::Zero(2 * n);
        A.topRows(n) = R;
        b.head(n) = c;
        const auto damped = [&](double lambda) -> VectorXd {
            A.bottomRows(n) = MatrixXd((std::sqrt(lambda) * scale).asDiagonal());
            return bounded_step(A, b, bounds.lower, bounds.upper);
        };
        const auto length = [&](const VectorXd& s) { return s.cwiseProduct(scale).norm(); };
        VectorXd step = damped(1e-12);
        if (length(step) > radius_) {
            double low = -12.0, high = 6.0;  // decades of lambda
            for (int bisection = 0; bisection < 30; ++bisection) {
                const double middle = 0.5 * (low + high);
                step = damped(std::pow(10.0, middle));
                (length(step) > radius_ ? low : high) = middle;
            }
            step = damped(std::pow(10.0, high));
        }
        left = here_.r.squaredNorm() - c.squaredNorm() + (c + R * step).squaredNorm();
        return step;
    }

    void descend() {
        for (;;) {
            if (progress_.cancelled()) return stop(FitStatus::cancelled, {});
            const VectorXd scale = here_.J.colwise().norm().transpose().cwiseMax(1e-12 * here_.J.norm());
            const double squares = here_.r.squaredNorm();
            double left = 0.0;
            const VectorXd step = best_step(scale, left);
            const bool little = squares - left <= options_.relative_decrease * squares ||
                                step.norm() <= options_.relative_step * (here_.u.norm() + options_.relative_step);
            if (little) {
                if (knows_the_end()) {
                    report_.status = FitStatus::converged;
                    return;
                }
                if (!ask()) return stop(FitStatus::not_converged, no_derivatives);
                radius_ = std::numeric_limits<double>::infinity();
                continue;
            }
            if (report_.evaluations >= options_.max_evaluations)
                return stop(FitStatus::not_converged,
                            "after " + std::to_string(report_.evaluations) + " evaluations it has not converged");
            const VectorXd u = here_.u + step;
            const ResidualEvaluation there = evaluations_.at(physical(u));
            const double length = step.cwiseProduct(scale).norm();
            if (!there.ok) {
                radius_ = 0.25 * length;
                continue;
            }
            const double now = there.residuals.squaredNorm(), gain = (squares - now) / (squares - left);
            const bool bad = surprise(here_, u, there.residuals) > secant_descent_policy.bad_secant;
            if (now < squares) {
                if (gain < 0.25)
                    radius_ = 0.5 * length;
                else if (gain > 0.75)
                    radius_ = std::max(radius_, 2.0 * length);
                turn(step, there.residuals, scale);
                here_.u = u;
                here_.r = there.residuals;
                if (bad && may_ask() && !ask()) return stop(FitStatus::not_converged, no_derivatives);
                continue;
            }
            // Minimum of the parabola through the cost and its slope here and the cost there.
            const double slope = 2.0 * here_.r.dot(here_.J * step), curve = now - squares - slope;
            radius_ = length * (curve > 0.0 ? std::clamp(-0.5 * slope / curve, 0.1, 0.5) : 0.5);
            if (is_exact()) continue;
            if (!may_ask())
                turn(step, there.residuals, scale);
            else if (!ask())
                return stop(FitStatus::not_converged, no_derivatives);
        }
    }

    void stop(FitStatus status, const std::string& message) {
        report_.status = progress_.cancelled() ? FitStatus::cancelled : status;
        report_.message = progress_.cancelled() ? "stopped by the user" : message;
    }

    /// Broyden's update: the smallest change of the Jacobian that explains the last change of the residuals.
    void turn(const VectorXd& step, const VectorXd& residuals, const VectorXd& scale) {
        const VectorXd weighted = scale.cwiseAbs2().cwiseProduct(step);
        here_.J += (residuals - here_.r - here_.J * step) * weighted.transpose() / step.dot(weighted);
    }

    const std::vector<Parameter>& parameters_;
    const JacobianFunction& jacobian_;
    const LeastSquaresOptions& options_;
    const Progress& progress_;
    LeastSquaresReport report_;
    FitEvaluations evaluations_;
    Linear here_;
    Linear anchor_;                                            // point of the last requested or given Jacobian
    double radius_ = std::numeric_limits<double>::infinity();  // trust region: bound on the update, scaled by the
                                                               // column norms
};

}  // namespace

LeastSquaresReport fit_by_secants(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                  const JacobianFunction& jacobian, const LeastSquaresOptions& options,
                                  const Progress& progress) {
    return SecantDescent(parameters, residuals, jacobian, options, progress).run();
}

}  // namespace myo::inverse
