#pragma once

#include <optional>
#include <string>
#include <vector>

#include "help/markdown.hpp"
#include "panels/panel.hpp"
#include "panels/tutorial.hpp"

namespace myo::ui::panels {

/// Help at the right edge of the window: the tutorial, the pages of the manual, and the list of shortcuts. It lies next
/// to the view and covers nothing.
class HelpPanel {
public:
    /// Opens the help at the part, page and phrase of a request. A phrase that the page does not contain is ignored.
    void open(const HelpRequest& request);
    /// Hides the help. Part, page and ticks are kept.
    void close() { open_ = false; }
    bool is_open() const { return open_; }
    /// Ticks the steps of the tutorial, also while it is closed.
    void follow(const commands::WorkbenchState& state) { progress_.follow(state); }
    /// Draws the content into the current ImGui window. Escape closes it.
    void draw(PanelContext& context);

private:
    /// The steps with their ticks, and the button that starts the tutorial again.
    void draw_tutorial(PanelContext& context);
    /// A step by its index. The next one to do has a button that shows its task.
    void draw_step(PanelContext& context, std::size_t index);
    /// Lists of pages and sections, and below them the text of the page.
    void draw_manual(PanelContext& context);
    /// Table of the keys of all actions, and of those that belong to none.
    void draw_shortcuts(PanelContext& context);
    /// Reads a page unless it is shown already.
    void show_page(const std::string& name);

    bool open_ = false;  // see is_open()
    HelpRequest::Part part_ = HelpRequest::Part::tutorial;
    TutorialProgress progress_;
    std::string page_;                   // name of the page that is shown
    std::vector<help::Block> blocks_;    // of that page
    std::optional<std::size_t> target_;  // block to scroll to in the next frame
    int draws_ = 0;                      // frames in which the target is still sought, as heights settle
};

}  // namespace myo::ui::panels
