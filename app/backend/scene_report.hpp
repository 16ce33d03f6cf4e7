#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// Writes simulated markers as tables, and the pages of a search and a diagnosis if they are given (may be null).
///
/// Trials are written to "<trial>.csv" with all markers of the scene at the sample times; trials that did not run have
/// no file. Pages are fit.html and diagnosis.html.
///
/// @param folder  made if missing
/// @return        names of the files, relative to the folder
/// Errors: a file that the experiment is read from would be replaced; the folder cannot be written.
Result<std::vector<std::string>> write_scene_report(const std::filesystem::path& folder,
                                                    const ui::commands::Scene& scene,
                                                    const ui::commands::RunResult& run,
                                                    const ui::commands::SearchResult* found,
                                                    const ui::commands::DiagnosisView* diagnosis);

}  // namespace myo::backend
