#include "reproduce/arm_maps.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Rotation about the axis of the arm, z.
Matrix3d about_axis(double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); }

/// Target of a pose fit in the model frame; NaN: not compared.
///
/// As published, x and z of the tip centre. Otherwise all coordinates, rotated so that the arm bends along x.
Matrix3Xd goal_of(const ArmVariant& variant, const Matrix3Xd& pose) {
    if (variant.body.published) {
        Matrix3Xd goal = Matrix3Xd::Constant(3, pose.cols(), std::nan(""));
        goal(0, 0) = pose(0, 0);
        goal(2, 0) = pose(2, 0);
        return goal;
    }
    Matrix3Xd goal = about_axis(-bending_direction({pose})) * pose;
    // Column 0 is the tip centre, the others are the markers; either is compared, as the centre is derived from them.
    if (variant.fit_markers)
        goal.col(0).setConstant(std::nan(""));
    else
        goal.rightCols(goal.cols() - 1).setConstant(std::nan(""));
    return goal;
}

/// Distance of the fitted model to the tip markers, rms over coordinates [m], in the frame of the recording.
double marker_rms(const ArmVariant& variant, const PoseFit& fit, const Matrix3Xd& pose) {
    const Matrix3d turned = variant.body.published ? Matrix3d::Identity() : about_axis(bending_direction({pose}));
    const Matrix3Xd error = turned * fit.pose.displacement_m.rightCols(pose.cols() - 1) -
                            pose.rightCols(pose.cols() - 1);
    return std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
}

}  // namespace

std::string to_string(Instant instant) { return instant == Instant::end ? "end" : "0.7 s"; }

Matrix3Xd pose_at(const RobotTrial& trial, Instant instant) {
    const double end = trial.time_s(trial.time_s.size() - 1);
    return instant == Instant::end ? mean_between(trial, end - 0.1, end) : mean_between(trial, 0.68, 0.72);
}

int FittedArm::simulations() const {
    int count = 0;
    for (const PoseFit& fit : fits) count += fit.simulations;
    return count;
}

Result<FittedArm> fit_arm(const std::shared_ptr<const TipResponse>& response, const ArmVariant& variant,
                          const std::vector<RobotTrial>& trials, Instant instant, const Progress& progress) {
    FittedArm arm{variant, response, {}, {}, {}, {}};
    if (!response->rest().ok) return Error{response->rest().message, variant.name + " at rest"};
    // Each fit starts from the previous pressure, so the arm follows one equilibrium branch.
    PoseFit last = unmoved(*response);
    for (const RobotTrial& trial : trials) {
        const Matrix3Xd pose = pose_at(trial, instant);
        if (!pose.allFinite())
            return Error{"the tip was not recorded at " + to_string(instant) + " after the onset", trial.name};
        const Result<PoseFit> fit = fit_pose(*response, goal_of(variant, pose), last, progress);
        if (!fit)
            return Error{fit.error().text(), variant.name + " at " + format_number(trial.pressure_mbar) + " mbar"};
        last = *fit;
        arm.measured_m.push_back(pose);
        arm.pressures_mbar.push_back(trial.pressure_mbar);
        arm.marker_rms_m.push_back(marker_rms(variant, *fit, pose));
        arm.fits.push_back(std::move(*fit));
    }
    return arm;
}

ArmPrediction predict_arm(const FittedArm& arm, const std::vector<std::size_t>& known, double pressure_mbar) {
    std::vector<double> pressures, lengths;
    std::vector<Matrix3Xd> poses;
    Eigen::MatrixXd signals(arm.fits.front().signals.size(), static_cast<Index>(known.size()));
    std::size_t nearest = known.front();
    for (const std::size_t i : known) {
        signals.col(static_cast<Index>(pressures.size())) = arm.fits[i].signals;
        pressures.push_back(arm.pressures_mbar[i]);
        poses.push_back(arm.measured_m[i]);
        lengths.push_back(arm.measured_m[i].col(0).norm());
        if (std::abs(arm.pressures_mbar[i] - pressure_mbar) < std::abs(arm.pressures_mbar[nearest] - pressure_mbar))
            nearest = i;
    }
    // The map is made from the known trials only; the equilibrium starts at the nearest of them, so that a prediction
    // lies on the branch that was fitted.
    const bool published = arm.variant.body.published;
    const MuscleConfiguration& configuration = arm.response->configuration();
    ArmPrediction result;
    // The published map has no condition at zero pressure; ours starts at rest.
    result.signals = (published ? polynomial_map(pressures, signals) : map_from_rest(pressures, signals, lengths))
                         .at(pressure_mbar);
    // Polynomials can leave the admissible range between or beyond the known pressures.
    result.signals = result.signals.cwiseMax(configuration.lower).cwiseMin(configuration.upper);
    const TipPose pose = arm.response->at(result.signals, arm.fits[nearest].pose.x);
    // The bending direction, too, comes from the known trials.
    if (pose.ok) result.tip_m = about_axis(published ? 0.0 : bending_direction(poses)) * pose.tracked_m();
    return result;
}

double relative_error(const Vector3d& predicted_m, const Vector3d& measured_m) {
    return (predicted_m - measured_m).norm() / measured_m.norm();
}

}  // namespace myo::reproduce
