#pragma once

#include <gtest/gtest.h>

#include "project/read_experiment.hpp"
#include "project/study.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// The experiment of a folder, prepared with these settings.
inline Study study_of_folder(const Folder& folder, const StudySettings& settings) {
    const Result<Experiment> experiment = read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    Result<Study> study = prepare_study(*experiment, settings);
    EXPECT_TRUE(study) << study.error().text();
    return std::move(*study);
}

}  // namespace myo::test
