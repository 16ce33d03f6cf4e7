#pragma once

#include <string>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Command palette: finds actions, files, trials, panels and fields by parts of their names, and executes the selected
/// one.
///
/// Uses the same actions as menus and shortcuts, so it contains everything that they do.
class Palette {
public:
    /// Opens the palette in the next draw().
    void open();
    /// Draws the palette while it is open. A selected action is executed within this call.
    void draw(PanelContext& context, viewport::ViewportState& viewport,
              const std::vector<std::unique_ptr<Panel>>& panels);

private:
    /// By the arrow keys.
    void move_highlight(std::size_t entries);
    /// List of the matching actions. Returns the one that was chosen by a click or Enter; null: none.
    const Action* draw_found(PanelContext& context, const std::vector<const Action*>& found);

    bool wanted_ = false;  // open the popup in the next frame
    bool focus_ = false;   // the text field gets the keyboard in the next frame
    std::string text_;     // text of the search field
    int chosen_ = 0;       // index of the highlighted entry
};

/// Actions whose menu and label contain all words of the text, in any case and order. An empty text matches all. The
/// pointers refer to `actions`.
std::vector<const Action*> matching_actions(const std::string& text, const std::vector<Action>& actions);

}  // namespace myo::ui::panels
