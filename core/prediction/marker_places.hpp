#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "inverse/marginal_nuisance.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

// Places of the markers on the body as unknowns of a fit (markers.placement_m). They are three per marker, the same in
// all trials and holds, with a normal prior of zero mean. To first order residuals are linear in them, so a fit of the
// other parameters marginalises them; each evaluation is linearised at the most probable places.

/// Derivatives of a trial's residuals by the places of the markers, see TrialPrediction::place_tangents. Empty if the
/// places are exact.
///
/// @param markers  where they are observed, without places
/// @param times_s  of the samples, in the clock of the simulation
std::vector<std::vector<Eigen::Matrix3Xd>> place_tangents(const setup::Setup& setup, std::size_t trial,
                                                          const ParameterValues& values,
                                                          const measurement::ObservationError& error,
                                                          const measurement::MarkerSet& markers,
                                                          const dynamics::Trace& trace, const Eigen::VectorXd& times_s);

/// Place of one marker as a fit found it.
struct FoundPlace {
    std::string marker;
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();      // from the declared place, at rest, mesh frame
    Eigen::Vector3d deviation_m = Eigen::Vector3d::Zero();  // 1 sigma, with the uncertainty of the fitted parameters
};

/// Most probable places for the weighted residuals of a fit, see weighted_residuals(); empty if the places are exact.
std::vector<Eigen::Vector3d> probable_places(const setup::Setup& setup, const inverse::MarginalNuisance& places,
                                             const Eigen::VectorXd& residuals);

/// Places and their deviations after a fit; empty if the places are exact.
///
/// @param residuals  whitened, N
/// @param fit        of the other parameters, with a whitened Jacobian of N rows
std::vector<FoundPlace> found_places(const setup::Setup& setup, const inverse::MarginalNuisance& places,
                                     const Eigen::VectorXd& residuals, const inverse::LeastSquaresReport& fit);

/// When a found place contradicts what is declared.
struct FarPlacePolicy {
    double max_deviations = 3.0;  // of a coordinate over markers.placement_m; three in a thousand are farther off
};
inline constexpr FarPlacePolicy far_place_policy;

/// Markers with a coordinate farther from its declared value than FarPlacePolicy allows, ascending.
std::vector<std::size_t> far_markers(const setup::Setup& setup, const std::vector<Eigen::Vector3d>& places_m);

/// "marker tip sits 7.2 mm from its declared place, more than ..."
std::string far_marker_sentence(const setup::Setup& setup, std::size_t marker, const Eigen::Vector3d& shift_m);

}  // namespace myo::prediction
