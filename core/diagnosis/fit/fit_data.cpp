#include "diagnosis/fit/fit_data.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "prediction/marker_places.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Whether a sample of a marker is compared: not before the first compared sample, and only if measured.
bool is_compared(const setup::Setup& setup, std::size_t trial, std::size_t marker, Index sample) {
    const setup::PreparedTrial& t = setup.trials[trial];
    return sample >= t.first_sample && t.measured.tracks[marker].col(sample).allFinite();
}

/// value(series, sample) for every entry of the layout, N.
template <class Value>
VectorXd gathered(const FitData& data, const Value& value) {
    VectorXd flat(data.layout.size());
    for (const statistics::ResidualSeries& series : data.layout.series)
        for (Index k = series.begin; k < series.end; ++k)
            flat(k) = value(series, data.layout.sample[static_cast<std::size_t>(k)]);
    return flat;
}

/// Position of each trial of the setup in data.trials.
/// Positions of trials that are not fitted are 0 and never read.
std::vector<std::size_t> places(const FitData& data) {
    std::vector<std::size_t> place;
    for (std::size_t i = 0; i < data.trials.size(); ++i) {
        if (place.size() <= data.trials[i]) place.resize(data.trials[i] + 1);
        place[data.trials[i]] = i;
    }
    return place;
}

/// Shift of one entry [m]; 0 if there is none.
double shift_at(const PredictionShift& shift, const statistics::ResidualSeries& at, int sample) {
    const auto trial = static_cast<std::size_t>(at.trial);
    return shift.empty() || shift[trial].empty() ? 0.0
                                                 : shift[trial][static_cast<std::size_t>(at.marker)](at.axis, sample);
}

/// Derivatives of the flat residual by the places of the markers over their deviation, N x 3 markers.
Eigen::MatrixXd place_columns(const setup::Setup& setup, const FitData& data,
                              const std::vector<prediction::TrialPrediction>& predictions) {
    const std::vector<std::size_t> place = places(data);
    Eigen::MatrixXd A(data.layout.size(), 3 * static_cast<Index>(setup.marker_names.size()));
    for (Index k = 0; k < A.cols(); ++k)
        A.col(
            k) = setup.experiment.markers.placement_m *
                 gathered(data, [&](const statistics::ResidualSeries& at, int sample) {
                     const prediction::TrialPrediction& there = predictions[place[static_cast<std::size_t>(at.trial)]];
                     const Eigen::Matrix3Xd& tangent = there.place_tangents[static_cast<std::size_t>(k)]
                                                                           [static_cast<std::size_t>(at.marker)];
                     return tangent.cols() > 0 ? tangent(at.axis, sample) : 0.0;
                 }).cwiseQuotient(data.noise_m);
    return A;
}

/// Flat residual at the declared places if it was computed at those of the predictions.
/// The residual is linear in the places: going back by `assumed` is a product with the derivatives, without a run.
VectorXd at_declared_places(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions,
                            VectorXd residual) {
    const std::vector<Eigen::Vector3d>& assumed = predictions.front().places_m;
    for (std::size_t m = 0; m < assumed.size(); ++m)
        residual -= data.places.derivatives().middleCols<3>(3 * static_cast<Index>(m)) *
                    (assumed[m] / data.placement_m);
    return residual;
}

}  // namespace

FitData with_unknown_places(const setup::Setup& setup, FitData data,
                            const std::vector<prediction::TrialPrediction>& predictions) {
    data.placement_m = setup.experiment.markers.placement_m;
    if (data.placement_m > 0.0) data.places = inverse::MarginalNuisance(place_columns(setup, data, predictions));
    return data;
}

std::vector<Eigen::Vector3d> probable_places(const setup::Setup& setup, const FitData& data, const VectorXd& residual) {
    return prediction::probable_places(setup, data.places, residual);
}

FitData fit_data(const setup::Setup& setup, const std::vector<std::size_t>& trials) {
    FitData data;
    data.trials = trials;
    data.noise_declared = setup.experiment.markers.noise_m.has_value();
    std::vector<double> noise;
    for (const std::size_t trial : trials)
        for (std::size_t marker = 0; marker < setup.marker_names.size(); ++marker)
            for (int axis = 0; axis < 3; ++axis) {
                statistics::ResidualSeries series{static_cast<int>(trial), static_cast<int>(marker), axis,
                                                  data.layout.size(), 0};
                for (Index s = 0; s < setup.trials[trial].measured.sample_count(); ++s) {
                    if (!is_compared(setup, trial, marker, s)) continue;
                    data.layout.sample.push_back(static_cast<int>(s));
                    data.layout.time_s.push_back(setup.trials[trial].measured.time_s(s));
                    noise.push_back(setup.noise_m(static_cast<Index>(marker)));
                }
                series.end = data.layout.size();
                if (series.size() > 0) data.layout.series.push_back(series);
            }
    data.noise_m = Eigen::Map<VectorXd>(noise.data(), static_cast<Index>(noise.size()));
    return data;
}

VectorXd flat_residual(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions) {
    assert(predictions.size() == data.trials.size());
    // Order of operations: shift in metres, division by the noise, then whitening by the unknown places.
    const std::vector<std::size_t> place = places(data);
    const VectorXd metres = gathered(data, [&](const statistics::ResidualSeries& at, int sample) {
        const auto trial = static_cast<std::size_t>(at.trial), marker = static_cast<std::size_t>(at.marker);
        return predictions[place[trial]].residual_m[marker](at.axis, sample) + shift_at(data.shift, at, sample);
    });
    const VectorXd residual = metres.cwiseQuotient(data.noise_m);
    return data.places.empty() ? residual
                               : VectorXd(data.places.whitened(at_declared_places(data, predictions, residual)));
}

VectorXd flat_shift(const FitData& data, const PredictionShift& shift) {
    return data.places.whitened(gathered(data, [&](const statistics::ResidualSeries& at, int sample) {
                                    return shift_at(shift, at, sample);
                                }).cwiseQuotient(data.noise_m));
}

Eigen::MatrixXd flat_jacobian(const FitData& data, const std::vector<prediction::TrialPrediction>& predictions,
                              std::size_t parameters) {
    const std::vector<std::size_t> place = places(data);
    Eigen::MatrixXd J(data.layout.size(), static_cast<Index>(parameters));
    for (std::size_t p = 0; p < parameters; ++p)
        J.col(static_cast<Index>(p)) = gathered(data, [&](const statistics::ResidualSeries& at, int sample) {
                                           return predictions[place[static_cast<std::size_t>(at.trial)]]
                                               .tangents[p][static_cast<std::size_t>(at.marker)](at.axis, sample);
                                       }).cwiseQuotient(data.noise_m);
    return data.places.whitened(J);
}

VectorXd flat_tangent(const FitData& data, const TrialTangents& tangents) {
    const std::vector<std::size_t> place = places(data);
    return data.places.whitened(
        gathered(data, [&](const statistics::ResidualSeries& at, int sample) {
            return tangents[place[static_cast<std::size_t>(at.trial)]][static_cast<std::size_t>(at.marker)](at.axis,
                                                                                                            sample);
        }).cwiseQuotient(data.noise_m));
}

double mean_noise_m(const FitData& data) {
    return std::sqrt(data.noise_m.squaredNorm() / static_cast<double>(std::max<Index>(1, data.noise_m.size())));
}

double flat_rms_m(const FitData& data, const VectorXd& residual) {
    return std::sqrt(residual.cwiseProduct(data.noise_m).squaredNorm() /
                     static_cast<double>(std::max<Index>(1, residual.size())));
}

std::size_t worst_trial(const FitData& data, const VectorXd& residual) {
    std::size_t worst = data.trials.front();
    double most = -1.0;
    for (const std::size_t trial : data.trials) {
        double sum = 0.0;
        Index count = 0;
        for (const statistics::ResidualSeries& series : data.layout.series)
            if (series.trial == static_cast<int>(trial)) {
                sum += residual.segment(series.begin, series.size()).squaredNorm();
                count += series.size();
            }
        if (count > 0 && sum / static_cast<double>(count) > most) {
            most = sum / static_cast<double>(count);
            worst = trial;
        }
    }
    return worst;
}

prediction::TrialPrediction shifted(prediction::TrialPrediction prediction, const PredictionShift& shift,
                                    std::size_t trial) {
    if (!prediction.ok() || shift.empty() || shift[trial].empty()) return prediction;
    for (std::size_t m = 0; m < prediction.residual_m.size(); ++m) {
        prediction.residual_m[m] += shift[trial][m];
        prediction.positions_m[m] += shift[trial][m];
    }
    return prediction;
}

}  // namespace myo::diagnosis
