#pragma once

#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// Reads and prepares the experiment of a folder. Fails the test if that is not possible.
inline setup::Setup setup_of_folder(const Folder& folder, const setup::SetupSettings& settings) {
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings);
    EXPECT_TRUE(setup) << setup.error().text();
    // Moved out of the Result: a setup holds meshes and measurements.
    return std::move(*setup);
}

}  // namespace myo::test
