#include "prediction/marker_places.hpp"

#include <cmath>

#include "base/text.hpp"
#include "measurement/marker_places.hpp"
#include "measurement/rigid_motion.hpp"
#include "prediction/place_registration.hpp"

namespace myo::prediction {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

bool compares_displacements(const setup::Setup& setup) {
    return setup.experiment.markers.compare == experiment::Comparison::displacement;
}

}  // namespace

std::vector<std::vector<Matrix3Xd>> place_tangents(const setup::Setup& setup, std::size_t index,
                                                   const ParameterValues& values,
                                                   const measurement::ObservationError& error,
                                                   const measurement::MarkerSet& markers, const dynamics::Trace& trace,
                                                   const VectorXd& times_s) {
    if (!(setup.experiment.markers.placement_m > 0.0)) return {};
    const setup::PreparedTrial& trial = setup.trials[index];
    const measurement::MarkerSet columns = measurement::place_derivatives(markers);
    std::vector<Matrix3Xd> moving = measurement::laboratory_tangents(
        error, measurement::observe(trace, columns, times_s).positions, times_s);
    const VectorXd start_s = VectorXd::Zero(1);
    const std::vector<Matrix3Xd> origin = measurement::laboratory_tangents(
        error, measurement::observe(trace, columns, start_s).positions, start_s);
    const std::vector<Matrix3Xd> seen_from = measurement::laboratory_tracks(
                                     error, measurement::observe(trace, markers, times_s).positions, times_s),
                                 start_from = measurement::laboratory_tracks(
                                     error, measurement::observe(trace, markers, start_s).positions, start_s);
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    const Index samples = trial.measured.sample_count();
    std::vector<std::vector<Matrix3Xd>> tangents;
    for (std::size_t k = 0; k < moving.size(); ++k) {
        const std::size_t own = k / 3;
        // Only an exchange of names lets a place act on the tracks of other markers.
        std::vector<Matrix3Xd> tracks(markers.bindings.size(), Matrix3Xd::Zero(3, error.swaps.empty() ? 0 : samples));
        tracks[own] = std::move(moving[k]);
        tracks = measurement::observed_tangents(error, std::move(tracks), seen_from, trial.measured.time_s);
        if (compares_displacements(setup))
            tracks[own].colwise() -= measurement::seen_by_place(error, start_from[own].col(0)) *
                                     Vector3d(origin[k].col(0));
        else
            for (Matrix3Xd& track : tracks) track = (R * track).eval();
        if (trial.registration_by_places.size() > 0) {
            const std::vector<Matrix3Xd> change = registered_change(
                setup, trial, VectorXd::Unit(trial.registration_by_places.cols(), static_cast<Index>(k)));
            for (std::size_t m = 0; m < tracks.size(); ++m)
                tracks[m] = tracks[m].cols() > 0 ? Matrix3Xd(tracks[m] - change[m]) : Matrix3Xd(-change[m]);
        }
        tangents.push_back(std::move(tracks));
    }
    return tangents;
}

std::vector<Vector3d> probable_places(const setup::Setup& setup, const inverse::MarginalNuisance& places,
                                      const VectorXd& residuals) {
    if (places.empty()) return {};
    const VectorXd mean = setup.experiment.markers.placement_m * places.mean(residuals);
    std::vector<Vector3d> list;
    for (Index k = 0; k < mean.size(); k += 3) list.emplace_back(mean.segment<3>(k));
    return list;
}

std::vector<FoundPlace> found_places(const setup::Setup& setup, const inverse::MarginalNuisance& places,
                                     const VectorXd& residuals, const inverse::LeastSquaresReport& fit) {
    std::vector<FoundPlace> found;
    const std::vector<Vector3d> shifts = probable_places(setup, places, residuals);
    if (shifts.empty()) return found;
    // A parameter that the data do not determine stays where it is and adds nothing.
    const auto known = [](double value) { return std::isfinite(value) ? value : 0.0; };
    const VectorXd deviations = fit.deviations.unaryExpr(known);
    const Eigen::MatrixXd covariance = deviations.asDiagonal() * fit.correlation.unaryExpr(known) *
                                       deviations.asDiagonal();
    const bool derived = fit.jacobian.rows() == places.derivatives().rows();
    const Eigen::MatrixXd J = derived ? fit.jacobian : Eigen::MatrixXd(places.derivatives().rows(), 0);
    const VectorXd
        variance = places.covariance(J, derived ? covariance : Eigen::MatrixXd(0, 0)).diagonal().cwiseMax(0.0);
    for (std::size_t m = 0; m < shifts.size(); ++m) {
        if (setup.experiment.markers.on_body[m].probe) continue;  // nothing tells where it sits
        found.push_back({setup.marker_names[m], shifts[m],
                         setup.experiment.markers.placement_m *
                             Vector3d(variance.segment<3>(3 * static_cast<Index>(m)).cwiseSqrt())});
    }
    return found;
}

std::vector<std::size_t> far_markers(const setup::Setup& setup, const std::vector<Vector3d>& places_m) {
    const double most = far_place_policy.max_deviations * setup.experiment.markers.placement_m;
    std::vector<std::size_t> far;
    for (std::size_t m = 0; m < places_m.size(); ++m)
        if (places_m[m].cwiseAbs().maxCoeff() > most) far.push_back(m);
    return far;
}

std::string far_marker_sentence(const setup::Setup& setup, std::size_t marker, const Vector3d& shift_m) {
    return "marker " + setup.marker_names[marker] + " sits " + format_number(1e3 * shift_m.norm(), 3) +
           " mm from its declared place, more than " + format_number(far_place_policy.max_deviations) +
           " times markers.placement_m along an axis";
}

}  // namespace myo::prediction
