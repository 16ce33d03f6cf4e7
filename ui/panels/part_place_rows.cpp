#include "panels/part_place_rows.hpp"

#include <imgui.h>

#include <cmath>
#include <utility>

#include "commands/part_edits.hpp"
#include "mesh/surface_mesh.hpp"
#include "panels/brush_rows.hpp"
#include "panels/declared_list.hpp"
#include "panels/declared_rows.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/tables.hpp"

namespace myo::ui::panels {
namespace {

/// The half of the body that is farther from its support, with a margin around the body.
Box far_half(const commands::Scene& scene) {
    const Box body = mesh::bounding_box(scene.surface.vertices);
    const BodyEnd end = free_end(scene);
    Box half = end_box(body, end.axis, end.upper);
    const double middle = 0.5 * (body.lowest(end.axis) + body.highest(end.axis));
    (end.upper ? half.lowest : half.highest)(end.axis) = middle;
    return half;
}

std::string item_of(std::size_t part) { return "part/" + std::to_string(part); }

/// Places that can be chosen: numbers of cells only where the mesh has some, paint only on a mesh.
std::vector<commands::Choice> place_choices(const commands::WorkbenchState& state, const std::string& chosen) {
    std::vector<commands::Choice> choices{
        {"box_m", "Box", "A box with sides along the axes; the mesh meets its faces."},
        {"file", "Surface", "A closed surface from a file, with unit and rotation of the body's."}};
    if (!state.scene->regions.empty() || chosen == "region")
        choices.push_back({"region", "Region", "The elements to which the file of the volume mesh gives a number."});
    if (state.body || chosen == "mask")
        choices.push_back({"mask", "Painted", "The elements that the brush marks in the view."});
    return choices;
}

/// Replaces the place of a part by another one, in one edit.
///
/// @param value  TOML
void replace_place(PanelContext& context, std::size_t index, const std::string& key, std::string value) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string before = commands::place_key(part);
    std::vector<commands::DeclarationEdit> edits;
    if (before != key) edits.push_back(commands::RemoveDeclared{{"part", index, before}});
    edits.push_back(commands::SetDeclared{{"part", index, key}, std::move(value)});
    context.emit(commands::EditDeclaration{std::move(edits), item_of(index) + "/place"});
}

/// Follows a choice of the list.
void choose_place(PanelContext& context, std::size_t index, const std::string& key) {
    const commands::Scene& scene = *context.state.scene;
    if (key == "box_m") replace_place(context, index, key, box_text(far_half(scene)));
    if (key == "region" && !scene.regions.empty())
        replace_place(context, index, key, std::to_string(scene.regions.begin()->first));
    if (key == "mask") context.emit(commands::PaintPart{index, nullptr});
    // The file is not known yet: the place changes when it is chosen.
    if (key == "file")
        context.window.file = part_surface_dialog(
            scene, [index](PanelContext& later, const std::filesystem::path& path) {
                if (index < later.state.scene->parts.size())
                    replace_place(later, index, "file", commands::declared_file(*later.state.scene, path));
            });
}

/// Number of the cells, as a list.
void region_row(PanelContext& context, std::size_t index, int region) {
    std::vector<commands::Choice> choices;
    for (const auto& [number, cells] : context.state.scene->regions)
        choices.push_back(
            {std::to_string(number), std::to_string(number) + " (" + with_separators(cells) + " elements)", ""});
    std::string id = std::to_string(region);
    if (choice_row(context, "Number", item_of(index) + "/region", "Number that the file gives the elements.", choices,
                   id))
        replace_place(context, index, "region", id);
}

/// Name of the file, and the button that chooses another one.
void file_row(PanelContext& context, std::size_t index, const std::filesystem::path& file) {
    row_label(context.theme, "File", "Closed surface with unit and rotation of the body's.");
    const std::string label = elided(file.filename().string(),
                                     ImGui::GetContentRegionAvail().x - 4.0f * ImGui::GetStyle().FramePadding.x);
    if (ImGui::Button((label + "##part_file").c_str(), {-1.0f, 0.0f})) choose_place(context, index, "file");
    context.items.mark(item_of(index) + "/file");
    tooltip(context.theme, file.string());
}

}  // namespace

void part_place_rows(PanelContext& context, std::size_t index, NumberEdits& edits) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string item = item_of(index), before = commands::place_key(part);
    std::string key = before;
    if (choice_row(context, "Place", item + "/place", "How it is said where the part is.",
                   place_choices(context.state, before), key))
        choose_place(context, index, key);
    if (part.box_m) box_rows(context, {{"part", index, "box_m"}, item + "/box"}, edits, *part.box_m);
    if (part.region) region_row(context, index, *part.region);
    if (!part.file.empty()) file_row(context, index, part.file);
    if (before == "mask") brush_rows(context, {item + "/brush", static_cast<int>(index)}, edits);
}

void part_buttons(PanelContext& context, NumberEdits& edits) {
    const commands::WorkbenchState& state = context.state;
    const commands::Scene& scene = *state.scene;
    const std::size_t next = scene.parts.size();
    if (ImGui::Button("Add a part", {-1.0f, 0.0f})) {
        context.emit(commands::EditDeclaration{
            {commands::AppendDeclared{{"part"}, commands::new_part(state, "box_m = " + box_text(far_half(scene)))}},
            "part/add"});
        open_item(context, item_of(next));
    }
    context.items.mark("part/add");
    tooltip(context.theme,
            "A box of the body with a material of its own, at first the half away from the support with the body's "
            "modulus. Where parts overlap, the later one counts.");
    const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x));
    if (ImGui::Button("Add a surface\xe2\x80\xa6", {half, 0.0f}))
        context.window.file = part_surface_dialog(scene, [](PanelContext& later, const std::filesystem::path& path) {
            const std::string place = "file = " + commands::declared_file(*later.state.scene, path);
            later.emit(commands::EditDeclaration{
                {commands::AppendDeclared{{"part"}, commands::new_part(later.state, place)}}, "part/add"});
            open_item(later, item_of(later.state.scene->parts.size()));
        });
    context.items.mark("part/add_file");
    tooltip(context.theme,
            "A part inside a second closed surface (STL, OBJ, PLY), with unit and rotation of the body's.");
    ImGui::SameLine();
    const bool paints = state.brush.tool != commands::BrushTool::none && state.brush.part == static_cast<int>(next);
    ImGui::BeginDisabled(!state.ground);
    if (ImGui::Button("Paint a part", {-1.0f, 0.0f})) {
        commands::BrushSettings brush = state.brush;
        brush.part = static_cast<int>(next);
        brush.tool = paints ? commands::BrushTool::none : commands::BrushTool::add;
        context.emit(commands::ChangeBrush{brush});
        open_item(context, "");
    }
    ImGui::EndDisabled();
    context.items.mark("part/add_painted");
    tooltip(context.theme, state.ground ? "The first stroke on the body makes a part of the elements under the brush."
                                        : "Build the mesh first.");
    if (paints) brush_rows(context, {"part/new_brush", static_cast<int>(next)}, edits);
}

}  // namespace myo::ui::panels
