#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "commands/backend.hpp"
#include "commands/command.hpp"
#include "commands/placed_paint.hpp"
#include "commands/undo.hpp"
#include "commands/workbench_state.hpp"

namespace myo {

/// The workbench without its looks: carries out commands, runs jobs, holds the state.
class Workbench {
public:
    /// @param wake  called from another thread when there is something new to show; may be empty
    explicit Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake = {});

    const WorkbenchState& state() const { return state_; }
    void execute(const Command& command);

    /// To be called at the start of each frame: takes results of jobs and moves the time of a playing trial.
    /// @param seconds  since the last call
    void advance(double seconds);

    /// Something changes by itself, so frames must go on.
    bool animating() const { return state_.playing; }

private:
    void open(const std::filesystem::path& path, std::optional<double> metres_per_unit);
    void show_scene(Scene scene);
    void build_mesh(std::function<void()> then);
    void run();
    void calibrate();
    void diagnose();
    void show_diagnosis(DiagnosisView diagnosis);
    /// Moves the time to where the chosen row's force can be seen, unless the motion plays.
    void look_at_forces();
    void take_live_diagnosis();
    void add_effect(const std::string& key);
    void paint(const command::Paint& asked);
    void import_signal(const command::ImportSignal& asked);
    void export_signal(const command::ExportSignal& asked);
    /// Puts the settings' muscles on the body.
    void place_muscles();
    void change_settings(const command::ChangeSettings& change);
    void set_settings(const Settings& settings);
    void check_stability();
    void choose_trial(int trial);
    void show_run(std::shared_ptr<const RunResult> run, const Settings& settings);
    void show_calibration(CalibrationResult result);
    void start(const std::string& name, Job::Work work, bool staged = false);
    /// Says why a job cannot be started now, in the log; false then.
    bool may_start();
    bool may_compute();
    void log(LogLevel level, const std::string& text);
    void log_failure(const Error& error, const std::string& what);

    std::shared_ptr<Backend> backend_;
    std::function<void()> wake_;
    WorkbenchState state_;
    UndoStack<Settings> undo_;
    PlacedPaint placed_;
    // What a running diagnosis knows so far, on its way from its thread to the frame.
    struct LiveDiagnosis {
        std::mutex mutex;
        std::shared_ptr<const DiagnosisView> latest;
    };
    std::shared_ptr<LiveDiagnosis> live_;
    std::unique_ptr<Job> job_;     // last member: its thread ends before anything it uses
};

}  // namespace myo
