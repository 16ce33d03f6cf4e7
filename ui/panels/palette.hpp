#pragma once

#include <string>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Finds a command, or anything else that can be shown, by a part of its name, and performs it.
class Palette {
public:
    void open();
    void draw(PanelContext& context, viewport::ViewportState& viewport,
              const std::vector<std::unique_ptr<Panel>>& panels);

private:
    bool wanted_ = false;
    bool focus_ = false;
    std::string text_;
    int chosen_ = 0;
};

/// Those whose menu and label hold all words of the text, in any case and order.
std::vector<const Action*> matching_actions(const std::string& text, const std::vector<Action>& actions);

}  // namespace myo::ui::panels
