#include "diagnosis/fit/sensor_rows.hpp"

#include <cassert>
#include <cmath>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// value(prediction, series, reading) over what each reading may be off by; 0 where it is not finite.
template <class Value>
VectorXd readings(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                  const std::vector<prediction::TrialPrediction>& predictions, const DeclaredFitPolicy& policy,
                  const Value& value) {
    assert(predictions.size() == trials.size());
    // The number of rows depends on the setup alone, so that residuals of all fits have one length.
    Index rows = 0;
    for (const std::size_t trial : trials)
        for (const setup::SensorSeries& series : setup.trials[trial].sensors) rows += series.values.size();
    VectorXd flat = VectorXd::Zero(rows);
    Index row = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::vector<setup::SensorSeries>& sensors = setup.trials[trials[i]].sensors;
        for (std::size_t s = 0; s < sensors.size(); ++s)
            for (Index k = 0; k < sensors[s].values.size(); ++k, ++row)
                if (const double at = value(predictions[i], s, k); std::isfinite(at))
                    flat(row) = at /
                                std::hypot(sensors[s].noise, policy.numerical_share_of_readings * sensors[s].values(k));
    }
    return flat;
}

}  // namespace

VectorXd sensor_rows(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                     const std::vector<prediction::TrialPrediction>& predictions, const DeclaredFitPolicy& policy) {
    return readings(
        setup, trials, predictions, policy,
        [](const prediction::TrialPrediction& p, std::size_t s, Index k) { return p.sensor_residuals[s](k); });
}

VectorXd sensor_slope(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                      const std::vector<prediction::TrialPrediction>& predictions, std::size_t number,
                      const DeclaredFitPolicy& policy) {
    return readings(setup, trials, predictions, policy,
                    [number](const prediction::TrialPrediction& p, std::size_t s, Index k) {
                        return p.sensor_tangents[number][s](k);
                    });
}

}  // namespace myo::diagnosis
