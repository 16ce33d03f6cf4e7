#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/json.hpp"
#include "reproduce/arm_maps.hpp"
#include "reproduce/reproduction.hpp"

// Predictions of the static map of the pneumatic arm, and the tables and figures about them.

namespace myo::reproduce {

/// The variant whose predictions are shown in full: two signals, our model.
// Index in the list of reproduce_arm_static.cpp.
inline constexpr std::size_t chosen_variant = 4;

/// Prediction of one pressure that the map does not contain.
struct Score {
    // Name of the recording.
    std::string what;
    double pressure_mbar = 0.0;
    // The pressure lies outside of those of the map.
    bool extrapolated = false;
    ArmPrediction prediction;
    // Displacement of the tip centre from rest, frame of the robot.
    Eigen::Vector3d measured_m = Eigen::Vector3d::Zero();
    double error() const { return relative_error(prediction.tip_m, measured_m); }
};

/// A variant at one instant with its predictions.
struct Assessment {
    FittedArm arm;
    std::vector<Score> every_second;  // predicted from the first, third, ... pressure of the map
    // Each pressure, from all others.
    std::vector<Score> left_one_out;
    std::vector<Score> others;  // recordings outside the map; like the grid, of the chosen variant only
    // At grid_first_mbar and on, from all pressures.
    std::vector<ArmPrediction> grid;
};
inline constexpr double grid_first_mbar = 50.0, grid_step_mbar = 25.0;
inline constexpr int grid_count = 15;

/// Per variant, at both instants.
using Assessments = std::vector<std::array<Result<Assessment>, 2>>;

/// Mean relative error of the tip [-]; NaN of an empty list.
///
/// @param with_extrapolated  whether predictions outside the map count
double mean_error(const std::vector<Score>& scores, bool with_extrapolated = true);
/// Relative error in the bending plane of the recording itself: its direction depends on how the markers were placed.
double error_in_plane(const Score& score);
/// Mean of error_in_plane() over pressures inside the map.
double mean_error_in_plane(const std::vector<Score>& scores);

/// Mean errors per variant and kind of test, at both instants.
///
/// @param list  variants in the order of `all`, as in all functions below
report::Table errors_table(const std::vector<ArmVariant>& list, const Assessments& all);
/// Fitted signals and their remaining distance, pose by pose.
report::Table fits_table(const std::vector<ArmVariant>& list, const Assessments& all);
/// Predictions of the chosen variant for pressures of the map that were left out.
///
/// @param early, late  0.7 s after the onset, and the end of the record
report::Table predictions_table(const Assessment& early, const Assessment& late);
/// Predictions of the chosen variant for recordings outside the map.
///
/// @param others     recordings in the order of Assessment::others
/// @param as_long_s  end of the sweep's records after the onset, at which step trials are compared
report::Table others_table(const Assessment& early, const Assessment& late, const std::vector<RobotTrial>& others,
                           double as_long_s);
/// Predictions on a regular grid of pressures, signals [-] and tip [m].
report::Json grid_json(const Assessment& early, const Assessment& late);
/// Map from pressure to the signal of muscle 1 at the end of the records, variants up to the chosen one. SVG, as in all
/// functions of figures.
std::string map_figure(const std::vector<ArmVariant>& list, const Assessments& all);
/// Mean errors on every second pressure as bars [%].
std::string error_figure(const std::vector<ArmVariant>& list, const Assessments& all);
/// Tip coordinates over pressure, each predicted without its own recording.
std::string pose_figure(const Assessments& all);
/// The results in sentences.
std::vector<std::string> findings_of(const Assessments& all);

}  // namespace myo::reproduce
