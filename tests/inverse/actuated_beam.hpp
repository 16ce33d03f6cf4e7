#pragma once

#include <cmath>
#include <limits>
#include <memory>

#include "inverse/actuation_fit.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// A beam with two antagonists tied by -0.5, markers on it (one on a stalk), and as the target what its markers do for
/// given values.
inline inverse::ActuationProblem actuated_beam(bool hold, bool from_before, bool from_start) {
    BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    spec.poissons_ratio = 0.45;
    spec.damping_s = 0.005;
    inverse::ActuationProblem problem;
    model::Model& model = problem.model;
    model = make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const double low : {0.0, 0.02}) {
        const Box layer{{0.0, 0.0, low}, {0.1, 0.03, low + 0.01}};
        fibres->push_back(fibre::fibres_in_box(model.body->mesh, layer, Eigen::Vector3d::UnitX(), 8e4,
                                               low > 0.0 ? "upper" : "lower"));
    }
    model.fibres = fibres;
    problem.options.start = from_before ? dynamics::StartKind::equilibrium : dynamics::StartKind::straight;
    problem.options.h_s = 0.01;
    problem.options.end_s = 0.3;
    problem.options.solver.tolerance = 1e-9;
    problem.sought.signals = {{"lower", 0.5, 1.5, from_before ? 0.98 : 1.0}};
    problem.sought.groups = {{0, 1.0}, {0, -0.5}};
    problem.sought.end_s = 0.3;
    problem.sought.hold = hold;
    problem.sought.from_before = from_before;
    problem.smoothness_m_s = 0.0;
    problem.target.markers = measurement::marker_set(model.body->mesh, {{0.1, 0.015, 0.03}, {0.06, -0.006, 0.012}});
    problem.target.times_s = Eigen::VectorXd::LinSpaced(31, 0.0, 0.3);
    problem.target.from_start = from_start;
    return problem;
}

/// 1 - 0.08 sin, smooth over the knots.
inline Eigen::MatrixXd wave(const inverse::SoughtSignals& sought) {
    Eigen::MatrixXd values = inverse::unmoved_values(sought);
    const std::vector<double> times = inverse::knot_times(sought);
    for (Eigen::Index k = 0; k < values.cols(); ++k)
        values(0, k) = 1.0 - 0.08 * std::sin(20.0 * times[static_cast<std::size_t>(k)] + 0.3);
    return values;
}

/// The target is the motion under these values; a few samples are occluded.
inline void aim_at(inverse::ActuationProblem& problem, const Eigen::MatrixXd& values) {
    inverse::MarkerTarget& target = problem.target;
    target.positions_m.assign(target.markers.bindings.size(), Eigen::Matrix3Xd::Zero(3, target.times_s.size()));
    target.positions_m = inverse::target_residuals(target, inverse::evaluate_actuation(problem, values).motion);
    target.positions_m[0].middleCols(4, 3).setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace myo::test
