#pragma once

#include <Eigen/Core>

namespace myo::measurement {

struct SmoothingPolicy {
    Eigen::Index degree = 5;  // the least with a second derivative that is itself twice differentiable
    /// Range of the weight of the third differences against the squared errors, and the factor between weights tried.
    /// The least changes motion at a third of the sampling rate by less than a percent.
    double least_weight = 1e-6, most_weight = 1e10, factor = 1.7782794100389228;  // a quarter of a decade
    double difference = 0.05;  // of ln(weight), for the derivative of the determinant
};
inline constexpr SmoothingPolicy smoothing_policy;

/// Spline of degree five with equal intervals: its second derivative is smooth.
struct QuinticSpline {
    double first_s = 0.0;      // start of the first interval
    double interval_s = 1.0;   // length of an interval
    Eigen::MatrixXd controls;  // components x (intervals + 5)

    double last_s() const;
    /// Derivative of order 0, 1 or 2 at a time [s]. Constant before the first interval, straight after the last.
    Eigen::VectorXd at(double time_s, int order = 0) const;
};

/// Spline through noisy samples, without delay: sum of squared errors plus a weight times squared third differences of
/// the controls. Of all weights it takes the one of least expected error for noise of known size (unbiased risk).
///
/// @param time_s    ascending; gaps are bridged
/// @param samples   components x times, at least six
/// @param variance  of the noise of one sample, summed over the components; white
/// Source: Eilers & Marx 1996, Stat. Sci. 11, 89 (penalty); Craven & Wahba 1979, Numer. Math. 31, 377 (weight);
/// Woltring 1986, Adv. Eng. Softw. 8, 104 (degree five for accelerations).
QuinticSpline smoothing_spline(const Eigen::VectorXd& time_s, const Eigen::MatrixXd& samples, double variance);

}  // namespace myo::measurement
