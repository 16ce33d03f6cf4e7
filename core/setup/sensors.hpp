#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "dynamics/simulate.hpp"
#include "experiment/experiment.hpp"
#include "model/model.hpp"
#include "setup/chambers.hpp"

namespace myo::setup {

/// Readings of one column of a sensor in one trial.
struct SensorSeries {
    std::size_t sensor = 0;  // index in Experiment::sensors
    int axis = 0;            // of a reaction, 0 ... 2
    std::string column;      // "<name>_z_N"
    std::string unit;        // "N", "m3", "m"
    double noise = 0.0;      // 1 sigma, in the unit
    Eigen::VectorXd time_s;  // 0 at the start of the trial; a hold has one, 0
    Eigen::VectorXd values;  // in the unit
};

/// Readings of a trial. Times of a file are in the clock of the recording.
///
/// @param start_s  time of t = 0 in that clock
/// @return         one series per column that has readings; of a hold one sample each, the mean of a file's rows
/// Errors: those of measurement::read_actuation_csv(); a column of no sensor.
Result<std::vector<SensorSeries>> read_sensor_series(const experiment::Experiment& experiment,
                                                     const experiment::TrialDeclaration& trial, double start_s);

/// What a sensor of a model reads over a run, at the times of its samples (after `at_s`, in the time of the run); NaN
/// outside the run.
///
/// Volumes, tensions and shortenings are interpolated between the steps. The reaction is the force of the support on
/// the body: the rate of its momentum, by differences over the steps, less all other external forces.
/// Source: Newton's second law for the whole body.
/// @param at_s  times of the run, one per sample
Eigen::VectorXd sensor_readings(const experiment::Experiment& experiment, const std::vector<Chamber>& chambers,
                                const SensorSeries& series, const model::Model& model, const dynamics::Trace& trace,
                                const Eigen::VectorXd& at_s);

}  // namespace myo::setup
