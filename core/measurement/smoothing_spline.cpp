#include "measurement/smoothing_spline.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index degree = smoothing_policy.degree;

/// Values of the uniform B-splines of a degree that are not zero in an interval, at u = 0 ... 1 within it.
std::array<double, degree + 1> basis(double u, Index of_degree) {
    std::array<double, degree + 1> b{1.0};
    for (Index d = 1; d <= of_degree; ++d) {
        std::array<double, degree + 1> next{};
        for (Index i = 0; i < d; ++i) {
            // Rising part of spline i + 1 and falling part of spline i.
            const double rise = (u + static_cast<double>(d - 1 - i)) / static_cast<double>(d);
            next[static_cast<std::size_t>(i + 1)] += rise * b[static_cast<std::size_t>(i)];
            next[static_cast<std::size_t>(i)] += (1.0 - rise) * b[static_cast<std::size_t>(i)];
        }
        b = next;
    }
    return b;
}

/// Symmetric matrix of bandwidth `degree`: row k of `bands` holds its k-th diagonal below the main one.
struct Banded {
    MatrixXd bands;

    explicit Banded(Index size) : bands(MatrixXd::Zero(degree + 1, size)) {}
    Index size() const { return bands.cols(); }
};

/// Cholesky factor in place; returns the logarithm of the determinant.
double factorise(Banded& matrix) {
    MatrixXd& L = matrix.bands;
    double log_determinant = 0.0;
    for (Index j = 0; j < L.cols(); ++j) {
        const double root = std::sqrt(L(0, j));
        log_determinant += 2.0 * std::log(root);
        L.col(j) /= root;
        L(0, j) = root;
        for (Index k = 1; k <= degree && j + k < L.cols(); ++k)
            for (Index r = k; r <= degree && j + r < L.cols(); ++r) L(r - k, j + k) -= L(k, j) * L(r, j);
    }
    return log_determinant;
}

/// Solves L L' X = B, one column of X' per unknown.
MatrixXd solve(const Banded& factor, MatrixXd B) {
    const MatrixXd& L = factor.bands;
    for (Index j = 0; j < L.cols(); ++j) {
        B.col(j) /= L(0, j);
        for (Index k = 1; k <= degree && j + k < L.cols(); ++k) B.col(j + k) -= L(k, j) * B.col(j);
    }
    for (Index j = L.cols() - 1; j >= 0; --j) {
        for (Index k = 1; k <= degree && j + k < L.cols(); ++k) B.col(j) -= L(k, j) * B.col(j + k);
        B.col(j) /= L(0, j);
    }
    return B;
}

/// Interval of a time and the place within it.
struct Place {
    Index interval = 0;
    double u = 0.0;
};
Place place_of(const QuinticSpline& spline, double time_s) {
    const double s = (time_s - spline.first_s) / spline.interval_s;
    const Index last = spline.controls.cols() - degree - 1;
    const Index i = std::clamp<Index>(static_cast<Index>(std::floor(s)), 0, last);
    return {i, s - static_cast<double>(i)};
}

/// Squared third differences of the controls.
Banded difference_penalty(Index size) {
    Banded penalty(size);
    constexpr std::array<double, 4> d{-1.0, 3.0, -3.0, 1.0};
    for (Index i = 0; i + 3 < size; ++i)
        for (Index a = 0; a < 4; ++a)
            for (Index b = a; b < 4; ++b)
                penalty.bands(b - a, i + a) += d[static_cast<std::size_t>(a)] * d[static_cast<std::size_t>(b)];
    return penalty;
}

}  // namespace

double QuinticSpline::last_s() const { return first_s + interval_s * static_cast<double>(controls.cols() - degree); }

VectorXd QuinticSpline::at(double time_s, int order) const {
    assert(order >= 0 && order <= 2);
    if (time_s < first_s) return order == 0 ? at(first_s) : VectorXd(VectorXd::Zero(controls.rows()));
    const double end_s = last_s();
    if (time_s > end_s)
        return order == 0   ? VectorXd(at(end_s) + (time_s - end_s) * at(end_s, 1))
               : order == 1 ? at(end_s, 1)
                            : VectorXd(VectorXd::Zero(controls.rows()));
    const Place place = place_of(*this, time_s);
    MatrixXd c = controls.middleCols(place.interval, degree + 1);
    // The derivative of a spline has the differences of its controls, one degree lower.
    for (int k = 0; k < order; ++k) c = ((c.rightCols(c.cols() - 1) - c.leftCols(c.cols() - 1)) / interval_s).eval();
    const auto b = basis(place.u, degree - order);
    VectorXd sum = VectorXd::Zero(controls.rows());
    for (Index i = 0; i < c.cols(); ++i) sum += b[static_cast<std::size_t>(i)] * c.col(i);
    return sum;
}

QuinticSpline smoothing_spline(const VectorXd& time_s, const MatrixXd& samples, double variance) {
    assert(time_s.size() == samples.cols() && samples.cols() > degree);
    const Index count = time_s.size();
    VectorXd steps = time_s.tail(count - 1) - time_s.head(count - 1);
    std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
    const double length = time_s(count - 1) - time_s(0);
    const Index intervals = std::max<Index>(1, std::lround(length / steps(steps.size() / 2)));
    QuinticSpline spline{time_s(0), length / static_cast<double>(intervals), {}};
    const Index size = intervals + degree;
    spline.controls.resize(samples.rows(), size);

    Banded squares(size);
    MatrixXd right = MatrixXd::Zero(samples.rows(), size);
    for (Index t = 0; t < count; ++t) {
        const Place place = place_of(spline, time_s(t));
        const auto b = basis(place.u, degree);
        for (Index i = 0; i <= degree; ++i) {
            right.col(place.interval + i) += b[static_cast<std::size_t>(i)] * samples.col(t);
            for (Index j = i; j <= degree; ++j)
                squares.bands(j - i, place.interval + i) += b[static_cast<std::size_t>(i)] *
                                                            b[static_cast<std::size_t>(j)];
        }
    }
    const Banded penalty = difference_penalty(size);
    const auto factor = [&](double weight, double& log_determinant) {
        Banded sum = squares;
        sum.bands += weight * penalty.bands;
        log_determinant = factorise(sum);
        return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    const double past = smoothing_policy.most_weight;
    for (double weight = smoothing_policy.least_weight; weight < past; weight *= smoothing_policy.factor) {
        double here = 0.0, below = 0.0, above = 0.0;
        const MatrixXd controls = solve(factor(weight, here), right);
        factor(weight * std::exp(-smoothing_policy.difference), below);
        factor(weight * std::exp(smoothing_policy.difference), above);
        // Trace of the map from samples to the spline: size minus d ln det / d ln weight.
        const double trace = static_cast<double>(size) - 0.5 * (above - below) / smoothing_policy.difference;
        QuinticSpline tried{spline.first_s, spline.interval_s, controls};
        double error = 0.0;
        for (Index t = 0; t < count; ++t) error += (tried.at(time_s(t)) - samples.col(t)).squaredNorm();
        const double risk = error + 2.0 * variance * trace;
        if (risk < least) {
            least = risk;
            spline.controls = controls;
        }
    }
    return spline;
}

}  // namespace myo::measurement
