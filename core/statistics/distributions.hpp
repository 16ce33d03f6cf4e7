#pragma once

namespace myo::statistics {

// Tails and quantiles of the reference distributions, implemented with Boost.Math. Tails are clamped to [0, 1];
// arguments below the support give 1.

/// P(X > x) for chi^2 with `freedom` > 0 degrees of freedom.
double chi_squared_tail(double x, double freedom);

/// ln P(X > x) for chi^2; also valid if the tail underflows double precision.
double log_chi_squared_tail(double x, double freedom);

/// Quantile x with P(X > x) = tail for chi^2, 0 < tail < 1.
double chi_squared_upper_quantile(double tail, double freedom);

/// P(X > x) for noncentral chi^2 with `freedom` > 0 degrees of freedom and a noncentrality >= 0.
double noncentral_chi_squared_tail(double x, double freedom, double noncentrality);

/// P(X > x) for Fisher's F with `above` and `below` > 0 degrees of freedom.
double fisher_f_tail(double x, double above, double below);

/// P(|X| > |t|) for Student's t with `freedom` > 0.
double student_two_sided(double t, double freedom);

/// P(X > x) for the standard normal distribution.
double normal_tail(double x);
/// Quantile x with P(X > x) = tail for the standard normal distribution, 0 < tail < 1.
double normal_upper_quantile(double tail);

/// P(X > x) for a shifted gamma distribution with the given mean, standard deviation and (positive) skewness. A
/// deviation of 0 gives a step at the mean.
double shifted_gamma_tail(double x, double mean, double deviation, double skewness);

}  // namespace myo::statistics
