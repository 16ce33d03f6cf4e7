#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.hpp"
#include "commands/workflow.hpp"
#include "panels/picture_request.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"

namespace myo::ui::panels {

struct PanelContext;

/// A file or folder to be chosen.
struct FileDialog {
    std::string title;                 // "Open an experiment folder, a mesh or a project"
    std::string button;                // "Open"
    std::vector<std::string> endings;  // of the files that are listed, in small letters; empty: all. A new file gets
                                       // the first, unless it has one
    bool experiments = false;          // folders with an experiment.toml can be chosen
    bool folders = false;              // any folder can be chosen
    std::filesystem::path start;       // a folder, or a file in it; empty: the working folder
    std::string new_name;              // of a file to be written; empty: one that exists is chosen
    std::function<void(PanelContext&, const std::filesystem::path&)> chosen;
    std::function<void(PanelContext&)> given_up = {};
};

/// A part of the window that is to become a picture.
struct WindowPart {
    std::filesystem::path path;
    platform::Rectangle pixels;
};

/// What a panel asks of the window itself.
struct WindowRequests {
    std::optional<FileDialog> file;
    std::optional<commands::Step> step;     // to be shown
    std::string panel;                      // to be brought to the front, by its name
    std::optional<PictureRequest> picture;  // of the 3D view
    std::optional<WindowPart> part;         // of the window as it is seen without dialogs
    bool save_view = false;                 // the dialog that asks what of the view to save
    bool palette = false;
    bool about = false;
    bool clear_distances = false;
};

/// What a panel gets each frame: a view of the workbench, and a list to put commands into.
struct PanelContext {
    const commands::WorkbenchState& state;
    const platform::Theme& theme;
    platform::ItemRectangles& items;
    std::vector<commands::Command>& commands;
    const commands::Backend& backend;  // its quick functions only
    WindowRequests& window;
    const fibre::CellPaint* live_paint = nullptr;  // of the chosen muscle while a stroke goes on
    std::optional<std::array<double, 2>> field_range =
        {};  // of the colours that are shown, in the unit of their legend

    void emit(commands::Command command) { commands.push_back(std::move(command)); }
};

enum class PanelPlace { side, strip };  // left of the view, below it

/// One part of the workbench. It may keep how it looks (a text being typed, a zoom), nothing else.
class Panel {
public:
    virtual ~Panel() = default;
    virtual std::string name() const = 0;   // one word, also used by the command line
    virtual std::string title() const = 0;  // may start with an icon
    virtual PanelPlace place() const = 0;
    /// At the side: the step under which it is found. In the strip: the step that brings it to the front, if any.
    virtual std::optional<commands::Step> step() const { return std::nullopt; }
    /// Whether it has anything to show or to ask; else it is not there.
    virtual bool offered(const commands::WorkbenchState&) const { return true; }
    virtual void draw(PanelContext& context) = 0;
};

/// All panels in the order in which they appear.
std::vector<std::unique_ptr<Panel>> all_panels();

}  // namespace myo::ui::panels
