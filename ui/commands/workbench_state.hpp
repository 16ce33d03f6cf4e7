#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/backend.hpp"
#include "commands/brush_settings.hpp"
#include "commands/job.hpp"
#include "commands/settings.hpp"
#include "platform/theme.hpp"

namespace myo {

enum class LogLevel { information, done, warning, failure };

struct LogLine {
    LogLevel level = LogLevel::information;
    std::string text;
};

/// What the 3D view shows.
struct ViewOptions {
    bool edges = true;
    bool grid = true;
    bool measured = true;
    bool simulated = true;
    bool trails = true;
    bool errors = true;             // lines from simulated to measured
    bool labels = true;
    bool clamp = true;
    bool displacement = false;      // colour the body by displacement
    bool fibres = true;             // muscles: colours and lines
    bool effect_force = true;       // arrows of the chosen effect's force, once there is a diagnosis
    double opacity = 1.0;

    bool operator==(const ViewOptions&) const = default;
};

inline constexpr const char* diagnose_job = "Diagnose";

/// Everything the panels show. Panels read it and emit commands; only Workbench changes it.
struct WorkbenchState {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const MeshedBody> body;
    std::shared_ptr<const PaintGround> ground;              // of `body`
    std::vector<std::shared_ptr<const CellPaint>> paint;    // of the settings' muscles on `body`; null without one
    std::shared_ptr<const RunResult> run;
    std::shared_ptr<const CalibrationResult> calibration;   // the last one, while its run is shown
    std::shared_ptr<const DiagnosisView> diagnosis;         // the last one, or what is known of the running one
    std::string candidate;          // key of its chosen row; empty = that of the verdict
    Settings settings;
    Settings diagnosis_settings;    // with which `diagnosis` was started
    Settings body_settings;         // with which `body` was meshed
    Settings run_settings;          // with which `run` was made
    MeshPrediction prediction;
    std::vector<Choice> materials;
    std::vector<Choice> integrators;

    int trial = 0;
    int marker = 0;
    int muscle = 0;                 // of the settings' muscles, the one that is edited
    BrushSettings brush;
    double time_s = 0.0;
    bool playing = false;
    double speed = 1.0;             // of playing, against real time
    double damping_frequency_Hz = 5.0;  // at which the numerical damping is shown
    std::optional<double> critical_velocity_force_1_s;   // at that frequency; only while there is a positive velocity force

    ViewOptions view;
    ThemeName theme = ThemeName::dark;
    float scale = 1.0f;

    std::vector<LogLine> log;
    std::optional<JobView> job;
    std::optional<std::filesystem::path> unit_question;   // a mesh file waits for its unit
    bool can_undo = false;
    bool can_redo = false;

    bool busy() const { return job.has_value(); }
    bool mesh_is_current() const { return body && same_mesh(settings, body_settings); }
    bool run_is_current() const { return run && settings == run_settings; }
    bool is_unstable() const { return critical_velocity_force_1_s && settings.velocity_force_1_s > *critical_velocity_force_1_s; }
    bool diagnosing() const { return job && job->name == diagnose_job; }
    /// Row of the diagnosis that is shown: the chosen one, or the verdict's, or the best so far; null without any.
    const DiagnosisRow* diagnosis_row() const;
    /// The chosen integrator, or null.
    const Choice* integrator() const {
        const auto found = std::find_if(integrators.begin(), integrators.end(), [&](const Choice& c) { return c.id == settings.integrator; });
        return found != integrators.end() ? &*found : nullptr;
    }
    const SceneTrial* scene_trial() const {
        return scene && trial >= 0 && trial < static_cast<int>(scene->trials.size()) ? &scene->trials[static_cast<std::size_t>(trial)]
                                                                                    : nullptr;
    }
    /// The muscle that is edited, or null.
    const Muscle* chosen_muscle() const {
        return muscle >= 0 && muscle < static_cast<int>(settings.muscles.size()) ? &settings.muscles[static_cast<std::size_t>(muscle)] : nullptr;
    }
    /// Its paint; null without body or muscle.
    const CellPaint* chosen_paint() const {
        return chosen_muscle() && static_cast<std::size_t>(muscle) < paint.size() ? paint[static_cast<std::size_t>(muscle)].get() : nullptr;
    }
    const SimulatedTrial* simulated_trial() const {
        return run && trial >= 0 && trial < static_cast<int>(run->trials.size()) ? &run->trials[static_cast<std::size_t>(trial)] : nullptr;
    }
};

/// First and last time that can be shown, of measurement and simulation together; {0, 0} when there is neither.
std::array<double, 2> time_span(const WorkbenchState& state);

}  // namespace myo
