#pragma once

#include <cstdint>
#include <string>

#include "validation/slip.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// Ranges from which experiments are drawn that test the defaults. Quantities with a unit are in SI; all others are
/// ratios.
struct DefaultsPolicy {
    double min_length_m = 2e-3, max_length_m = 0.5;
    double min_modulus_Pa = 5e3, max_modulus_Pa = 50e6;
    double min_rate_Hz = 5.0, max_rate_Hz = 1000.0;
    double max_sag = 0.15;                        // deflection under the own weight over length
    double max_column_load = 0.3;                 // weight of a standing column over its buckling load
    double min_swing = 0.03, max_swing = 0.12;    // deflection by the released force over length
    double min_periods = 4.0, max_periods = 8.0;  // of the first vibration, if the camera permits
    double longest_periods = 30.0;                // to give a slow camera enough samples
    int min_samples = 10, max_samples = 250;
    double min_noise = 0.003, max_noise = 0.02;  // over the deflection
    double min_damping_ratio = 0.01, max_damping_ratio = 0.1;
    double muscles = 0.15;     // share of experiments with two antagonists
    double slips = 1.0 / 3.0;  // share of experiments with a declaration error
};
inline constexpr DefaultsPolicy defaults_policy;

/// An experiment as it is and as the laboratory declares it. Without a declaration error the two are equal.
struct DefaultsCase {
    std::string shape;              // "bar", "strip", "plate", "column", "finger"
    SyntheticCase truth, declared;  // files follow `declared`, motions `truth`
    const Slip* slip = nullptr;     // null if the declaration is correct
    double frequency_Hz = 0.0;      // first vibration, by beam theory
};

/// Case `number` of a validation with this seed; independent of count, order and number of processes.
///
/// The declaration error depends on `number`; body, material, camera and trials on seed and number.
DefaultsCase drawn_defaults_case(std::uint64_t seed, int number);

}  // namespace myo::validation
