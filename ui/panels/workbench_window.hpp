#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/body_cut.hpp"
#include "commands/scene_at_time.hpp"
#include "commands/workbench.hpp"
#include "panels/box_tool.hpp"
#include "panels/compared_view.hpp"
#include "panels/distance_tool.hpp"
#include "panels/export_dialog.hpp"
#include "panels/file_browser.hpp"
#include "panels/film_job.hpp"
#include "panels/goal_tool.hpp"
#include "panels/help_panel.hpp"
#include "panels/inspect_tool.hpp"
#include "panels/layout.hpp"
#include "panels/live_tool.hpp"
#include "panels/paint_tool.hpp"
#include "panels/palette.hpp"
#include "panels/panel.hpp"
#include "panels/picture_dialog.hpp"
#include "panels/placing_tools.hpp"
#include "platform/interface.hpp"
#include "viewport/scene_renderer.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The whole window: lays out and draws the panels, renders the 3D view below them, and executes their commands and
/// requests. The same class serves a real window, images without a display, and tests.
///
/// A frame: the workbench takes results of jobs; input is handed to ImGui; the drawn scene is updated; panels are
/// drawn, filling a list of commands and a set of requests; the requests are carried out; the 3D view is rendered if it
/// has changed, and copied into the window; ImGui's lists are drawn over it; the commands are executed.
///
/// Used on the UI thread with a current OpenGL context.
class WorkbenchWindow {
public:
    /// Creates the window. Requires a current context with loaded functions.
    ///
    /// @param workbench  must outlive the window
    /// Error: a shader does not compile.
    static Result<WorkbenchWindow> make(commands::Workbench& workbench);

    /// Draws one frame into the default framebuffer, then executes the commands of its panels.
    ///
    /// @param width, height  of the framebuffer [pixels]
    /// @param seconds  since the last frame
    /// Error: the driver refuses to draw.
    Result<void> draw_frame(int width, int height, double seconds);

    /// Whether the next frame may differ from the last one. If not, the caller can wait for an event.
    bool must_draw() const;
    /// Requests frames after an event, or after a job has reported something.
    void wake() { pacer_.event_arrived(); }

    /// Files were dropped on the window.
    void drop(const std::vector<std::filesystem::path>& files) { workbench_->execute(commands::Drop{files}); }
    /// Opens a file or folder, as the command line asks.
    void open(const std::filesystem::path& path) { workbench_->execute(commands::Open{path, std::nullopt}); }
    /// Shows a task in the side panel, and its panel below the view.
    void show_task(commands::Task task);
    /// The task that is shown in the side panel.
    commands::Task task() const { return task_; }
    /// Shows a panel by its name. Returns false if there is no such panel.
    bool show_panel(const std::string& name);
    // The rest of the interface serves tests, and the program's window with its callbacks.
    /// Names that show_panel() takes: those of the panels, then those of the parts of the help.
    std::vector<std::string> panel_names() const;

    /// For the window's callbacks and tests, which push events.
    platform::InputQueue& input() { return interface_.input(); }
    /// Items of the last frame, for tests.
    const platform::ItemRectangles& items() { return interface_.items(); }
    /// The 3D view, for tests.
    const viewport::ViewportState& viewport() const { return viewport_; }
    /// The drawn scene, for tests.
    const viewport::DrawnScene& scene() const { return scene_; }
    /// The scene of the compared run, for tests.
    const viewport::DrawnScene& compared_scene() const { return compared_.scene(); }
    /// Whether values of the field that colours the body are still being computed.
    bool waits_for_field() const { return fields_.waits(); }
    /// The tool that shows what was clicked, for tests.
    const InspectTool& inspect_tool() const { return inspect_; }
    /// The tool that measures distances, for tests.
    const DistanceTool& distance_tool() const { return distances_; }
    /// Writes images of the 3D view, beginning with the next frame.
    void draw_into(const PictureRequest& request) { picture_ = request; }
    /// Number of rendered scenes, for tests: idle frames render none.
    int scene_draw_count() const { return renderer_.draw_count(); }

private:
    // Parts of the window.
    /// The column of tasks, and the panels of the shown one with the buttons at their foot.
    void draw_side(PanelContext& context);
    /// Panels of the shown task, which scroll above the foot.
    void draw_task_panels(PanelContext& context);
    /// The tabs below the view, with the selected panel.
    void draw_strip(PanelContext& context);
    /// The view with its tools, or the start page.
    void draw_view(PanelContext& context);
    /// The edges between the parts, which the user can drag.
    void draw_edges(PanelContext& context);
    /// All parts of the window and the dialogs.
    void draw_parts(PanelContext& context);
    /// Shortcuts, and the arrow keys that move in time.
    void react_to_keys(PanelContext& context);
    /// Executes the requests of the panels.
    void follow(WindowRequests& requests);
    /// Creates the drawn scene again if one of its inputs has changed.
    void update_scene();
    struct SceneKey;
    /// Inputs of the scene as they are now.
    SceneKey scene_key();
    /// Adapts camera and motion to a scene, body, run or trial that differs from the drawn one.
    void follow_scene(const SceneKey& key);
    /// Draws all parts of the window and executes their requests. Returns their commands.
    std::vector<commands::Command> draw_panels();
    /// Renders the scene into the window and writes the requested images of it.
    Result<void> render_view(int height, bool moving);
    /// Starts writing the requested images of the present view.
    void begin_pictures();
    /// Writes the next image of a running job.
    void add_picture();
    /// Loads the letters of names in other scripts, when there are new names.
    void load_names();
    /// Writes a part of the window as an image.
    void write_part(int width, int height);

    // Inputs of the drawn scene. An equal key means that the scene is unchanged.
    struct SceneKey {
        std::shared_ptr<const commands::Scene> scene;
        std::shared_ptr<const commands::MeshedBody> body;
        std::shared_ptr<const commands::RunResult> run;
        std::shared_ptr<const commands::RunResult> drawn;  // that run, or a frame of the model that plays live
        std::shared_ptr<const commands::DiagnosisView> diagnosis;
        std::shared_ptr<const commands::RecordingImport> import;
        std::string candidate;
        int trial = 0;
        double time_s = 0.0;
        commands::ViewOptions view;
        std::shared_ptr<const commands::FieldFrame> field;
        std::vector<std::shared_ptr<const fibre::CellPaint>> paint;
        std::vector<int> muscle_colors;
        int muscle = 0;
        int stroke = 0;        // PaintTool::revision()
        bool at_rest = false;  // a tool sets places of the declaration
        int placing = 0;       // PlacingTools::revision()
        platform::ThemeName theme = platform::ThemeName::dark;
        std::vector<std::size_t> compared;  // indices in the history
        bool operator==(const SceneKey&) const = default;
    };

    commands::Workbench* workbench_ = nullptr;  // not owned; outlives the window
    platform::Interface interface_;
    viewport::SceneRenderer renderer_;
    ComparedView compared_;  // next to the shown run, if asked for
    platform::FramePacer pacer_;
    std::vector<std::unique_ptr<Panel>> panels_;  // all panels, also those that are not shown
    commands::Task task_ = commands::Task::body;  // shown in the side panel
    FileBrowser browser_;
    Palette palette_;
    HelpPanel help_;
    std::pair<const commands::Scene*, std::size_t> named_{};  // scene and number of messages whose letters are loaded
    bool told_letters_ = false;                               // that no font has some letters of names
    bool about_ = false;                                      // the dialog is open
    bool asked_where_ = false;  // the dialog for the project's file name was opened for the present request
    std::optional<PictureRequest> picture_;  // starts after the view has been rendered
    std::optional<WindowPart> part_;         // written once the dialog that requested it has disappeared
    int part_waits_ = 0;                     // frames until then
    PictureDialog picture_dialog_;
    ExportDialog export_dialog_;
    FilmJob film_;
    float foot_height_ = 40.0f;         // height of the side panel's foot in the last frame [pixels]
    Layout layout_;                     // of this frame
    viewport::ViewportState viewport_;  // camera and mouse of the 3D view
    PaintTool paint_;
    LiveTool live_;
    GoalTool goals_;
    BoxTool box_tool_;
    Placing placing_;  // what clicks in the view set
    PlacingTools placing_tools_;
    NumberEdits view_edits_;  // edits in progress in the options of the view
    InspectTool inspect_;
    DistanceTool distances_;          // also drawn into images of the view
    commands::BodyCut cut_;           // the clip plane, applied to the drawn body
    viewport::DrawnScene scene_;      // what the view shows
    SceneKey scene_key_;              // inputs of scene_
    commands::MotionSummary motion_;  // of the present scene and run
    commands::FieldStore fields_;     // values of the field that colours the body
    std::uint64_t revision_ = 1;      // increased with every change of scene_
    std::string strip_panel_;         // name of the panel below the view
    bool was_moving_ = false;         // in the last frame
};

}  // namespace myo::ui::panels
