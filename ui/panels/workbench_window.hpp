#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "commands/body_cut.hpp"
#include "commands/scene_at_time.hpp"
#include "commands/workbench.hpp"
#include "panels/distance_tool.hpp"
#include "panels/file_browser.hpp"
#include "panels/film_job.hpp"
#include "panels/inspect_tool.hpp"
#include "panels/layout.hpp"
#include "panels/paint_tool.hpp"
#include "panels/palette.hpp"
#include "panels/panel.hpp"
#include "panels/picture_dialog.hpp"
#include "platform/interface.hpp"
#include "viewport/scene_renderer.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The whole window: lays out the panels, draws the view under them, and carries out what they ask for. The same for a
/// real window, for pictures without a display, and for tests.
class WorkbenchWindow {
public:
    /// Needs a current context with loaded functions.
    /// @param workbench  must outlive the window
    static Result<WorkbenchWindow> make(commands::Workbench& workbench);

    /// One frame into the default framebuffer. The context has this size [pixels].
    /// @param seconds  since the last frame
    /// Error: the driver refuses to draw.
    Result<void> draw_frame(int width, int height, double seconds);

    /// Whether the next frame may differ from the last.
    bool must_draw() const;
    /// An event came in, or a job reported.
    void wake() { pacer_.event_arrived(); }

    void drop(const std::vector<std::filesystem::path>& files) { workbench_->execute(commands::Drop{files}); }
    void open(const std::filesystem::path& path) { workbench_->execute(commands::Open{path, std::nullopt}); }
    /// Shows a step at the side, and what belongs to it below the view.
    void show_step(commands::Step step);
    commands::Step step() const { return step_; }
    /// Brings a panel to the front, by its name; false when there is none.
    bool show_panel(const std::string& name);
    std::vector<std::string> panel_names() const;

    platform::InputQueue& input() { return interface_.input(); }
    const platform::ItemRectangles& items() { return interface_.items(); }
    const viewport::ViewportState& viewport() const { return viewport_; }
    const viewport::DrawnScene& scene() const { return scene_; }
    /// Whether values of the field that colours the body are still being computed.
    bool waits_for_field() const { return fields_.waits(); }
    const InspectTool& inspect_tool() const { return inspect_; }
    const DistanceTool& distance_tool() const { return distances_; }
    /// The 3D view into files, from the next frame on.
    void draw_into(const PictureRequest& request) { picture_ = request; }
    int scene_draw_count() const { return renderer_.draw_count(); }

private:
    void draw_side(PanelContext& context);
    void draw_strip(PanelContext& context);
    void draw_view(PanelContext& context);
    void draw_edges(PanelContext& context);
    void draw_parts(PanelContext& context);
    void react_to_keys(PanelContext& context);
    void follow(WindowRequests& requests);
    void update_scene();
    /// Takes the view as it is now for the pictures that were asked for.
    void begin_pictures();
    void add_picture();
    void write_part(int width, int height);

    // What the drawn scene was made from.
    struct SceneKey {
        std::shared_ptr<const commands::Scene> scene;
        std::shared_ptr<const commands::MeshedBody> body;
        std::shared_ptr<const commands::RunResult> run;
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
        int stroke = 0;
        platform::ThemeName theme = platform::ThemeName::dark;
        std::vector<std::size_t> compared;  // in the history
        bool operator==(const SceneKey&) const = default;
    };

    commands::Workbench* workbench_ = nullptr;
    platform::Interface interface_;
    viewport::SceneRenderer renderer_;
    platform::FramePacer pacer_;
    std::vector<std::unique_ptr<Panel>> panels_;
    commands::Step step_ = commands::Step::body;
    FileBrowser browser_;
    Palette palette_;
    bool about_ = false;
    bool asked_where_ = false;               // to save: the dialog was opened
    std::optional<PictureRequest> picture_;  // to be begun after the next drawing of the view
    std::optional<WindowPart> part_;         // likewise, once the dialog that asked for it is gone
    int part_waits_ = 0;                     // frames until then
    PictureDialog picture_dialog_;
    FilmJob film_;
    float foot_height_ = 40.0f;  // of the rail's foot, as it was in the last frame
    Layout layout_;
    viewport::ViewportState viewport_;
    PaintTool paint_;
    InspectTool inspect_;
    DistanceTool distances_;
    commands::BodyCut cut_;
    viewport::DrawnScene scene_;
    SceneKey scene_key_;
    commands::MotionSummary motion_;
    commands::FieldStore fields_;
    std::uint64_t revision_ = 1;
    std::string strip_panel_;  // in front
    bool was_moving_ = false;
};

}  // namespace myo::ui::panels
