#include "backend/scene_report.hpp"

#include "backend/core_scene.hpp"
#include "base/overwrites.hpp"
#include "measurement/trace_csv.hpp"
#include "report/html_report.hpp"
#include "results/output_files.hpp"

namespace myo::backend {

namespace fs = std::filesystem;

Result<std::vector<std::string>> write_scene_report(const fs::path& folder, const ui::commands::Scene& scene,
                                                    const ui::commands::RunResult& run,
                                                    const ui::commands::SearchResult* found,
                                                    const ui::commands::DiagnosisView* diagnosis) {
    const experiment::Experiment& experiment = source_of(scene).experiment;
    std::vector<fs::path> outputs = results::trace_files(folder, experiment);
    for (const char* const name : {"fit.html", "diagnosis.html"}) outputs.push_back(folder / name);
    // A report must not overwrite files that the experiment is read from.
    const Result<void> kept = check_overwrites(folder.string(), outputs,
                                               results::files_read(experiment.folder, experiment));
    if (!kept) return kept.error();
    if (const Result<void> ready = results::prepare_output_folder(folder); !ready) return ready.error();
    std::vector<std::string> files, names, trials;
    for (const ui::commands::SceneMarker& marker : scene.markers) names.push_back(marker.name);
    for (const ui::commands::SceneTrial& trial : scene.trials) trials.push_back(trial.name);
    // Names as files: without unsafe characters, and distinct.
    trials = results::trial_file_names(trials);
    for (std::size_t t = 0; t < run.trials.size() && t < scene.trials.size(); ++t) {
        // Trials that did not run have no markers.
        if (names.empty() || run.trials[t].markers.size() != names.size()) continue;
        files.push_back(trials[t] + ".csv");
        measurement::Recording simulated;
        simulated.labels = names;
        simulated.time_s = scene.trials[t].time_s;
        simulated.tracks = run.trials[t].markers;
        if (const Result<void> written = measurement::write_trace_csv(folder / files.back(), simulated); !written)
            return written.error();
    }
    // Pages are opaque to the window; this backend makes them as HtmlReport.
    const auto page = [&](const char* name, const std::shared_ptr<const void>& content) -> Result<void> {
        if (!content) return {};
        files.emplace_back(name);
        return report::write_html(folder / name, *std::static_pointer_cast<const report::HtmlReport>(content));
    };
    if (found)
        if (const Result<void> written = page("fit.html", found->page); !written) return written.error();
    if (diagnosis)
        if (const Result<void> written = page("diagnosis.html", diagnosis->page); !written) return written.error();
    return files;
}

}  // namespace myo::backend
