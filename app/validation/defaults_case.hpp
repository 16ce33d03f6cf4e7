#pragma once

#include <cstdint>
#include <string>

#include "validation/slip.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// How the experiments are drawn that show what the defaults are worth.
struct DefaultsPolicy {
    double least_length_m = 2e-3, most_length_m = 0.5;
    double least_modulus_Pa = 5e3, most_modulus_Pa = 50e6;
    double least_rate_Hz = 5.0, most_rate_Hz = 1000.0;
    double most_sag = 0.15;                          // of the length, by the own weight
    double most_column_load = 0.3;                   // weight of a standing column over the one that buckles it
    double least_swing = 0.03, most_swing = 0.12;    // of the length: deflection by the force that is let go
    double least_periods = 4.0, most_periods = 8.0;  // of the first vibration, where the camera allows
    double longest_periods = 30.0;                   // for a slow camera's samples
    int least_samples = 10, most_samples = 250;
    double least_noise = 0.003, most_noise = 0.02;  // of the swing
    double least_damping_ratio = 0.01, most_damping_ratio = 0.1;
    double muscles = 0.15;     // share of experiments with two antagonists
    double slips = 1.0 / 3.0;  // share with a slip
};
inline constexpr DefaultsPolicy defaults_policy;

/// An experiment of a laboratory as it is, and as it is declared.
struct DefaultsCase {
    std::string shape;              // "bar", "strip", "plate", "column", "finger"
    SyntheticCase truth, declared;  // files are written as of `declared`, motions are those of `truth`
    const Slip* slip = nullptr;     // none where what is declared is true
    double frequency_Hz = 0.0;      // of the first vibration, by beam theory
};

/// Case `number` of a study with this seed: the same for any count, order and number of processes.
DefaultsCase drawn_defaults_case(std::uint64_t seed, int number);

}  // namespace myo::validation
