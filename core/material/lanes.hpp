#pragma once

#include <Eigen/Core>

#include "material/material.hpp"

namespace myo::material {

/// Extracts one lane of a small matrix of packs, for laws that have no vectorised form for all F.
template <int R, int C>
Eigen::Matrix<double, R, C> lane_of(const Eigen::Matrix<Pack, R, C>& packs, int lane) {
    Eigen::Matrix<double, R, C> result;
    for (int k = 0; k < R * C; ++k) result(k % R, k / R) = packs(k % R, k / R)[static_cast<std::size_t>(lane)];
    return result;
}

/// Writes one lane of a small matrix of packs.
template <int R, int C>
void set_lane(Eigen::Matrix<Pack, R, C>& packs, int lane, const Eigen::Matrix<double, R, C>& values) {
    for (int k = 0; k < R * C; ++k) packs(k % R, k / R)[static_cast<std::size_t>(lane)] = values(k % R, k / R);
}

/// Writes one lane of a function with its derivatives; the Hessian only if it was computed.
inline void set_lane(TensorFunctionOf<Pack>& packs, int lane, const TensorFunction& values, bool with_hessian) {
    packs.value[static_cast<std::size_t>(lane)] = values.value;
    set_lane(packs.gradient, lane, values.gradient);
    if (with_hessian) set_lane(packs.hessian, lane, values.hessian);
}

}  // namespace myo::material
