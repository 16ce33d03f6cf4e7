#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"

namespace myo::diagnosis {

/// Settings of a diagnosis.
struct DiagnoseSettings {
    double alpha = 0.01;               // false-alarm rate of all significance tests together
    int refits = 10;                   // number of candidates that are fitted after the score tests
    int extensions = 5;                // number of further effects that are fitted together with a set
    bool refine_mesh = true;           // estimate and remove the mesh error
    std::vector<std::string> without;  // effects that may not be named
    /// The search ends so many seconds after the start, and the verdict is found from the fits until then; its own last
    /// fit is not limited. Empty: the search ends by itself.
    std::optional<double> search_limit_s;
    /// File of finished fits, read at the start and kept up to date; a stopped diagnosis resumes from it.
    std::optional<std::filesystem::path> fits;
    DiagnosisPolicy policy = {};
};

/// Whether a verdict may name this effect: not excluded by the settings.
bool may_be_named(const DiagnoseSettings& settings, const std::string& effect);

}  // namespace myo::diagnosis
