#pragma once

namespace myo::statistics {

/// Tails and quantiles of the distributions that the tests refer to; thin over Boost.Math. Tails are clamped to [0, 1],
/// and arguments below the support give 1.

/// P(X > x) for chi^2 with `freedom` > 0 degrees of freedom.
double chi_squared_tail(double x, double freedom);

/// ln P(X > x), also where the tail itself is below the smallest number.
double log_chi_squared_tail(double x, double freedom);

/// x with P(X > x) = tail, 0 < tail < 1.
double chi_squared_upper_quantile(double tail, double freedom);

/// P(X > x) for Fisher's F with `above` and `below` > 0 degrees of freedom.
double fisher_f_tail(double x, double above, double below);

/// P(|X| > |t|) for Student's t.
double student_two_sided(double t, double freedom);

/// P(X > x) for the standard normal distribution, and its inverse.
double normal_tail(double x);
double normal_upper_quantile(double tail);

/// P(X > x) for the gamma distribution of given mean, deviation and (positive) skewness, shifted accordingly.
double shifted_gamma_tail(double x, double mean, double deviation, double skewness);

}  // namespace myo::statistics
