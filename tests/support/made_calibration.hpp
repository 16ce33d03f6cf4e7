#pragma once

#include <cmath>
#include <limits>

#include "calibration/calibrate.hpp"
#include "support/known_run.hpp"

namespace myo::test {

/// A converged calibration of modulus and damping with round figures, made without a fit: 250 kPa, 4 ms; standard
/// deviations of the modulus by noise 300 Pa, by mesh 400 Pa, by step 1200 Pa (1300 in all), of the damping 0.1 ms by
/// noise alone. Trials miss their recordings by 3 mm before and by 0.3 mm after, the others by twice as much.
inline calibration::Calibration made_calibration(const setup::Setup& setup) {
    calibration::Calibration made;
    made.parameters = prediction::free_parameters(setup, {"youngs_modulus", "damping"});
    made.fit.status = inverse::FitStatus::converged;
    made.fit.start = Eigen::Vector2d(2.6e5, 0.003);
    made.fit.values = Eigen::Vector2d(2.5e5, 0.004);
    made.fit.deviations = Eigen::Vector2d(300.0, 1e-4);
    made.fit.correlation = Eigen::Matrix2d::Identity();
    made.fit.correlation(0, 1) = made.fit.correlation(1, 0) = -0.257;
    made.fit.history = {{made.fit.start, 80.0, 0.5}, {made.fit.values, 2.0, 0.25}};
    made.starts = {{made.fit.status, "", made.fit.start, made.fit.values, 80.0, 2.0, made.fit.history}};
    made.numerical.mesh = Eigen::Vector2d(400.0, 0.0);
    made.numerical.step = Eigen::Vector2d(1200.0, 0.0);
    made.earlier_evaluations = 5;
    made.seconds = 1.5;
    const auto misses = [&](double first_m) {
        std::vector<Eigen::Vector3d> vectors;
        for (std::size_t t = 0; t < setup.trials.size(); ++t)
            vectors.push_back((t == 0 ? first_m : 2.0 * first_m) * Eigen::Vector3d::UnitZ());
        return vectors;
    };
    made.before = run_missed_by(setup, misses(3e-3));
    made.after = run_missed_by(setup, misses(3e-4));
    made.after.values.youngs_modulus_Pa = 2.5e5;
    made.after.values.damping_s = 0.004;
    return made;
}

}  // namespace myo::test
