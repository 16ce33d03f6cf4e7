#pragma once

#include <cstdint>
#include <random>

namespace myo::statistics {

/// Signs for draws of the null distribution "independent and symmetric, of any size each". The same on every machine,
/// which the distributions of the standard library are not.
class RandomSigns {
public:
    explicit RandomSigns(unsigned seed) : random_(seed) {}

    template <class Values>
    void flip(Values&& values) {
        for (double& value : values)
            if (next()) value = -value;
    }

private:
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
