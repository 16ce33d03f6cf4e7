#include "prediction/weighted_residuals.hpp"

#include <algorithm>
#include <cmath>

#include "prediction/marker_places.hpp"

namespace myo::prediction {
namespace {

/// Residuals are linear in the places but for the variation of the deformation gradient within a cell.
struct ProbablePlacePolicy {
    int max_rounds = 6;     // two or three do, unless a marker lies on the border of cells
    double settled = 1e-5;  // change of a place over its deviation
};
constexpr ProbablePlacePolicy probable_place_policy;

/// Rows of all residuals of these trials.
Eigen::Index row_count(const setup::Setup& setup, const std::vector<std::size_t>& trials) {
    Eigen::Index rows = 0;
    for (const std::size_t t : trials) {
        const setup::PreparedTrial& trial = setup.trials[t];
        rows += 3 * static_cast<Eigen::Index>(setup.marker_names.size()) * trial.measured.sample_count();
        for (const setup::SensorSeries& series : trial.sensors) rows += series.values.size();
    }
    return rows;
}

/// Residuals and Jacobian at the places of the predictions.
void set_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                   const std::vector<TrialPrediction>& predictions, std::size_t parameters,
                   inverse::ResidualEvaluation& result) {
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < predictions.size(); ++i) {
        const TrialPrediction& prediction = predictions[i];
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            const double weight = 1.0 / setup.noise_m(static_cast<Eigen::Index>(m));
            const Eigen::Matrix3Xd& residual = prediction.residual_m[m];
            for (Eigen::Index k = 0; k < residual.size(); ++k, ++row) {
                // Rows of occluded coordinates stay zero, so row numbers do not depend on the prediction.
                if (!std::isfinite(residual.data()[k])) continue;
                result.residuals(row) = weight * residual.data()[k];
                for (std::size_t p = 0; p < parameters; ++p)
                    result.jacobian(row, static_cast<Eigen::Index>(p)) = weight * prediction.tangents[p][m].data()[k];
            }
        }
        for (std::size_t s = 0; s < prediction.sensor_residuals.size(); ++s) {
            const double weight = 1.0 / setup.trials[trials[i]].sensors[s].noise;
            for (Eigen::Index k = 0; k < prediction.sensor_residuals[s].size(); ++k, ++row) {
                if (!std::isfinite(prediction.sensor_residuals[s][k])) continue;
                result.residuals(row) = weight * prediction.sensor_residuals[s][k];
                for (std::size_t p = 0; p < parameters; ++p)
                    if (const double slope = prediction.sensor_tangents[p][s][k]; std::isfinite(slope))
                        result.jacobian(row, static_cast<Eigen::Index>(p)) = weight * slope;
            }
        }
    }
}

/// Places of the predictions in units of their deviation, 3 per marker.
Eigen::VectorXd assumed_places(const setup::Setup& setup, const std::vector<TrialPrediction>& predictions) {
    Eigen::VectorXd places = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(setup.marker_names.size()));
    if (predictions.empty()) return places;
    for (std::size_t m = 0; m < predictions.front().places_m.size(); ++m)
        places.segment<3>(3 * static_cast<Eigen::Index>(m)) = predictions.front().places_m[m] /
                                                              setup.experiment.markers.placement_m;
    return places;
}

}  // namespace

inverse::MarginalNuisance unknown_places(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                         const std::vector<TrialPrediction>& predictions) {
    const double placement_m = setup.experiment.markers.placement_m;
    if (!(placement_m > 0.0)) return {};
    for (const TrialPrediction& prediction : predictions)
        if (!prediction.ok()) return {};
    const std::size_t markers = setup.marker_names.size();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(row_count(setup, trials), 3 * static_cast<Eigen::Index>(markers));
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < predictions.size(); ++i) {
        for (std::size_t m = 0; m < markers; ++m) {
            const double weight = placement_m / setup.noise_m(static_cast<Eigen::Index>(m));
            const Eigen::Matrix3Xd& residual = predictions[i].residual_m[m];
            for (std::size_t p = 0; p < predictions[i].place_tangents.size(); ++p) {
                const Eigen::Matrix3Xd& tangent = predictions[i].place_tangents[p][m];
                for (Eigen::Index k = 0; k < tangent.size(); ++k)
                    if (std::isfinite(residual.data()[k]))
                        A(row + k, static_cast<Eigen::Index>(p)) = weight * tangent.data()[k];
            }
            row += residual.size();
        }
        for (const setup::SensorSeries& series : setup.trials[trials[i]].sensors) row += series.values.size();
    }
    return inverse::MarginalNuisance(std::move(A));
}

inverse::ResidualEvaluation weighted_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                               const std::vector<TrialPrediction>& predictions,
                                               std::size_t parameters) {
    inverse::ResidualEvaluation result;
    for (std::size_t i = 0; i < trials.size(); ++i)
        if (!predictions[i].ok()) {
            result.message = "trial " + setup.trials[trials[i]].name + ": " + predictions[i].message;
            return result;
        }
    const Eigen::Index rows = row_count(setup, trials);
    result.residuals = Eigen::VectorXd::Zero(rows);
    result.jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(parameters));
    set_residuals(setup, trials, predictions, parameters, result);
    if (const inverse::MarginalNuisance places = unknown_places(setup, trials, predictions); !places.empty()) {
        result.residuals -= places.derivatives() * assumed_places(setup, predictions);
        result.residuals = places.whitened(result.residuals);
        result.jacobian = places.whitened(result.jacobian);
    }
    result.ok = true;
    return result;
}

std::vector<TrialPrediction> at_probable_places(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                                ParameterValues& values, std::vector<TrialPrediction> predictions) {
    for (int round = 0; round < probable_place_policy.max_rounds; ++round) {
        const inverse::MarginalNuisance unknown = unknown_places(setup, trials, predictions);
        if (unknown.empty()) break;
        const std::vector<Eigen::Vector3d> places = probable_places(
            setup, unknown, weighted_residuals(setup, trials, predictions, 0).residuals);
        double change_m = 0.0;
        for (std::size_t m = 0; m < places.size(); ++m)
            change_m = std::max(change_m,
                                (values.places_m.empty() ? places[m] : places[m] - values.places_m[m]).norm());
        if (change_m < probable_place_policy.settled * setup.experiment.markers.placement_m) break;
        values.places_m = places;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            TrialPrediction seen = observe_trial(setup, trials[i], values, predictions[i].trace);
            seen.trace = std::move(predictions[i].trace);
            seen.sensor_residuals = std::move(predictions[i].sensor_residuals);
            predictions[i] = std::move(seen);
        }
    }
    return predictions;
}

}  // namespace myo::prediction
