#include "prediction/weighted_residuals.hpp"

#include <cmath>

namespace myo::prediction {

inverse::ResidualEvaluation weighted_residuals(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                               const std::vector<TrialPrediction>& predictions,
                                               std::size_t parameters) {
    inverse::ResidualEvaluation result;
    Eigen::Index rows = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const setup::PreparedTrial& trial = setup.trials[trials[i]];
        if (!predictions[i].ok()) {
            result.message = "trial " + trial.name + ": " + predictions[i].message;
            return result;
        }
        rows += 3 * static_cast<Eigen::Index>(setup.marker_names.size()) * trial.measured.sample_count();
        for (const setup::SensorSeries& series : trial.sensors) rows += series.values.size();
    }
    result.residuals = Eigen::VectorXd::Zero(rows);
    result.jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(parameters));
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
    result.ok = true;
    return result;
}

}  // namespace myo::prediction
