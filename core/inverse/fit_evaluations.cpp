#include "inverse/fit_evaluations.hpp"

#include <cmath>

#include "base/stopwatch.hpp"
#include "base/text.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct FitEvaluationsPolicy {
    /// Largest change of ln(1 + value / scale) at once: a factor of e squared.
    double max_decades = 2.0;
};
constexpr FitEvaluationsPolicy fit_evaluations_policy;

/// Quality of an evaluation for the progress message.
std::string quality_words(const ResidualEvaluation& evaluation) {
    if (!evaluation.ok) return evaluation.message;
    const auto count = static_cast<double>(std::max<Index>(1, evaluation.residuals.size()));
    return "rms " + format_number(std::sqrt(evaluation.residuals.squaredNorm() / count), 4) + " times the noise";
}

template <class Value>
VectorXd for_each_number(const std::vector<Parameter>& parameters, const VectorXd& internal, const Value& value) {
    VectorXd result(internal.size());
    for (Index i = 0; i < internal.size(); ++i) result(i) = value(parameters[static_cast<std::size_t>(i)], internal(i));
    return result;
}

}  // namespace

double internal_value(const Parameter& p, double value) {
    return p.over_decades ? std::log1p(value / p.scale) : value / p.scale;
}
double physical_value(const Parameter& p, double internal) {
    // Exact at the start value, which rounding of the transformation would change.
    if (internal == internal_value(p, p.value)) return p.value;
    return p.over_decades ? p.scale * std::expm1(internal) : internal * p.scale;
}
double physical_slope(const Parameter& p, double internal) {
    return p.over_decades ? p.scale * std::exp(internal) : p.scale;
}

VectorXd physical_values(const std::vector<Parameter>& parameters, const VectorXd& internal) {
    return for_each_number(parameters, internal, physical_value);
}
VectorXd physical_slopes(const std::vector<Parameter>& parameters, const VectorXd& internal) {
    return for_each_number(parameters, internal, physical_slope);
}

StepBounds internal_step_bounds(const std::vector<Parameter>& parameters, const VectorXd& internal) {
    StepBounds bounds{VectorXd(internal.size()), VectorXd(internal.size())};
    for (Index i = 0; i < internal.size(); ++i) {
        const Parameter& p = parameters[static_cast<std::size_t>(i)];
        const double most = p.over_decades ? fit_evaluations_policy.max_decades
                                           : std::numeric_limits<double>::infinity();
        const auto room = [&](double bound) {
            return std::isfinite(bound) ? internal_value(p, bound) - internal(i) : bound;
        };
        // Zero is always allowed, also where rounding leaves the value outside its bounds.
        bounds.lower(i) = std::min(0.0, std::max(room(p.lower), -most));
        bounds.upper(i) = std::max(0.0, std::min(room(p.upper), most));
    }
    return bounds;
}

FitEvaluations::FitEvaluations(const ResidualFunction& function, const LeastSquaresOptions& options,
                               const Progress& progress, LeastSquaresReport& report)
    : function_(function), progress_(progress), max_evaluations_(options.max_evaluations), report_(report) {}

const ResidualEvaluation& FitEvaluations::at(const VectorXd& values) {
    for (const Point& point : latest_)
        if (point.values == values) return point.evaluation;
    if (progress_.cancelled()) return stopped_;
    const auto show = [&](double done) {
        progress_.report({"fit", done, max_evaluations_, "evaluations", last_words_});
    };
    if (report_.evaluations == 0) show(0.0);  // shows activity during the first evaluation
    const Progress inside = progress_.with_sink([&](const ProgressEvent& event) {
        // Below 1: an evaluation counts as complete only at its end.
        if (throttle_.ready())
            show(report_.evaluations + (event.total > 0.0 ? std::clamp(event.done / event.total, 0.0, 0.999) : 0.0));
    });
    FitIterate iterate{values, std::numeric_limits<double>::infinity()};
    const Stopwatch watch;
    ResidualEvaluation fresh = function_(values, inside);
    iterate.seconds = watch.seconds();
    if (!fresh.ok && progress_.cancelled()) return stopped_;  // incomplete: not logged
    if (fresh.ok && !std::isfinite(fresh.residuals.squaredNorm())) {
        fresh.ok = false;
        fresh.message = "the sum of squared differences to the data is not a finite number";
    }
    if (latest_.size() == 3) latest_.erase(latest_.begin());
    latest_.push_back({values, std::move(fresh)});
    const ResidualEvaluation& evaluation = latest_.back().evaluation;
    ++report_.evaluations;
    if (evaluation.ok) {
        iterate.cost = 0.5 * evaluation.residuals.squaredNorm();
        const bool first = !report_.usable();
        if (first) report_.cost_before = iterate.cost;
        if (first || iterate.cost < report_.cost_after) {
            report_.values = iterate.values;
            report_.cost_after = iterate.cost;
            best_ = evaluation;
        }
    }
    report_.history.push_back(std::move(iterate));
    last_words_ = quality_words(evaluation);
    show(report_.evaluations);
    return evaluation;
}

void set_covariance(const std::vector<Parameter>& parameters, const ResidualEvaluation& end,
                    LeastSquaresReport& report) {
    const auto n = static_cast<Index>(parameters.size());
    report.deviations = VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    report.correlation = MatrixXd::Identity(n, n);
    report.undetermined.clear();
    if (!end.ok || n == 0) return;
    // Residual variance at least 1: the noise is a lower bound, see fit_least_squares().
    const double freedom = static_cast<double>(std::max<Index>(1, end.residuals.size() - n));
    Identifiability found = identifiability(parameters, end.jacobian,
                                            std::max(1.0, end.residuals.squaredNorm() / freedom));
    report.deviations = std::move(found.deviations);
    report.correlation = std::move(found.correlation);
    report.undetermined = std::move(found.undetermined);
}

}  // namespace myo::inverse
