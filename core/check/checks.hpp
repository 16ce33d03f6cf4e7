#pragma once

#include <vector>

#include "check/checked_job.hpp"

namespace myo::check {

// One file each; registered in catalogue.cpp.
std::vector<Finding> check_mesh(const CheckedJob& job);
std::vector<Finding> check_markers(const CheckedJob& job);
std::vector<Finding> check_units(const CheckedJob& job);
std::vector<Finding> check_time_unit(const CheckedJob& job);
std::vector<Finding> check_support(const CheckedJob& job);
std::vector<Finding> check_pose(const CheckedJob& job);
std::vector<Finding> check_step(const CheckedJob& job);
std::vector<Finding> check_start(const CheckedJob& job);
std::vector<Finding> check_signals(const CheckedJob& job);
std::vector<Finding> check_recordings(const CheckedJob& job);
std::vector<Finding> check_inside_out(const CheckedJob& job);
std::vector<Finding> check_bounds(const CheckedJob& job);
std::vector<Finding> check_influence(const CheckedJob& job);
std::vector<Finding> check_residual(const CheckedJob& job);

}  // namespace myo::check
