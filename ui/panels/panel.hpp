#pragma once

#include <memory>
#include <string>
#include <vector>

#include "commands/command.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"

namespace myo {

/// What a panel gets each frame: a view of the workbench, and a list to put commands into.
struct PanelContext {
    const WorkbenchState& state;
    const Theme& theme;
    ItemRectangles& items;
    std::vector<Command>& commands;
    const CellPaint* live_paint = nullptr;     // of the chosen muscle while a stroke goes on

    void emit(Command command) { commands.push_back(std::move(command)); }
};

enum class PanelPlace { rail, strip };   // left of the view, below it

/// One part of the workbench. It may keep how it looks (a text being typed, a zoom), nothing else.
class Panel {
public:
    virtual ~Panel() = default;
    virtual std::string name() const = 0;      // one word, also used by the command line
    virtual std::string title() const = 0;     // may start with an icon
    virtual PanelPlace place() const = 0;
    virtual void draw(PanelContext& context) = 0;
};

/// All panels in the order in which they appear.
std::vector<std::unique_ptr<Panel>> all_panels();

}  // namespace myo
