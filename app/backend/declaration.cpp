#include "backend/declaration.hpp"

#include "backend/core_scene.hpp"
#include "backend/experiment_contents.hpp"
#include "backend/marker_edit.hpp"
#include "backend/painted_parts.hpp"
#include "base/files.hpp"
#include "experiment/new_trial.hpp"
#include "experiment/read_experiment.hpp"
#include "toml/toml_edit.hpp"
#include "toml/toml_text.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;
using ui::commands::Declaration;

/// The text with the edits, or as it was when the scene was opened.
const std::string& text_of(const ui::commands::Scene& scene, const Declaration& declaration) {
    return declaration.text ? *declaration.text : *source_of(scene).text;
}

/// Text of what in a declaration changes the mesh; empty if the declaration cannot be parsed. Two declarations with
/// equal words have the same mesh.
std::string mesh_words(const std::string& text) {
    const Result<toml::TomlValue> document = toml::parse_toml(text, "");
    std::string result;
    if (!document) return result;
    for (const char* key : {"geometry", "clamp"})
        if (const toml::TomlValue* value = document->find(key)) result += toml::toml_value_text(*value);
    // Only the box of a support counts: which axes are held does not move nodes.
    if (const toml::TomlValue* supports = document->find("support"))
        for (const toml::TomlValue& support : supports->items)
            if (const toml::TomlValue* box = support.find("box_m")) result += toml::toml_value_text(*box);
    // The mesh meets the faces of boxes of parts; other places and materials leave it as it is.
    if (const toml::TomlValue* parts = document->find("part"))
        for (const toml::TomlValue& part : parts->items)
            if (const toml::TomlValue* box = part.find("box_m")) result += toml::toml_value_text(*box);
    return result;
}

/// The text with one edit. Errors: the edit does not fit the text.
Result<std::string> with_edit(const std::string& text, const ui::commands::DeclarationEdit& edit) {
    if (const auto* set = std::get_if<ui::commands::SetDeclared>(&edit))
        return toml::with_value(text, set->path, set->value);
    if (const auto* removed = std::get_if<ui::commands::RemoveDeclared>(&edit))
        return toml::without(text, removed->path);
    if (const auto* added = std::get_if<ui::commands::AppendDeclared>(&edit))
        return toml::with_appended_table(text, added->array, added->body);
    if (const auto* renamed = std::get_if<ui::commands::RenameMarker>(&edit))
        return with_renamed_marker(text, renamed->name, renamed->wanted);
    // The copy stands behind its original in the array of tables and needs a name of its own.
    const auto& copied = std::get<ui::commands::DuplicateDeclared>(edit);
    const Result<std::string> twice = toml::with_duplicated_table(text, copied.element);
    if (!twice) return twice;
    toml::TomlPath name = copied.element;
    name.back() = std::get<std::size_t>(name.back()) + 1;
    name.emplace_back("name");
    return toml::with_value(*twice, name, toml::toml_text(copied.name));
}

}  // namespace

Result<Declaration> edited_declaration(const ui::commands::Scene& scene, const Declaration& declaration,
                                       const std::vector<ui::commands::DeclarationEdit>& edits) {
    Result<std::string> text = text_of(scene, declaration);
    Declaration result;
    result.painted = declaration.painted;
    for (const ui::commands::DeclarationEdit& edit : edits) {
        const auto* const paint = std::get_if<ui::commands::PaintDeclared>(&edit);
        text = paint ? with_painted_part(*text, *paint, result) : with_edit(*text, edit);
        if (!text) return text.error();
    }
    // Undo has its own declarations, so that masks which the text no longer names need not be kept.
    std::erase_if(result.painted, [&](const auto& entry) { return text->find(entry.first) == std::string::npos; });
    std::string edited_words = mesh_words(*text);
    // Only a difference is kept, so that an edit that is undone by another one restores the meshed state.
    if (mesh_words(*source_of(scene).text) != edited_words) result.mesh_words = std::move(edited_words);
    result.text = std::make_shared<const std::string>(std::move(*text));
    return result;
}

Result<ui::commands::Scene> redeclared_scene(const ui::commands::Scene& scene, const Declaration& declaration,
                                             const ui::commands::MeshedBody* body) {
    const fs::path file = declaration_file(scene.path);
    Result<experiment::Experiment> experiment = experiment::read_experiment_text(text_of(scene, declaration), file);
    if (!experiment) return Error{experiment.error().what, ""};  // the line is one of a text that no file holds
    give_masks(declaration, file.parent_path(), *experiment);
    Result<ui::commands::Scene> result = scene_of(scene, *experiment, body);
    if (!result) return Error{result.error().what, ""};
    return result;
}

Result<void> write_scene_declaration(const ui::commands::Scene& scene, const Declaration& declaration) {
    const fs::path file = declaration_file(scene.path);
    // Masks first, so that an interruption leaves a complete experiment.
    if (const Result<void> written = write_masks(declaration, file.parent_path()); !written) return written;
    return write_file(file, text_of(scene, declaration));
}

Result<void> write_plain_scene(const fs::path& folder, const ui::commands::Scene& scene,
                               const ui::commands::Settings& settings) {
    return experiment::write_planned_experiment(folder, with_settings(source_of(scene).experiment, settings),
                                                source_of(scene).surface);
}

Result<void> write_scene_copy(const fs::path& folder, const ui::commands::Scene& scene,
                              const Declaration& declaration) {
    // copy_experiment() takes the folder; write_contents() then adds what the edited text names elsewhere.
    const fs::path from = declaration_file(scene.path).parent_path();
    if (const Result<void> copied = experiment::copy_experiment(from, folder); !copied) return copied;
    Result<void> written = write_contents(from, text_of(scene, declaration), folder);
    if (written) written = write_masks(declaration, folder);
    std::error_code ignored;
    if (!written) fs::remove_all(folder, ignored);
    return written;
}

}  // namespace myo::backend
