#include "diagnosis/missing_force/missing_force.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "base/decompositions.hpp"
#include "base/text.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/missing_force/force_course.hpp"
#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/smooth_force.hpp"
#include "diagnosis/missing_force/timed_forces.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Largest squared residual that may be noise. Its expectation is the number of samples, its variance twice that.
double noise_squares(Index samples, const MissingForcePolicy& policy) {
    return policy.noise_doubt * static_cast<double>(samples) +
           policy.noise_deviations * std::sqrt(2.0 * static_cast<double>(samples));
}

/// Matrix of the integral of f^2 + (smoothing_s df/dt)^2 over body and time, for knot values in the order of the
/// columns of force_response().
MatrixXd size_of_force(const ForceBasis& basis, double smoothing_s) {
    const auto& [fields, knots] = basis;
    const double dt = knots.spacing_s;
    MatrixXd time = MatrixXd::Zero(knots.count, knots.count);
    Eigen::Matrix2d interval;
    // Two hat functions in an interval of length dt: mass matrix dt / 6 [2 1; 1 2] plus smoothing_s^2 times the
    // stiffness matrix 1 / dt [1 -1; -1 1].
    const double diagonal = dt / 3.0 + smoothing_s * smoothing_s / dt,
                 neighbouring = dt / 6.0 - smoothing_s * smoothing_s / dt;
    interval << diagonal, neighbouring, neighbouring, diagonal;
    for (Index k = 0; k + 1 < time.rows(); ++k) time.block<2, 2>(k, k) += interval;
    const Index count = fields.volume.rows();
    MatrixXd R(count * knots.count, count * knots.count);
    for (Index i = 0; i < time.rows(); ++i)
        for (Index j = 0; j < time.cols(); ++j)
            R.block(count * i, count * j, count, count) = time(i, j) * fields.volume;
    return R;
}

/// Trial of the best fit, run with an additional force.
class ForcedTrial {
public:
    ForcedTrial(const setup::Setup& setup, const Diagnosis& d, std::size_t trial)
        : setup_(setup),
          policy_(d.settings.policy.force),
          values_(d.augmented.fit.values),
          trial_(trial),
          affected_(prediction::affected_trial(setup, trial, values_)),
          basis_{force_fields(*affected_.model.body, policy_), knot_times(affected_.options.end_s, policy_)},
          data_(fit_data(setup, {trial})) {
        // The numerical error is taken off here, too; else the force would explain it.
        data_.shift = d.data.shift;
    }

    struct Run {
        dynamics::Trace trace;
        VectorXd residual;  // empty: the run failed
    };
    /// Runs the trial with the force of these knot values [N/m3].
    /// @param sizes  fields x knots, in the order of the columns of force_response()
    Run run(const VectorXd& sizes, const Progress& progress) const {
        model::Model model = affected_.model;
        const auto count = static_cast<Index>(basis_.fields.patterns.size());
        const Eigen::Map<const MatrixXd> courses(sizes.data(), count, basis_.knots.count);
        std::vector<TimedForce> forces;
        for (Index f = 0; f < count; ++f)
            forces.push_back({basis_.fields.patterns[static_cast<std::size_t>(f)],
                              knot_signal(basis_.knots, courses.row(f).transpose())});
        model.force_elements.push_back(timed_forces(std::move(forces)));
        Run result{dynamics::simulate(model, affected_.options, progress), {}};
        if (result.trace.complete())
            result.residual = flat_residual(data_, {prediction::observe_trial(setup_, trial_, values_, result.trace)});
        return result;
    }

    MatrixXd response(const Progress& progress) const {
        return force_response(setup_, data_, values_, basis_, policy_, progress);
    }

    const effect::Affected& affected() const { return affected_; }
    const ForceBasis& basis() const { return basis_; }
    const ForceFields& fields() const { return basis_.fields; }
    const KnotTimes& knots() const { return basis_.knots; }
    const MissingForcePolicy& policy() const { return policy_; }
    std::size_t trial() const { return trial_; }

private:
    const setup::Setup& setup_;
    const MissingForcePolicy& policy_;
    const prediction::ParameterValues& values_;
    std::size_t trial_;
    effect::Affected affected_;
    ForceBasis basis_;
    FitData data_;
};

/// Knot values with the smallest residual of a run, from repeated Tikhonov steps.
struct FoundForce {
    VectorXd sizes;
    ForcedTrial::Run run;
};
/// Gauss-Newton iterations with a fixed Jacobian A and a residual that falls gradually: the response is linearised
/// once, and a large force moves the body out of its range.
/// @param A     see force_response()
/// @param runs  counts the runs
FoundForce repeated_steps(const ForcedTrial& trial, const MatrixXd& A, ForcedTrial::Run start, int& runs,
                          const Progress& progress) {
    const MissingForcePolicy& policy = trial.policy();
    const SmoothForce solver(A, size_of_force(trial.basis(), policy.smoothing_s), policy);
    FoundForce best{VectorXd::Zero(A.cols()), std::move(start)};
    const double wanted = noise_squares(A.rows(), policy);
    double share = policy.first_share;
    for (int step = 0; step < policy.max_runs && share < 1.0 &&
                       best.run.residual.squaredNorm() > policy.noise_margin * wanted && !progress.cancelled();
         ++step) {
        progress.report({"missing force", 2.0 + step, 2.0 + policy.max_runs, "runs", {}});
        const double before = best.run.residual.squaredNorm();
        // The target is above what the linear response can reach: the last part needs large forces and is its own
        // error.
        const VectorXd sizes = solver.solve(best.run.residual - A * best.sizes, std::max(wanted, share * before));
        ForcedTrial::Run run = trial.run(sizes, progress);
        ++runs;
        // The step went beyond the linear range: a higher target gives a smaller force.
        if (run.residual.size() == 0 || !(run.residual.squaredNorm() < before)) {
            share *= policy.share_factor;
            continue;
        }
        best = {sizes, std::move(run)};
        if (best.run.residual.squaredNorm() > policy.min_gain * before) break;
    }
    return best;
}

/// Direction of a mode in words, for ForceMode::where.
std::string direction_words(const ForceMode& mode, const MissingForcePolicy& policy) {
    if (mode.aligned < policy.min_aligned) return "in opposite directions along the body, like a moment";
    Index axis = 0;
    if (mode.direction.cwiseAbs().maxCoeff(&axis) > policy.along_axis)
        return std::string("along ") + (mode.direction(axis) > 0.0 ? "+" : "\u2212") + "xyz"[axis];
    std::string words;
    for (Index i = 0; i < 3; ++i)
        if (std::abs(mode.direction(i)) > policy.min_component)
            words += std::string(words.empty() ? "between " : " and ") + (mode.direction(i) > 0.0 ? "+" : "\u2212") +
                     "xyz"[i];
    return words;
}

/// Place of a mode in words, for ForceMode::where.
/// @param place, spread  mean and standard deviation along the body, in units of its length
std::string place_words(double place, double spread, const MissingForcePolicy& policy) {
    if (place > policy.at_end) return "at the free end";
    if (place > policy.near_end) return "nearer the free end";
    if (place < policy.at_clamp) return "at the clamp";
    if (place < policy.near_clamp) return "nearer the clamp";
    return spread < policy.concentrated ? "at the middle of the body" : "along the whole body";
}

/// Normalises a mode and computes what is reported about it.
void describe(const model::Body& body, const ForceFields& fields, const MissingForcePolicy& policy, ForceMode& mode) {
    VectorXd lengths = mode.pattern.colwise().norm().transpose();
    const double total = lengths.sum();
    // Magnitudes sum to 1, so that the amplitude is a force in N; a positive main component fixes the sign of the pair.
    mode.pattern /= total;
    mode.amplitude_N *= total;
    lengths /= total;
    Vector3d sum = mode.pattern.rowwise().sum();
    Index axis = 0;
    sum.cwiseAbs().maxCoeff(&axis);
    if (sum(axis) < 0.0) {
        mode.pattern = -mode.pattern;
        mode.amplitude_N = -mode.amplitude_N;
        sum = -sum;
    }
    mode.aligned = sum.norm();
    mode.direction = sum.normalized();
    mode.centroid_m = body.mesh.nodes * lengths;
    mode.place = fields.place.dot(lengths);
    const double spread = std::sqrt(std::max(0.0, fields.place.cwiseAbs2().dot(lengths) - mode.place * mode.place));
    mode.where = place_words(mode.place, spread, policy) + ", " + direction_words(mode, policy);
    const double square = mode.amplitude_N.squaredNorm() / static_cast<double>(mode.amplitude_N.size());
    mode.steady = square > 0.0 ? std::pow(mode.amplitude_N.mean(), 2) / square : 0.0;
}

/// Modes (distribution times course) with the largest shares of the squared force.
std::vector<ForceMode> force_modes(const ForcedTrial& trial, const VectorXd& sizes) {
    const ForceFields& fields = trial.fields();
    const MissingForcePolicy& policy = trial.policy();
    const Eigen::Map<const MatrixXd> courses(sizes.data(), fields.volume.rows(), trial.knots().count);
    // With U'U = volume, squares of U * courses are integrals over the body, whatever the basis of fields.
    const Eigen::LLT<MatrixXd> volume(fields.volume);
    const MatrixXd weighted = volume.matrixU() * courses;
    const LeadingSvd svd = leading_svd(weighted, policy.max_modes);
    const double all = weighted.squaredNorm();
    std::vector<ForceMode> modes;
    double shown = 0.0;
    for (Index k = 0; k < svd.sizes.size() && all > 0.0 && shown < policy.reported_share; ++k) {
        ForceMode mode;
        mode.share = std::pow(svd.sizes(k), 2) / all;
        if (mode.share < policy.min_mode) break;
        shown += mode.share;
        // Back from these coordinates to those of the fields.
        const VectorXd of_field = volume.matrixU().solve(VectorXd(svd.left.col(k)));
        mode.pattern = Matrix3Xd::Zero(3, fields.place.size());
        for (std::size_t f = 0; f < fields.patterns.size(); ++f)
            mode.pattern += of_field(static_cast<Index>(f)) * fields.patterns[f];
        mode.amplitude_N = svd.sizes(k) * svd.right.col(k);
        describe(*trial.affected().model.body, fields, policy, mode);
        modes.push_back(std::move(mode));
    }
    return modes;
}

/// Root mean square; 0 of an empty vector.
double rms_of(const VectorXd& r) {
    return std::sqrt(r.squaredNorm() / static_cast<double>(std::max<Index>(1, r.size())));
}

}  // namespace

double ForceMode::rms_N() const { return rms_of(amplitude_N); }
double ForceMode::peak_N() const { return amplitude_N.size() > 0 ? amplitude_N.cwiseAbs().maxCoeff() : 0.0; }

double MissingForce::removed() const {
    return before_over_noise > 0.0 ? 1.0 - std::pow(after_over_noise / before_over_noise, 2) : 0.0;
}

MissingForce infer_missing_force(const setup::Setup& declared, const Diagnosis& d, const Progress& progress) {
    MissingForce result;
    if (!d.augmented.usable() || d.data.trials.empty()) {
        result.failure = "there is no fit to begin from";
        return result;
    }
    // The fit was made with these steps and this element.
    const setup::Setup setup = as_diagnosed(d, declared);
    const MissingForcePolicy& policy = d.settings.policy.force;
    if (const std::size_t worst = worst_trial(d.data, d.augmented.fit.residual); setup.trials[worst].hold) {
        result.trial = setup.trials[worst].name;
        result.failure = "the worst trial, " + result.trial + ", is a hold, and the course of a force needs a motion";
        return result;
    }
    const ForcedTrial trial(setup, d, worst_trial(d.data, d.augmented.fit.residual));
    result.trial = setup.trials[trial.trial()].name;
    result.time_s = trial.knots().times_s();
    progress.report({"missing force", 0.0, 2.0 + policy.max_runs, "runs", {}});
    ForcedTrial::Run start = trial.run(
        VectorXd::Zero(static_cast<Index>(trial.fields().patterns.size()) * trial.knots().count), progress);
    if (start.residual.size() == 0) {
        result.failure = "the trial cannot be run: " + start.trace.message;
        return result;
    }
    result.before_over_noise = result.after_over_noise = rms_of(start.residual);
    progress.report({"missing force", 1.0, 2.0 + policy.max_runs, "runs", {}});
    const MatrixXd A = trial.response(progress);
    result.runs = 2;
    if (A.size() == 0 || !A.allFinite()) {
        result.failure = "the response to a force cannot be run";
        return result;
    }
    const FoundForce found = repeated_steps(trial, A, std::move(start), result.runs, progress);
    result.after_over_noise = rms_of(found.run.residual);
    result.modes = force_modes(trial, found.sizes);
    const double squares_before = std::pow(result.before_over_noise, 2) * static_cast<double>(A.rows());
    // Reasons from the most harmless one on: nothing to explain, no force found, a force that explains too little.
    if (result.modes.empty())
        result.failure = squares_before <= policy.noise_margin * noise_squares(A.rows(), policy)
                             ? "the residual is noise"
                             : "no force makes the residual smaller";
    else if (result.removed() < policy.min_explained) {
        result.modes.clear();
        result.failure = "no smooth force takes away more than " + format_number(100.0 * result.removed(), 1) +
                         " % of the square of what is left in " + result.trial +
                         ": it may be in the recording (markers, names, times) rather than in the body";
    }
    for (ForceMode& mode : result.modes)
        mode.correlates = course_correlates(setup, trial.affected(), found.run.trace, trial.knots(), mode, policy);
    return result;
}

}  // namespace myo::diagnosis
