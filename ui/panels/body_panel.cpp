#include "panels/body_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "platform/fonts.hpp"
#include "platform/input_queue.hpp"
#include "plot/ticks.hpp"

namespace myo {
namespace {

const std::vector<Choice>& element_choices() {
    static const std::vector<Choice> choices{
        {"hex8", "Hexahedra (hex8)", "Bricks of 8 nodes on a regular grid. Robust for any closed surface; curved sides become steps."},
        {"tet4", "Tetrahedra (tet4)", "Linear tetrahedra that follow the surface. Far too stiff for nearly incompressible material: "
                                      "for comparison only."},
        {"tet10", "Tetrahedra (tet10)", "Quadratic tetrahedra that follow the surface; accurate on coarse meshes."}};
    return choices;
}

CellType cell_type(const std::string& id) {
    if (id == "tet4") return CellType::tet4;
    return id == "tet10" ? CellType::tet10 : CellType::hex8;
}

// The body's size [m]; zero when nothing is open.
Eigen::Vector3d body_size(const WorkbenchState& state) {
    if (state.scene && state.scene->surface.vertices.cols() > 0) return bounding_box(state.scene->surface.vertices).size();
    if (state.body && state.body->mesh.node_count() > 0) return bounding_box(state.body->mesh.nodes).size();
    return Eigen::Vector3d::Zero();
}

}  // namespace

std::string BodyPanel::title() const { return std::string(icon::cube) + "  Body"; }

void BodyPanel::draw(PanelContext& context) {
    // What was opened from elsewhere (dropped, command line) stands in the field too.
    if (scene_ != context.state.scene && context.state.scene) path_ = context.state.scene->path.string();
    scene_ = context.state.scene;
    draw_open(context);
    ask_unit(context);
    if (!context.state.scene) return;
    ImGui::Spacing();
    draw_mesh_settings(context);
    draw_report(context);
}

void BodyPanel::draw_open(PanelContext& context) {
    const Theme& theme = context.theme;
    const float button = ImGui::GetFrameHeight() + 8.0f * theme.scale;
    ImGui::SetNextItemWidth(-(button + ImGui::GetStyle().ItemSpacing.x));
    if (ImGui::InputTextWithHint("##path", "Experiment folder or mesh file", &path_, ImGuiInputTextFlags_EnterReturnsTrue) &&
        !path_.empty()) {
        context.emit(command::Open{path_, std::nullopt});
    }
    context.items.mark("body/path");
    ImGui::SameLine();
    if (ImGui::Button(icon::folder, {button, 0.0f})) {
        browser_.open(path_.empty() && context.state.scene ? context.state.scene->path : std::filesystem::path(path_));
    }
    context.items.mark("body/browse");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Choose from a list (Ctrl+O)");
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && ImGui::IsKeyPressed(key_o, false)) browser_.open(path_);
    if (const auto chosen = browser_.draw(context)) {
        path_ = chosen->string();
        context.emit(command::Open{*chosen, std::nullopt});
    }
    if (!context.state.scene) {
        muted_text(theme, "A folder with an experiment.toml brings body, clamp, material and measured markers. A mesh file alone can "
                          "be looked at and meshed.");
        return;
    }
    const Scene& scene = *context.state.scene;
    ImGui::PushFont(theme.strong);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(scene.name.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    if (!scene.description.empty()) muted_text(theme, scene.description);
    const Eigen::Vector3d size = 1e3 * body_size(context.state);
    if (size.maxCoeff() > 0.0) {
        text_row(theme, "Size", plain_label(size.x(), 4) + " \xc3\x97 " + plain_label(size.y(), 4) + " \xc3\x97 " +
                                    plain_label(size.z(), 4) + " mm");
    }
    if (!scene.cannot_run.empty()) notice(theme, LogLevel::information, scene.cannot_run);
}

void BodyPanel::draw_mesh_settings(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    std::string element = to_string(state.settings.element);
    if (choice_row(context, "Elements", "body/element", "Shape of the finite elements.", element_choices(), element)) {
        Settings settings = state.settings;
        settings.element = cell_type(element);
        context.emit(command::ChangeSettings{settings, "element", false});
    }
    row_label(theme, "Edge length", "Edge length aimed at; the cells adapt so that the body's size is met exactly.");
    double shown = 1e3 * state.settings.resolution_m;
    const double longest = 1e3 * std::max(body_size(state).maxCoeff(), 1e-3);
    const double lowest = longest / 120.0;
    const double highest = longest / 3.0;
    const bool changed = ImGui::SliderScalar("##resolution", ImGuiDataType_Double, &shown, &lowest, &highest, "%.3g mm",
                                             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    context.items.mark("body/resolution");
    const bool goes_on = edit_.goes_on("resolution", changed);
    if (changed) {
        Settings settings = state.settings;
        settings.resolution_m = 1e-3 * shown;
        context.emit(command::ChangeSettings{settings, "resolution", goes_on});
    }
    // Counted once the mesh is there, estimated before.
    const bool built = state.mesh_is_current();
    const double elements = built ? static_cast<double>(state.body->mesh.cell_count()) : state.prediction.elements;
    const double dofs = built ? state.body->dofs : state.prediction.dofs;
    const std::string about = built || state.prediction.exact ? "" : "\xe2\x89\x88 ";
    const ImVec4* color = dofs > 3e5 ? &theme.warning : nullptr;
    text_row(theme, "Elements, DOF", about + with_separators(elements) + ", " + about + with_separators(dofs), color);
    if (!state.mesh_is_current()) {
        ImGui::BeginDisabled(state.busy());
        if (ImGui::Button("Build this mesh", {-1.0f, 0.0f})) context.emit(command::BuildMesh{});
        context.items.mark("body/build");
        ImGui::EndDisabled();
    }
}

void BodyPanel::draw_report(PanelContext& context) {
    if (!context.state.body) return;
    const MeshedBody& body = *context.state.body;
    if (!ImGui::TreeNodeEx("Mesh report", ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
        context.items.mark("body/report");
        return;
    }
    context.items.mark("body/report");
    text_row(context.theme, "Elements", with_separators(static_cast<double>(body.mesh.cell_count())) + " " + to_string(body.mesh.type));
    text_row(context.theme, "Nodes", with_separators(static_cast<double>(body.mesh.node_count())));
    text_row(context.theme, "DOF", with_separators(body.dofs));
    for (const ReportLine& line : body.report) {
        text_row(context.theme, line.label, line.value, line.warning ? &context.theme.warning : nullptr);
    }
}

void BodyPanel::ask_unit(PanelContext& context) {
    if (!context.state.unit_question) return;
    const Theme& theme = context.theme;
    const char* title = "Unit of the file";
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({400.0f * theme.scale, 0.0f});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize)) return;
    ImGui::PushTextWrapPos(0.0f);
    ImGui::Text("%s does not say in which unit its numbers are. Which one is it?", context.state.unit_question->filename().string().c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    std::optional<command::AnswerUnit> answer;
    if (ImGui::Button("Cancel", {width, 0.0f})) answer = command::AnswerUnit{};
    context.items.mark("unit/cancel");
    ImGui::SameLine();
    if (ImGui::Button("Metres", {width, 0.0f})) answer = command::AnswerUnit{1.0};
    context.items.mark("unit/m");
    ImGui::SameLine();
    if (primary_button(theme, "Millimetres", {width, 0.0f})) answer = command::AnswerUnit{1e-3};
    context.items.mark("unit/mm");
    if (answer) {
        context.emit(*answer);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace myo
