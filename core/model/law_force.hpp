#pragma once

#include <memory>
#include <vector>

#include "model/force_element.hpp"
#include "model/law_points.hpp"
#include "model/law_programs.hpp"

namespace myo::model {

/// What a trial adds to a law.
struct LawConditions {
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();
    double session_time_s = 0.0;
    std::vector<double> conditions;  // one per condition of the law
};

/// Force of a law at points: its traction, its force density or its force times the weight of each point. The law is
/// evaluated with the places and velocities of the points and the normals of their faces.
///
/// The force of a law with a potential, which it states or which the symmetry of its derivatives shows, is treated as
/// conservative. Its integral is taken by a Gauss rule, exact for powers of a place or speed.
/// @param numbers  values of the parameters, one per number of the law
/// @param scales   typical changes of them
/// Parameters: those of the law.
ForceElementPointer law_force(std::shared_ptr<const LawPrograms> law,
                              std::shared_ptr<const std::vector<LawCarrier>> carriers, LawConditions conditions,
                              const Eigen::VectorXd& numbers, const Eigen::VectorXd& scales);

/// Whether an element is the force of this law with these numbers. An element that a moving mount carries is looked
/// through by neither name nor type: it is none.
bool is_law_force(const ForceElement& element, const LawPrograms& law, const Eigen::VectorXd& numbers);

}  // namespace myo::model
