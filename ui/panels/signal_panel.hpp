#pragma once

#include <map>

#include "commands/muscle_signal.hpp"
#include "commands/signal_shapes.hpp"
#include "panels/number_field.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Edits the signal a(t) of the selected muscle as a curve: knots are dragged, a double click adds a knot, a right
/// click removes it. Signals can also be generated and read from files.
///
/// Emits ChangeSettings, ChooseMuscle, ImportSignal, ExportSignal and SetTime. Comes to the front with the task Fibres.
/// Item names begin with "signals/".
class SignalPanel : public Panel {
public:
    std::string name() const override { return "signals"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Task> task() const override { return commands::Task::fibres; }
    void draw(PanelContext& context) override;

private:
    /// Muscle, generator, file and display controls.
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
    /// Pressures, tensions and shortenings of the shown trial; false if it has none.
    bool draw_commands(PanelContext& context);
    /// The plot with the signals of all muscles.
    void draw_curve(PanelContext& context);
    /// @param plot  result of drawing the plot that the knots lie on
    /// Draws the knots and moves, adds and removes them with the mouse.
    ///
    void edit_knots(PanelContext& context, const fibre::Signal& signal, const plot::PlotResult& plot);

    commands::SignalRecipe recipe_;                         // of the generator
    std::string recipe_muscle_;                             // muscle that the recipe's level was chosen for
    NumberEdits edit_;                                      // drag in progress in the generator
    plot::LinkedAxis time_;                                 // zoom of the time axis
    plot::PlotState plot_;                                  // zoom of the value axis
    std::map<std::string, plot::PlotState> command_plots_;  // zoom of the commands' axes, by unit
    plot::HiddenSeries hidden_;                             // curves switched off in the legend
    std::optional<std::size_t> grabbed_;                    // index of the dragged knot
    bool moved_ = false;    // the dragged knot has moved, so undo merges further changes
    std::string followed_;  // name of the muscle that the zoom belongs to
};

}  // namespace myo::ui::panels
