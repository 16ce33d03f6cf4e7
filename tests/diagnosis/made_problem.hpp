#pragma once

#include <string>
#include <vector>

#include "diagnosis/fit/joint_fit.hpp"

// Data and fits of a few numbers for tests of single phases.

namespace myo::test {

inline constexpr double made_noise_m = 1e-4;

/// Samples of one marker along x in each trial, 10 ms apart.
inline diagnosis::FitData made_data(int samples, int trials = 1) {
    diagnosis::FitData data;
    for (int t = 0; t < trials; ++t) {
        data.trials.push_back(static_cast<std::size_t>(t));
        data.layout.series.push_back({t, 0, 0, t * samples, (t + 1) * samples});
        for (int k = 0; k < samples; ++k) {
            data.layout.sample.push_back(k);
            data.layout.time_s.push_back(0.01 * k);
        }
    }
    data.noise_m = Eigen::VectorXd::Constant(samples * trials, made_noise_m);
    return data;
}

/// Declared modulus of made fits, which may go from half to twice of it.
inline constexpr double made_modulus_Pa = 1e5;

inline prediction::ModelParameter modulus_parameter() {
    prediction::ModelParameter p;
    p.kind = prediction::ModelParameter::Kind::youngs_modulus;
    p.parameter = {"youngs_modulus_Pa", made_modulus_Pa, 0.5 * made_modulus_Pa, 2.0 * made_modulus_Pa, made_modulus_Pa};
    return p;
}

/// Fit of the modulus.
/// @param column  derivative of the residual by the modulus [noise levels per declared modulus]
inline diagnosis::JointFit made_fit(const Eigen::VectorXd& residual, const Eigen::VectorXd& column) {
    diagnosis::JointFit fit;
    fit.parameters = {modulus_parameter()};
    fit.values.youngs_modulus_Pa = made_modulus_Pa;
    fit.residual = residual;
    fit.jacobian = column / made_modulus_Pa;
    return fit;
}

/// A shift of every sample of made_data(): trial by trial, along x [m].
inline diagnosis::PredictionShift made_shift(const std::vector<Eigen::VectorXd>& along_x) {
    diagnosis::PredictionShift shift;
    for (const Eigen::VectorXd& x : along_x) {
        Eigen::Matrix3Xd track = Eigen::Matrix3Xd::Zero(3, x.size());
        track.row(0) = x.transpose();
        shift.push_back({track});
    }
    return shift;
}

}  // namespace myo::test
