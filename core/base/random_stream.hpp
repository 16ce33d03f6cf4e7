#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <random>

namespace myo {

/// Random numbers that depend on their key only: identical for all compilers and any order of the streams.
class RandomStream {
public:
    explicit RandomStream(std::initializer_list<std::uint64_t> key) {
        // splitmix64 over the key: adjacent keys give unrelated streams (Steele, Lea, Flood 2014).
        std::uint64_t state = 0;
        for (const std::uint64_t part : key) state = mixed(state + 0x9e3779b97f4a7c15ULL + part);
        engine_.seed(state);
    }

    /// Uniform in [lowest, highest).
    double uniform(double lowest, double highest) { return lowest + (highest - lowest) * unit(); }
    /// Uniform in the logarithm; both bounds positive.
    double log_uniform(double lowest, double highest) { return lowest * std::pow(highest / lowest, unit()); }
    /// Uniform integer 0 ... count - 1.
    int below(int count) { return static_cast<int>(unit() * count); }
    bool chance(double probability) { return unit() < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }
    /// Normal with mean 0 and standard deviation 1 (Box & Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log1p(-unit()));
        return radius * std::cos(2.0 * std::numbers::pi * unit());
    }

private:
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    std::mt19937_64 engine_;
};

}  // namespace myo
