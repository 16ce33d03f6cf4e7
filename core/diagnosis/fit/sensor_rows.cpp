#include "diagnosis/fit/sensor_rows.hpp"

#include <cassert>
#include <cmath>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// value(prediction, series, reading) over the noise for every reading; 0 where it is not finite.
template <class Value>
VectorXd readings(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                  const std::vector<prediction::TrialPrediction>& predictions, const Value& value) {
    assert(predictions.size() == trials.size());
    Index rows = 0;
    for (const std::size_t trial : trials)
        for (const setup::SensorSeries& series : setup.trials[trial].sensors) rows += series.values.size();
    VectorXd flat = VectorXd::Zero(rows);
    Index row = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::vector<setup::SensorSeries>& sensors = setup.trials[trials[i]].sensors;
        for (std::size_t s = 0; s < sensors.size(); ++s)
            for (Index k = 0; k < sensors[s].values.size(); ++k, ++row)
                if (const double at = value(predictions[i], s, k); std::isfinite(at)) flat(row) = at / sensors[s].noise;
    }
    return flat;
}

}  // namespace

VectorXd sensor_rows(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                     const std::vector<prediction::TrialPrediction>& predictions) {
    return readings(setup, trials, predictions, [](const prediction::TrialPrediction& p, std::size_t s, Index k) {
        return p.sensor_residuals[s](k);
    });
}

VectorXd sensor_slope(const setup::Setup& setup, const std::vector<std::size_t>& trials,
                      const std::vector<prediction::TrialPrediction>& predictions, std::size_t number) {
    return readings(setup, trials, predictions, [number](const prediction::TrialPrediction& p, std::size_t s, Index k) {
        return p.sensor_tangents[number][s](k);
    });
}

}  // namespace myo::diagnosis
