#include "panels/tutorial.hpp"

#include <algorithm>

namespace myo::ui::panels {
namespace {

using commands::Task;
using commands::WorkbenchState;

// Conditions of the steps. Each reads the state only, so that a step done by any means is ticked.
bool has_open_body(const WorkbenchState& state) { return state.scene != nullptr; }

bool has_mesh(const WorkbenchState& state) { return state.mesh_is_current(); }

bool has_painted_muscle(const WorkbenchState& state) {
    return std::any_of(state.paint.begin(), state.paint.end(), [](const auto& paint) {
        return paint && paint->weights.size() > 0 && paint->weights.maxCoeff() > 0.0;
    });
}

bool has_run(const WorkbenchState& state) { return state.run_is_current(); }

bool has_recording(const WorkbenchState& state) {
    return state.scene && std::any_of(state.scene->trials.begin(), state.scene->trials.end(), [](const auto& trial) {
               return trial.role != "simulate" && !trial.measured.empty();
           });
}

bool has_fit(const WorkbenchState& state) { return state.found && !state.found->stopped; }

bool has_verdict(const WorkbenchState& state) { return state.diagnosis && state.diagnosis->complete; }

}  // namespace

const std::array<TutorialStep, tutorial_length>& tutorial_steps() {
    // The texts name tasks and buttons by their labels in the window.
    static const std::array<TutorialStep, tutorial_length> steps{
        {{"open", "Open a body",
          "File, Examples, Fish tail; or your own surface by Open a file. A drag in the view turns it, the wheel "
          "zooms, "
          "F shows the whole motion.",
          Task::body, has_open_body},
         {"mesh", "Mesh it",
          "Choose Elements, type an Edge length and press Build this mesh. The report below it says how well the mesh "
          "has the volume of the body.",
          Task::mesh, has_mesh},
         {"paint", "Paint a muscle",
          "Press Add a muscle, then Paint, and drag over the body: the fibres follow the stroke. Escape puts the brush "
          "away. Ctrl+Z takes a stroke back.",
          Task::fibres, has_painted_muscle},
         {"run", "Run",
          "Press Run at the foot of the panel. Space plays the motion; the time line below the view moves "
          "it. The tab Signals draws what the muscle does.",
          Task::run, has_run},
         {"recording", "Import a recording",
          "Import a recording reads markers from C3D, TSV, TRC or CSV. Say which label is which marker, then Add. The "
          "examples already have one.",
          Task::measure, has_recording},
         {"calibrate", "Calibrate or optimise",
          "Calibrate finds the unknown values of the model, Optimise the signals of the muscles. The best motion so "
          "far plays in the view; the tab Search shows the error.",
          Task::fit, has_fit},
         {"diagnose", "Diagnose",
          "Diagnose tries every known effect on what the model does not explain, and says which one is missing. Add "
          "puts it into the model. The example Unexplained beam lacks one.",
          Task::diagnose, has_verdict}}};
    return steps;
}

void TutorialProgress::follow(const WorkbenchState& state) {
    for (std::size_t s = 0; s < tutorial_length; ++s) done_[s] = done_[s] || tutorial_steps()[s].done(state);
}

std::size_t TutorialProgress::next() const {
    return static_cast<std::size_t>(std::find(done_.begin(), done_.end(), false) - done_.begin());
}

}  // namespace myo::ui::panels
