#include "backend/experiment_contents.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <system_error>

#include "backend/core_scene.hpp"
#include "backend/painted_parts.hpp"
#include "base/files.hpp"
#include "toml/toml_edit.hpp"
#include "toml/toml_text.hpp"
#include "toml/toml_value.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

/// Keys of a declaration whose texts are files. A text that names something else under such a key, for example a signal
/// by its name, is no existing file.
constexpr std::array file_keys{"file", "mask", "signal", "trace", "actuation", "sensors"};
/// Keys whose texts are lists of files.
constexpr std::array list_keys{"laws"};
/// Folder of a copy that takes the files which do not lie in the experiment's folder.
constexpr const char* outside_folder = "outside";

/// Appends the existing files that a value and its parts name.
///
/// @param at  path of `value`; as before on return
void collect(const toml::TomlValue& value, toml::TomlPath& at, const fs::path& folder, std::vector<NamedFile>& files) {
    for (std::size_t i = 0; i < value.items.size(); ++i) {
        const bool table = value.kind == toml::TomlValue::Kind::table;
        at.push_back(table ? toml::TomlStep(value.keys[i]) : toml::TomlStep(i));
        const toml::TomlValue& item = value.items[i];
        std::error_code ignored;
        // Lists of files exist at the top level only.
        if (table && at.size() == 1 && item.kind == toml::TomlValue::Kind::array &&
            std::find(list_keys.begin(), list_keys.end(), value.keys[i]) != list_keys.end())
            for (std::size_t k = 0; k < item.items.size(); ++k)
                if (fs::is_regular_file(folder / item.items[k].text, ignored)) {
                    at.push_back(toml::TomlStep(k));
                    files.push_back({at, (folder / item.items[k].text).lexically_normal()});
                    at.pop_back();
                }
        if (table && item.kind == toml::TomlValue::Kind::text && !item.text.empty() &&
            std::find(file_keys.begin(), file_keys.end(), value.keys[i]) != file_keys.end() &&
            fs::is_regular_file(folder / item.text, ignored))
            files.push_back({at, (folder / item.text).lexically_normal()});
        collect(item, at, folder, files);
        at.pop_back();
    }
}

/// Path relative to a folder in which it lies; empty if it lies elsewhere. Symbolic links are resolved.
fs::path inside(const fs::path& path, const fs::path& folder) {
    std::error_code ignored;
    const fs::path relative = fs::weakly_canonical(path, ignored)
                                  .lexically_relative(fs::weakly_canonical(folder, ignored));
    return relative.empty() || *relative.begin() == ".." ? fs::path() : relative;
}

/// The files that belong to a named one: TetGen divides a mesh between two.
std::vector<fs::path> with_partner(const fs::path& path) {
    std::vector<fs::path> files{path};
    std::error_code ignored;
    for (const char* const ending : {".node", ".ele"}) {
        const fs::path partner = fs::path(path).replace_extension(ending);
        const bool of_pair = path.extension() == ".node" || path.extension() == ".ele";
        if (of_pair && partner != path && fs::exists(partner, ignored)) files.push_back(partner);
    }
    return files;
}

/// Copies a file and makes the folders above it. A file that is its own target stays as it is.
Result<void> put_copy(const fs::path& from, const fs::path& to) {
    std::error_code code, ignored;
    if (fs::equivalent(from, to, ignored)) return {};
    fs::create_directories(to.parent_path(), code);
    if (!code) fs::copy_file(from, to, fs::copy_options::overwrite_existing, code);
    if (code) return Error{"cannot be copied to " + to.string() + ": " + code.message(), from.string()};
    return {};
}

/// A place for a file from elsewhere that no other such file has.
fs::path place_outside(const fs::path& file, const std::map<fs::path, fs::path>& taken) {
    for (int k = 1;; ++k) {
        // Files of one name from several folders are numbered: "left.csv", "left_2.csv".
        const std::string name = k == 1 ? file.filename().string()
                                        : file.stem().string() + "_" + std::to_string(k) + file.extension().string();
        const fs::path place = fs::path(outside_folder) / name;
        if (std::none_of(taken.begin(), taken.end(), [&](const auto& other) { return other.second == place; }))
            return place;
    }
}

/// The text that a project's experiment has: its own file's, or with the project's edits.
Result<std::string> text_of(const ui::commands::Project& project) {
    if (project.settings.declaration.text) return *project.settings.declaration.text;
    return read_file(declaration_file(project.source));
}

/// Puts a finished folder in the place of an earlier one.
Result<void> replace_folder(const fs::path& made, const fs::path& place) {
    std::error_code code;
    fs::remove_all(place, code);
    if (!code) fs::rename(made, place, code);
    if (code) return Error{"cannot be replaced: " + code.message(), place.string()};
    return {};
}

}  // namespace

std::vector<NamedFile> named_files(const std::string& text, const fs::path& folder) {
    std::vector<NamedFile> files;
    const Result<toml::TomlValue> document = toml::parse_toml(text, "");
    toml::TomlPath at;
    if (document) collect(*document, at, folder, files);
    return files;
}

Result<void> write_contents(const fs::path& from, const std::string& text, const fs::path& to) {
    Result<std::string> moved = text;
    // A file that is named twice is copied once.
    std::map<fs::path, fs::path> outside;  // places of files from elsewhere, by where they are
    for (const NamedFile& file : named_files(text, from)) {
        fs::path place = inside(file.path, from);
        if (place.empty()) {
            if (!outside.contains(file.path)) outside[file.path] = place_outside(file.path, outside);
            place = outside[file.path];
            // Keys of other files stay valid: only a text is replaced.
            moved = toml::with_value(*moved, file.key, toml::toml_text(place.generic_string()));
            if (!moved) return moved.error();
        }
        for (const fs::path& part : with_partner(file.path))
            if (const Result<void> copied = put_copy(part, to / fs::path(place).replace_extension(part.extension()));
                !copied)
                return copied;
    }
    return write_file(to / "experiment.toml", *moved);
}

Result<fs::path> put_inside(const ui::commands::Project& project, const fs::path& files) {
    std::error_code ignored;
    if (!is_experiment(project.source)) {
        const fs::path place = files / "body" / project.source.filename();
        for (const fs::path& part : with_partner(project.source))
            if (const Result<void> copied = put_copy(part, place.parent_path() / part.filename()); !copied)
                return copied.error();
        return place;
    }
    // The copy is completed under another name, so that an interruption leaves the earlier one.
    const fs::path place = files / "experiment", made = files / "experiment.new",
                   from = declaration_file(project.source).parent_path();
    const Result<std::string> text = text_of(project);
    if (!text) return text.error();
    // Opened from the project's own folder: only the declaration can differ.
    if (fs::equivalent(from, place, ignored)) {
        Result<void> written = write_contents(place, *text, place);
        if (written) written = write_masks(project.settings.declaration, place);
        if (!written) return written.error();
        return place;
    }
    fs::remove_all(made, ignored);
    Result<void> written = write_contents(from, *text, made);
    if (written) written = write_masks(project.settings.declaration, made);
    if (written) written = replace_folder(made, place);
    if (written) return place;
    fs::remove_all(made, ignored);
    return written.error();
}

}  // namespace myo::backend
