#include "backend/painted_parts.hpp"

#include <system_error>
#include <variant>

#include "backend/project_masks.hpp"
#include "fibre/painted_mask.hpp"
#include "toml/toml_edit.hpp"
#include "toml/toml_text.hpp"
#include "toml/toml_value.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;
using ui::commands::Declaration;

/// Folder in that of the experiment which takes the masks of parts.
constexpr const char* parts_folder = "parts";

}  // namespace

Result<std::string> with_painted_part(const std::string& text, const ui::commands::PaintDeclared& edit,
                                      Declaration& painted) {
    Result<toml::TomlValue> document = toml::parse_toml(text, "");
    if (!document) return document.error();
    const toml::TomlValue* const parts = document->find("part");
    if (!parts || edit.part >= parts->items.size()) return Error{"there is no such part", "part"};
    const toml::TomlValue& part = parts->items[edit.part];
    Result<std::string> result = text;
    // A part has exactly one place.
    for (const char* key : {"box_m", "file", "region"})
        if (result && part.find(key)) result = toml::without(*result, {"part", edit.part, key});
    const toml::TomlValue* const name = part.find("name");
    const std::string file = std::string(parts_folder) + "/" + mask_name(name ? name->text : "part", *edit.mask);
    if (result) result = toml::with_value(*result, {"part", edit.part, "mask"}, toml::toml_text(file));
    if (result) painted.painted[file] = edit.mask;
    return result;
}

void give_masks(const Declaration& declaration, const fs::path& folder, experiment::Experiment& experiment) {
    for (experiment::PartDeclaration& part : experiment.parts) {
        auto* const painted = std::get_if<experiment::PartDeclaration::Painted>(&part.place);
        const auto* const file = painted ? std::get_if<fs::path>(&painted->mask) : nullptr;
        if (!file) continue;
        const auto known = declaration.painted.find(file->lexically_relative(folder).generic_string());
        if (known != declaration.painted.end()) painted->mask = known->second;
    }
}

Result<void> write_masks(const Declaration& declaration, const fs::path& folder) {
    std::error_code code;
    for (const auto& [name, mask] : declaration.painted) {
        // An existing file of this name has the same content.
        if (!declaration.text || declaration.text->find(name) == std::string::npos || fs::exists(folder / name, code))
            continue;
        fs::create_directories((folder / name).parent_path(), code);
        if (const Result<void> written = fibre::write_painted_mask(folder / name, *mask); !written) return written;
    }
    return {};
}

Result<std::string> project_text_of_masks(const Declaration& declaration, const fs::path& files,
                                          std::set<std::string>& used) {
    std::string text;
    std::error_code code;
    for (const auto& [name, mask] : declaration.painted) {
        if (!declaration.text || declaration.text->find(name) == std::string::npos) continue;
        const std::string file = fs::path(name).filename().string();
        if (!fs::exists(files / file, code))
            if (const Result<void> written = fibre::write_painted_mask(files / file, *mask); !written)
                return written.error();
        used.insert(file);
        text += "\n[[painted]]\nname = " + toml::toml_text(name) +
                "\nmask = " + toml::toml_text(files.filename().string() + "/" + file) + "\n";
    }
    return text;
}

std::map<std::string, std::shared_ptr<const fibre::PaintedMask>> read_project_parts(
    const toml::TomlReader& document, const fs::path& folder, std::vector<std::string>& warnings) {
    std::map<std::string, std::shared_ptr<const fibre::PaintedMask>> masks;
    std::error_code code;
    for (const toml::TomlReader& table : document.tables("painted", {"name", "mask"})) {
        if (!fs::exists(folder / table.text("mask"), code)) {
            warnings.push_back("The mask " + table.text("mask") + " of a painted part is not there.");
            continue;
        }
        const Result<fibre::PaintedMask> mask = fibre::read_painted_mask(table.file("mask", folder));
        if (!mask) table.fail("mask", mask.error().text());
        masks[table.text("name")] = std::make_shared<const fibre::PaintedMask>(*mask);
    }
    return masks;
}

}  // namespace myo::backend
