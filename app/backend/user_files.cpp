#include "backend/user_files.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <system_error>

#include "base/files.hpp"
#include "base/text.hpp"
#include "commands/project.hpp"
#include "mesh/cell_traits.hpp"
#include "toml/toml_reader.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

/// Begin of the name of a recovery file: "unsaved-<process>-<start of the process>.myoloop".
const std::string recovery_stem = "unsaved-";

/// Folder by the XDG base directory specification; empty if neither the variable nor HOME is set.
fs::path folder_of(const char* variable, const char* below_home) {
    const char* const named = std::getenv(variable);
    if (named && *named) return fs::path(named) / "myoloop";
    const char* const home = std::getenv("HOME");
    return home && *home ? fs::path(home) / below_home / "myoloop" : fs::path();
}

/// TOML literal string. Apostrophes are left out, as such a string cannot hold them.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        if (c != '\'') result += c;
    return result + "'";  // TOML literal string; paths with an apostrophe are not stored
}

/// Paths as a TOML array; those that a literal string cannot hold, or that are no text in UTF-8, are left out: they
/// would make the whole file unreadable.
std::string list(const std::vector<fs::path>& paths) {
    std::string text;
    for (const fs::path& path : paths)
        if (path.string().find('\'') == std::string::npos && toml::parse_toml("path = " + quoted(path.string()), ""))
            text += "\n    " + quoted(path.string()) + ",";
    return "[" + text + (text.empty() ? "]" : "\n]");
}

/// Measured times of a step by mesh size, with which the window estimates how long a run takes.
std::string step_costs(const std::vector<ui::commands::StepCost>& costs) {
    std::string text;
    for (const ui::commands::StepCost& cost : costs)
        text += "\n[[step_cost]]\nelement = " + quoted(to_string(cost.element)) +
                "\ndofs = " + format_number(cost.dofs, 12) + "\nseconds = " + format_number(cost.seconds, 6) + "\n";
    return text;
}

/// Preferences from the parsed file; missing keys keep their defaults. Throws TomlFailure.
ui::commands::Preferences read_document(const toml::TomlValue& root) {
    const toml::TomlReader document(
        root, "", {"theme", "scale", "side_width", "strip_height", "recent", "bookmarks", "step_cost"});
    ui::commands::Preferences p;
    if (document.has("theme"))
        p.theme = document.choice<ui::platform::ThemeName>(
            "theme", {{"dark", ui::platform::ThemeName::dark}, {"light", ui::platform::ThemeName::light}});
    p.scale = static_cast<float>(
        document.number_or("scale", 0.0, toml::between(0.0, static_cast<double>(ui::commands::greatest_scale))));
    p.layout.rail = static_cast<float>(
        document.number_or("side_width", static_cast<double>(p.layout.rail), toml::between(100.0, 4000.0)));
    p.layout.strip = static_cast<float>(
        document.number_or("strip_height", static_cast<double>(p.layout.strip), toml::between(50.0, 4000.0)));
    if (document.has("recent"))
        for (const std::string& path : document.texts("recent")) p.recent.emplace_back(path);
    if (document.has("bookmarks"))
        for (const std::string& path : document.texts("bookmarks")) p.bookmarks.emplace_back(path);
    if (document.has("step_cost"))
        for (const toml::TomlReader& cost : document.tables("step_cost", {"element", "dofs", "seconds"}))
            ui::commands::remember(p.step_costs,
                                   {cost.choice<mesh::CellType>("element", mesh::named_cell_types()),
                                    cost.number("dofs", toml::positive()), cost.number("seconds", toml::positive())});
    std::error_code ignored;
    // Recent files that no longer exist are dropped.
    std::erase_if(p.recent, [&](const fs::path& path) { return !fs::exists(path, ignored); });
    return p;
}

/// Whether a process exists and runs this program: the number of one that failed may be another program's by now. A
/// process of another user counts.
bool is_alive(long process) {
    if (process <= 0 || process == getpid()) return false;
    // Signal 0 is not sent; the call only says whether the process exists.
    if (kill(static_cast<pid_t>(process), 0) != 0) return errno == EPERM;
    std::error_code unknown;
    const fs::path own = fs::read_symlink("/proc/self/exe", unknown),
                   other = fs::read_symlink("/proc/" + std::to_string(process) + "/exe", unknown);
    // If /proc cannot say, the file is left to its possible owner: unsaved work must not be taken from a running
    // window.
    return unknown || own.filename() == other.filename();
}

/// Distinguishes this process from an earlier one of the same number.
const std::string& own_start() {
    static const std::string start = std::to_string(
        std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count());
    return start;
}

}  // namespace

fs::path preferences_file() {
    const fs::path folder = folder_of("XDG_CONFIG_HOME", ".config");
    return folder.empty() ? folder : folder / "preferences.toml";
}

Result<ui::commands::Preferences> read_preferences(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return ui::commands::Preferences{};
    const Result<toml::TomlValue> document = toml::read_toml(file);
    if (!document) return document.error();
    try {
        return read_document(*document);
    } catch (const toml::TomlFailure& failure) {
        return failure.error;
    }
}

Result<void> write_preferences(const fs::path& file, const ui::commands::Preferences& p) {
    return write_file(
        file, std::string("theme = ") + (p.theme == ui::platform::ThemeName::dark ? "'dark'" : "'light'") +
                  "\nscale = " + format_number(static_cast<double>(p.scale), 6) +
                  "\nside_width = " + format_number(static_cast<double>(p.layout.rail), 6) + "\nstrip_height = " +
                  format_number(static_cast<double>(p.layout.strip), 6) + "\nrecent = " + list(p.recent) +
                  "\nbookmarks = " + list(p.bookmarks) + "\n" + step_costs(p.step_costs));
}

fs::path recovery_file() {
    const fs::path folder = folder_of("XDG_STATE_HOME", ".local/state");
    return folder.empty()
               ? folder
               : folder / (recovery_stem + std::to_string(getpid()) + "-" + own_start() + ui::commands::project_ending);
}

std::string unsaved_work_words(const fs::path& file) {
    std::string name = "without a name";
    if (const Result<toml::TomlValue> work = toml::read_toml(file)) {
        // `copy_of` is the project that the unsaved work belongs to; work that was never saved has its source only.
        const toml::TomlValue* const copied = work->find("copy_of");
        const toml::TomlValue* const source = copied != nullptr ? copied : work->find("source");
        fs::path from = source != nullptr ? source->text : name;
        if (from.filename() == "experiment.toml") from = from.parent_path();
        name = from.filename().string();
    }
    struct ::stat facts {};
    std::tm local{};
    std::array<char, 64> text{};
    if (::stat(file.c_str(), &facts) != 0 || localtime_r(&facts.st_mtime, &local) == nullptr) return name;
    // %e pads days below ten with a space.
    std::strftime(text.data(), text.size(), "%e %b %Y, %H:%M", &local);
    return name + ", " + (text[0] == ' ' ? text.data() + 1 : text.data());
}

std::vector<fs::path> found_recoveries(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code ignored;
    for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored)) {
        const std::string stem = it->path().stem().string();
        if (!ui::commands::is_project(it->path()) || stem.rfind(recovery_stem, 0) != 0) continue;
        // The file name contains the process id; a running process still owns its file.
        if (it->path().filename() == recovery_file().filename()) continue;
        if (is_alive(std::atol(stem.c_str() + recovery_stem.size()))) continue;
        std::error_code other;
        // The time sorts the files; one that vanished meanwhile sorts first.
        found.emplace_back(fs::last_write_time(it->path(), other), it->path());
    }
    std::sort(found.begin(), found.end());
    std::vector<fs::path> files;
    for (auto& [time, path] : found) files.push_back(std::move(path));
    return files;
}

}  // namespace myo::backend
