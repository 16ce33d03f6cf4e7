#pragma once

#include <map>

#include "commands/muscle_signal.hpp"
#include "commands/signal_shapes.hpp"
#include "panels/knot_editor.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Edits signals as curves: a(t) of the selected muscle, or the commands of the chambers and tendons in the shown
/// trial. Their knots are dragged, added and removed in the plot, see KnotEditor. Signals of muscles can also be
/// generated and read from files.
///
/// Emits ChangeSettings, EditDeclaration, ChooseMuscle, ImportSignal, ExportSignal and SetTime. Comes to the front with
/// the task Fibres. Item names begin with "signals/".
class SignalPanel : public Panel {
public:
    std::string name() const override { return "signals"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Task> task() const override { return commands::Task::fibres; }
    void draw(PanelContext& context) override;

private:
    /// Whether the shown trial has commands of chambers or tendons.
    static bool has_commands(const commands::WorkbenchState& state);
    /// @param commands  those of chambers and tendons are shown
    /// List of what can be edited.
    ///
    void draw_list(PanelContext& context, bool commands);
    /// Button that shows all data.
    void draw_zoom(PanelContext& context);
    /// Generator, file and display controls of a muscle.
    void draw_head(PanelContext& context);
    /// Popup that generates a signal from a recipe.
    void draw_generator(PanelContext& context);
    /// Emits a new signal of the selected muscle. Empty: the signals recorded by the trials.
    static void give_signal(PanelContext& context, std::optional<fibre::Signal> signal, const std::string& what,
                            bool goes_on);
    /// What a declared muscle's signal is: the recorded one, or an edited one with the button that restores it.
    void draw_recorded(PanelContext& context);
    /// Numbers of the recipe, those of its shape only.
    void draw_recipe(PanelContext& context);
    /// Numbers that only a sine has.
    void draw_sine(PanelContext& context);
    /// Popup that reads or writes a CSV file.
    void draw_file(PanelContext& context);
    /// Plots of the pressures, tensions and shortenings of the shown trial, with the knots of those that it declares.
    void draw_commands(PanelContext& context);
    /// One of the plots, and edits of its knots.
    void draw_command_plot(PanelContext& context, const std::string& unit, plot::Plot plot, const ImVec2& size);
    /// The plot with the signals of all muscles.
    void draw_curve(PanelContext& context);

    commands::SignalRecipe recipe_;                         // of the generator
    std::string recipe_muscle_;                             // muscle that the recipe's level was chosen for
    NumberEdits edit_;                                      // drag in progress in the generator
    plot::LinkedAxis time_;                                 // zoom of the time axis
    plot::PlotState plot_;                                  // zoom of the value axis
    std::map<std::string, plot::PlotState> command_plots_;  // zoom of the commands' axes, by unit
    plot::HiddenSeries hidden_;                             // curves switched off in the legend
    KnotEditor knots_;                                      // of all plots
    bool commands_chosen_ = false;                          // instead of the selected muscle
    std::string followed_;  // name of the muscle that the zoom belongs to; empty: commands
};

}  // namespace myo::ui::panels
