#include "diagnosis/screening/residual_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Lines of residuals whose spectra are made of Gaussian bells: the parabola through three logarithms of such a bell is
// exact, so that its centre is found to rounding.

namespace myo::diagnosis::residual_lines_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A bell in the amplitudes of a spectrum.
struct Bell {
    double cycles = 0.0;  // at the centre, in the whole trial
    double amplitude = 1.0;
};

/// A marker along x in each trial, 10 ms apart.
struct Case {
    statistics::ResidualLayout layout;
    VectorXd residual;

    void add(int samples, const std::vector<Bell>& bells) {
        const int trial = static_cast<int>(layout.series.size());
        const Index begin = layout.size();
        residual.conservativeResize(begin + samples);
        for (int t = 0; t < samples; ++t) {
            layout.sample.push_back(t);
            layout.time_s.push_back(0.01 * t);
            double sum = 0.0;
            for (const Bell& bell : bells)
                for (int k = 1; 2 * k < samples; ++k)
                    sum += bell.amplitude * std::exp(-0.5 * std::pow(k - bell.cycles, 2)) *
                           std::cos(2.0 * std::numbers::pi * k * t / samples);
            residual(begin + t) = sum;
        }
        layout.series.push_back({trial, 0, 0, begin, begin + samples});
    }
    std::vector<double> lines(std::size_t count) const { return residual_lines(residual, layout, count); }
    bool has(double frequency_Hz, std::size_t count) const {
        const std::vector<double> found = lines(count);
        return std::any_of(found.begin(), found.end(), [&](double f) { return std::abs(f - frequency_Hz) < 1e-6; });
    }
};

/// In a trial of 1 s the cycles are the frequency.
TEST(ResidualLines, AreFoundBetweenTheFrequenciesOfTheSpectrum) {
    for (const double frequency_Hz : {12.0, 12.3, 12.7}) {
        Case of;
        of.add(100, {{frequency_Hz}});
        const std::vector<double> found = of.lines(1);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0], frequency_Hz, 1e-9);
    }
}

TEST(ResidualLines, StrongestComesFirst) {
    Case of;
    of.add(100, {{12.3, 1.0}, {30.6, 2.0}, {22.4, 0.5}});
    const std::vector<double> found = of.lines(3);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0], 30.6, 1e-9);
    EXPECT_NEAR(found[1], 12.3, 1e-9);
    EXPECT_NEAR(found[2], 22.4, 1e-9);
}

/// White noise of variance 1 has the power 1 whatever the length; a line gains with the length of its trial.
TEST(ResidualLines, OfALongerTrialAreStronger) {
    Case of;
    of.add(50, {{5.3, 1.2}});
    of.add(100, {{30.3, 1.0}});
    const std::vector<double> found = of.lines(2);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], 30.3, 1e-9);
    EXPECT_NEAR(found[1], 5.3 / 0.5, 1e-9);
}

/// Fewer than one and a half cycles are a trend, however large.
TEST(ResidualLines, BeginAtOneAndAHalfCycles) {
    for (const double cycles : {1.4, 1.6}) {
        Case of;
        of.add(100, {{cycles, 1.0}, {25.2, 1e-3}});
        EXPECT_NEAR(of.lines(1).at(0), cycles < 1.5 ? 25.2 : cycles, 1e-6);
        EXPECT_EQ(of.has(cycles, 5), cycles > 1.5);
        EXPECT_TRUE(of.has(25.2, 5));
    }
}

/// Lines of two trials are one if the shorter of the trials does not resolve them: here 2 Hz against 1 Hz.
TEST(ResidualLines, NearerThanTheCoarsestTrialResolvesCountOnce) {
    for (const bool coarse : {true, false})
        for (const double apart_Hz : {1.8, 2.2}) {
            Case of;
            const double weaker_Hz = 20.3 + apart_Hz;
            of.add(100, {{20.3, 2.0}});
            if (coarse)
                of.add(50, {{0.5 * weaker_Hz, 1.0}});
            else
                of.add(100, {{weaker_Hz, 1.0}});
            EXPECT_NEAR(of.lines(1).at(0), 20.3, 1e-9);
            EXPECT_EQ(of.has(weaker_Hz, 2), !coarse || apart_Hz > 2.0) << coarse << " " << apart_Hz;
        }
}

TEST(ResidualLines, AreNoneWhereNothingOscillates) {
    EXPECT_TRUE(residual_lines({}, {}, 3).empty());
    Case still, brief, of;
    still.add(100, {});
    EXPECT_TRUE(still.lines(3).empty());
    brief.add(4, {{1.0}});
    EXPECT_TRUE(brief.lines(3).empty()) << "two frequencies have no maximum between them";
    of.add(100, {{12.3}});
    EXPECT_TRUE(of.lines(0).empty());
}

}  // namespace
}  // namespace myo::diagnosis::residual_lines_test
