#pragma once

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <random>

#include "statistics/residual_layout.hpp"

namespace myo::test {

/// Trials of three axes per marker on an even grid; each sample of each series is missing with the probability `gaps`.
struct Recorded {
    int trials = 2;
    int markers = 3;
    int samples = 150;
    double step_s = 0.01;
    double gaps = 0.0;
    unsigned seed = 11;
};

inline statistics::ResidualLayout make_layout(const Recorded& recorded = {}) {
    statistics::ResidualLayout layout;
    std::mt19937 random(recorded.seed);
    std::uniform_real_distribution<double> chance;
    for (int trial = 0; trial < recorded.trials; ++trial)
        for (int marker = 0; marker < recorded.markers; ++marker)
            for (int axis = 0; axis < 3; ++axis) {
                statistics::ResidualSeries series{trial, marker, axis, layout.size(), 0};
                for (int sample = 0; sample < recorded.samples; ++sample) {
                    if (chance(random) < recorded.gaps) continue;
                    layout.sample.push_back(sample);
                    layout.time_s.push_back(sample * recorded.step_s);
                }
                series.end = layout.size();
                layout.series.push_back(series);
            }
    return layout;
}

inline Eigen::VectorXd white(Eigen::Index size, std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
}

/// x(t) = a x(t - 1) + noise, of variance 1 from the start.
inline Eigen::VectorXd autoregressive(Eigen::Index size, double a, std::mt19937& random) {
    Eigen::VectorXd x = white(size, random);
    for (Eigen::Index t = 1; t < size; ++t) x(t) = a * x(t - 1) + std::sqrt(1.0 - a * a) * x(t);
    return x;
}

/// Every series an autoregressive one of its own; for layouts without gaps.
inline Eigen::VectorXd autoregressive(const statistics::ResidualLayout& layout, double a, std::mt19937& random) {
    Eigen::VectorXd x(layout.size());
    for (const statistics::ResidualSeries& series : layout.series)
        x.segment(series.begin, series.size()) = autoregressive(series.size(), a, random);
    return x;
}

/// f(series, time) at every entry.
inline Eigen::VectorXd signal(const statistics::ResidualLayout& layout,
                              const std::function<double(const statistics::ResidualSeries&, double)>& f) {
    Eigen::VectorXd values(layout.size());
    for (const statistics::ResidualSeries& series : layout.series)
        for (Eigen::Index k = series.begin; k < series.end; ++k)
            values(k) = f(series, layout.time_s[static_cast<std::size_t>(k)]);
    return values;
}

}  // namespace myo::test
