#pragma once

#include <cstdint>
#include <random>

namespace myo::statistics {

/// Random sign flips, for the null hypothesis of independent symmetric entries of arbitrary size. Portable: the
/// distributions of the standard library differ between implementations.
class RandomSigns {
public:
    explicit RandomSigns(unsigned seed) : random_(seed) {}

    /// Flips the sign of each value with probability 1/2.
    template <class Values>
    void flip(Values&& values) {
        for (double& value : values)
            if (next()) value = -value;
    }

private:
    /// One random bit; 64 are drawn at a time.
    bool next() {
        if (left_ == 0) {
            bits_ = random_();
            left_ = 64;
        }
        --left_;
        const bool bit = (bits_ & 1U) != 0;
        bits_ >>= 1U;
        return bit;
    }

    std::mt19937_64 random_;
    std::uint64_t bits_ = 0;
    int left_ = 0;
};

}  // namespace myo::statistics
