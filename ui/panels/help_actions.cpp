#include "panels/help_actions.hpp"

#include "platform/input_queue.hpp"

namespace myo::ui::panels {
namespace {

using Perform = std::function<void(PanelContext&, viewport::ViewportState&)>;

/// Shows a part of the help.
Perform helps(HelpRequest::Part part) {
    return [part](PanelContext& context, viewport::ViewportState&) { context.window.help = HelpRequest{part}; };
}

}  // namespace

void add_help_actions(std::vector<Action>& all) {
    all.push_back({"help.tutorial", "Help", "Tutorial", {}, helps(HelpRequest::Part::tutorial)});
    all.push_back(
        {"help.manual", "Help", "Manual", {platform::key_f1, false, false, "F1"}, helps(HelpRequest::Part::manual)});
    all.push_back({"help.shortcuts", "Help", "Keyboard shortcuts", {}, helps(HelpRequest::Part::shortcuts)});
    all.push_back({"help.palette",
                   "Help",
                   "Find a command\xe2\x80\xa6",
                   {platform::key_k, true, false, "Ctrl+K"},
                   [](PanelContext& context, viewport::ViewportState&) { context.window.palette = true; },
                   {},
                   {},
                   true});
    all.push_back({"help.about", "Help", "About Myoloop", {}, [](PanelContext& context, viewport::ViewportState&) {
                       context.window.about = true;
                   }});
}

}  // namespace myo::ui::panels
