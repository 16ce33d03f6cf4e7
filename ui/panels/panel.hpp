#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/box.hpp"
#include "commands/command.hpp"
#include "commands/workflow.hpp"
#include "panels/picture_request.hpp"
#include "panels/placing.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "toml/toml_path.hpp"

namespace myo::ui::panels {

struct PanelContext;

/// A request to choose a file or a folder. See file_dialogs.hpp for the dialogs in use.
struct FileDialog {
    std::string title;   // title of the dialog: "Open an experiment folder, a mesh or a project"
    std::string button;  // label of its button: "Open"
    // extensions of listed files, in lower case; empty: all. A new file gets the first one
    std::vector<std::string> endings;
    bool experiments = false;     // folders with an experiment.toml can be chosen
    bool folders = false;         // any folder can be chosen
    std::filesystem::path start;  // a folder, or a file in it; empty: the working folder
    std::string new_name;         // proposed name of a file to write; empty: an existing one is chosen
    // Called within a frame with the chosen path; emits the command.
    std::function<void(PanelContext&, const std::filesystem::path&)> chosen;
    // Called if the user cancels; may be empty.
    std::function<void(PanelContext&)> given_up = {};
};

/// A part of the window to be saved as an image.
struct WindowPart {
    std::filesystem::path path;  // file to write
    platform::Rectangle pixels;  // in the window
};

/// A box of the declaration whose numbers a panel shows, so that it can be dragged in the view.
struct HandledBox {
    toml::TomlPath path;
    std::string name;  // item name for tests
    Box box;           // [m]
};

/// A request to show a part of the help.
struct HelpRequest {
    enum class Part { tutorial, manual, shortcuts };
    Part part = Part::tutorial;
    std::string page = {};    // of the manual; empty: the page shown last
    std::string phrase = {};  // text of the paragraph to scroll to; empty: the beginning
};

/// Requests of panels to the window itself: dialogs, panels to show, images to write. Filled during a frame and
/// executed at its end.
struct WindowRequests {
    std::optional<FileDialog> file;         // dialog to open
    std::vector<HandledBox> boxes;          // to be dragged in the view from the next frame on
    std::optional<commands::Task> task;     // task to show
    std::string panel;                      // name of a panel to show
    std::string letters;                    // names that may need letters of other scripts
    std::optional<PictureRequest> picture;  // image or video of the 3D view to write
    std::optional<WindowPart> part;         // part of the window to write, without dialogs in front
    bool save_view = false;                 // open the dialog for images of the view
    bool export_body = false;               // open the dialog that writes the body for other programs
    std::optional<HelpRequest> help;        // part of the help to show
    bool palette = false;                   // open the command palette
    bool about = false;                     // open the dialog with version and licences
    bool clear_distances = false;           // remove all measured distances
};

/// What a panel gets in each frame: the state of the workbench to read, and lists for its commands and requests. All
/// references are valid during the call only.
struct PanelContext {
    const commands::WorkbenchState& state;  // of this frame; does not change while it is drawn
    const platform::Theme& theme;           // colours, fonts and scale
    platform::ItemRectangles& items;        // to record items for tests
    // Executed after the frame, in this order.
    std::vector<commands::Command>& commands;
    const commands::Backend& backend;              // only its quick functions may be called
    WindowRequests& window;                        // requests to the window
    Placing& placing;                              // what clicks in the view set
    const fibre::CellPaint* live_paint = nullptr;  // paint of the selected muscle during a stroke; null otherwise
    // Range of the colours that are shown, in the unit of the legend; empty: no field is shown.
    std::optional<std::array<double, 2>> field_range = {};

    /// Appends a command.
    void emit(commands::Command command) { commands.push_back(std::move(command)); }
};

/// Parts of the window that hold panels.
enum class PanelPlace { side, strip };  // left of the 3D view; below it, as one of the tabs

/// A panel of the workbench. It draws itself with ImGui and emits commands; it may keep its own display state (a text
/// being typed, a zoom), but no data of the model.
///
/// A panel records the items that tests click with `context.items.mark(name)`, right after the item was submitted to
/// ImGui. Names usually begin with the name of the panel: "fibres/add".
///
/// To add a panel: a class in a file of its own, and a line in all.cpp. Nothing else refers to a panel's type; other
/// parts of the window address it by its name.
class Panel {
public:
    virtual ~Panel() = default;
    virtual std::string name() const = 0;   // unique word, also used by the command line
    virtual std::string title() const = 0;  // shown; may start with an icon
    /// Where the panel is drawn. Constant.
    virtual PanelPlace place() const = 0;
    /// Panels at the side: the task under which they are shown. Panels below the view: the task that brings them to the
    /// front, if any.
    virtual std::optional<commands::Task> task() const { return std::nullopt; }
    /// Whether the panel is available in this state. It disappears otherwise.
    virtual bool offered(const commands::WorkbenchState&) const { return true; }
    /// Draws the panel into the current ImGui window. Called on the UI thread, only if offered() is true.
    virtual void draw(PanelContext& context) = 0;
};

/// Creates all panels, in the order in which they appear.
std::vector<std::unique_ptr<Panel>> all_panels();

}  // namespace myo::ui::panels
