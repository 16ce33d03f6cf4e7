#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "experiment/new_trial.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// A copy of a bundled example, in a folder of its name.
inline std::filesystem::path example_copy(const Folder& folder, const std::string& name) {
    const std::filesystem::path copy = folder.path() / name;
    EXPECT_TRUE(
        experiment::copy_experiment(std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets" / "examples" / name, copy));
    return copy;
}

}  // namespace myo::test
