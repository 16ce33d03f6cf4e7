#pragma once

#include <vector>

#include "commands/marker_errors.hpp"
#include "panels/panel.hpp"
#include "panels/tables.hpp"

namespace myo::ui::panels {

/// Task Measure: shows the error of each trial, and of each marker of the shown trial.
///
/// Emits ChooseTrial and ChooseMarker; requests dialogs to import a recording and to save the table. Replaced by
/// ImportPanel during an import. Item names begin with "measure/".
class MeasurePanel : public Panel {
public:
    std::string name() const override { return "measure"; }
    std::string title() const override { return "Measurement"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::measure; }
    bool offered(const commands::WorkbenchState& state) const override { return !state.import; }
    void draw(PanelContext& context) override;

private:
    /// Chooses which errors the table shows.
    void draw_tabs(PanelContext& context);
    /// One row per marker; a click shows the marker in the plots.
    void draw_table(PanelContext& context, const std::vector<commands::MarkerError>& errors);
    /// The first table has one number per error, the others one per axis.
    std::vector<Heading> headings() const;
    /// Errors of marker m.
    void draw_error_row(PanelContext& context, const commands::MarkerError& error, std::size_t m);
    enum class Shown { whole, rms, largest, bias };  // table of the markers: in all, or one quantity per axis
    Shown shown_ = Shown::whole;
};

/// Draws a table of trials with role and rms error in a run. A click selects the trial.
///
/// @param item  prefix of the item names for tests
/// @param run  may be null: errors are dashes
void draw_trial_errors(PanelContext& context, const std::string& item, const commands::RunResult* run);

}  // namespace myo::ui::panels
