#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "loop/diagnosis.hpp"
#include "project/predict_trials.hpp"
#include "project/study_of_folder.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// A beam of 10 x 3 x 3 cm let go under gravity, once to fit and once to predict, its traces still to be made up.
inline std::string swung_beam_toml() {
    return R"(schema = "experiment/1"
name = "swung beam"
[geometry]
kind = "box"
size_m = [0.1, 0.03, 0.03]
[clamp]
box_m = [[-0.0005, -0.001, -0.001], [0.0005, 0.031, 0.031]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.6e5
poissons_ratio = 0.49
density_kg_m3 = 1070
damping_s = 0.004
calibrate = ["youngs_modulus"]
[markers]
noise_m = 1e-4
[markers.rest_m]
tip_left = [0.1, 0.0, 0.03]
tip_right = [0.1, 0.03, 0.03]
tip_low = [0.1, 0.015, 0.0]
middle = [0.05, 0.015, 0.03]
[[trial]]
name = "swing"
role = "fit"
trace = "swing.csv"
format = "csv"
start = "straight"
[[trial]]
name = "swing again"
role = "validate"
trace = "swing.csv"
format = "csv"
start = "straight"
)";
}

/// The experiment of a folder on coarse cells.
inline Study study_in(const Folder& folder) {
    StudySettings settings;
    settings.mesh.resolution_m = 0.015;
    return study_of_folder(folder, settings);
}

inline Study swung_beam(const Folder& folder, double end_s = 0.6) {
    std::string text = "time_s";
    const char* const names[] = {"tip_left", "tip_right", "tip_low", "middle"};
    for (const char* name : names)
        for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
    for (int k = 0; k <= static_cast<int>(std::lround(100.0 * end_s)); ++k) {
        char time[32];
        std::snprintf(time, sizeof time, "\n%.2f", 0.01 * k);
        text += time;
        text += ",0.1,0,0.03,0.1,0.03,0.03,0.1,0.015,0,0.05,0.015,0.03";
    }
    folder.write("experiment.toml", swung_beam_toml());
    folder.write("swing.csv", text + "\n");
    return study_in(folder);
}

/// Puts a motion with white noise of the stated size in a trial's recording.
inline void record(Study& study, std::size_t trial, const StudyValues& values, const Trace& trace, unsigned seed = 1) {
    ASSERT_TRUE(trace.complete()) << trace.message;
    const TrialPrediction seen = observe_trial(study, trial, values, trace);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise;
    for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
        Eigen::Matrix3Xd& track = study.trials[trial].measured.tracks[m];
        track = seen.positions_m[m];
        for (double& x : track.reshaped()) x += study.noise_m(static_cast<Eigen::Index>(m)) * noise(random);
    }
}

/// A fit of the declared values as they stand, with Young's modulus as its only parameter.
inline JointFit unmoved_fit(const Study& study, const FitData& data, const StudyValues& values) {
    JointFit fit;
    fit.values = values;
    fit.parameters = joint_parameters(study, values);
    fit.predictions = predict_trials_with(study, values, data.trials, {}, fit.parameters);
    fit.residual = flat_residual(data, fit.predictions);
    fit.jacobian = flat_jacobian(data, fit.predictions, fit.parameters.size());
    fit.report.deviations = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(fit.parameters.size()), std::nan(""));
    fit.effects.assign(values.effects.begin() + static_cast<std::ptrdiff_t>(study.experiment.effects.size()), values.effects.end());
    return fit;
}

}  // namespace myo::test
