#pragma once

#include <string>

#include "panels/actions.hpp"

namespace myo {

/// Finds a command by a part of its name, and performs it.
class Palette {
public:
    void open();
    void draw(PanelContext& context, ViewportState& viewport);

private:
    bool wanted_ = false;
    bool focus_ = false;
    std::string text_;
    int chosen_ = 0;
};

/// Actions whose menu and label hold all words of the text, in any case and order.
std::vector<const Action*> matching_actions(const std::string& text);

/// Names, versions and licences of the parts.
void draw_about(PanelContext& context, bool& open);

}  // namespace myo
