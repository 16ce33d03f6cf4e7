#pragma once

#include <string>

#include "support/folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::test {

/// TOML of the swung beam with one muscle "up" and the signal file s.csv in its fit trial.
inline std::string muscle_beam_toml() {
    std::string text = swung_beam_toml();
    text.insert(text.find("[markers]"),
                "[[muscle]]\nname = \"up\"\nbox_m = [[0.0, 0.0, 0.02], [0.1, 0.03, 0.03]]\nfibre = [1, 0, "
                "0]\nstiffness_Pa = 8e4\n");
    return text.insert(text.find("start = \"straight\""), "actuation = \"s.csv\"\n");
}

/// A trace of markers that stay at rest, sampled every 10 ms from `first_s` to `last_s`.
inline std::string still_trace(double first_s, double last_s) {
    std::string text = "time_s";
    for (const char* name : {"tip_left", "tip_right", "tip_low", "middle"})
        for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
    for (int k = 0; first_s + 0.01 * k <= last_s + 1e-9; ++k)
        text += "\n" + std::to_string(first_s + 0.01 * k) + ",0.1,0,0.03,0.1,0.03,0.03,0.1,0.015,0,0.05,0.015,0.03";
    return text + "\n";
}

/// Writes the experiment into a folder and prepares it on coarse elements.
///
/// @param signal  content of s.csv
/// @param first_s, last_s  range of the traces
inline Result<setup::Setup> muscle_beam_setup(const Folder& folder, const std::string& toml, const std::string& signal,
                                              double first_s = 0.0, double last_s = 1.0,
                                              setup::SetupSettings settings = {}) {
    folder.write("experiment.toml", toml);
    folder.write("swing.csv", still_trace(first_s, last_s));
    folder.write("s.csv", signal);
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    if (!experiment) return experiment.error();
    // Coarse elements: the tests need the mechanism, not the accuracy.
    settings.mesh.resolution_m = 0.015;
    return setup::prepare_setup(*experiment, settings);
}

}  // namespace myo::test
