#include "platform/wide_fonts.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <system_error>

namespace myo::ui::platform {
namespace {

namespace fs = std::filesystem;

/// Files of Debian's packages fonts-noto-cjk, fonts-wqy-microhei, fonts-wqy-zenhei and fonts-droid-fallback, and of
/// Adobe's original of the first.
constexpr std::array known_files{
    "NotoSansCJK-Regular.ttc", "NotoSansCJKsc-Regular.otf", "SourceHanSans-Regular.ttc", "wqy-microhei.ttc",
    "wqy-zenhei.ttc",          "DroidSansFallbackFull.ttf", "DroidSansFallback.ttf"};

}  // namespace

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders{"/usr/share/fonts", "/usr/local/share/fonts", "/usr/share/fonts-droid-fallback"};
    const char* const data = std::getenv("XDG_DATA_HOME");
    const char* const home = std::getenv("HOME");
    if (data && *data != '\0') folders.push_back(fs::path(data) / "fonts");
    if (home && *home != '\0') {
        folders.push_back(fs::path(home) / ".local/share/fonts");
        folders.push_back(fs::path(home) / ".fonts");
    }
    return folders;
}

std::vector<std::string> wide_fonts(const std::vector<fs::path>& folders) {
    std::map<std::ptrdiff_t, std::string> found;  // by the place in known_files
    for (const fs::path& folder : folders) {
        std::error_code code;
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, code);
        for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
            const auto* const known = std::find(known_files.begin(), known_files.end(),
                                                entry->path().filename().string());
            std::error_code ignored;
            if (known != known_files.end() && entry->is_regular_file(ignored))
                found.emplace(known - known_files.begin(), entry->path().string());
        }
    }
    std::vector<std::string> files;
    for (const auto& [place, file] : found) files.push_back(file);
    return files;
}

}  // namespace myo::ui::platform
