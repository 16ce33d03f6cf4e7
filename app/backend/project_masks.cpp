#include "backend/project_masks.hpp"

#include <algorithm>
#include <cctype>
#include <cinttypes>
#include <cstdio>
#include <system_error>

#include "base/files.hpp"
#include "base/fingerprint.hpp"
#include "commands/project.hpp"
#include "toml/toml_value.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

/// Suffix of a mask file after the muscle's name: "-0123456789abcdef.csv".
std::string mask_tail(std::uint64_t hash) {
    char text[24];
    std::snprintf(text, sizeof text, "-%016" PRIx64 ".csv", hash);
    return text;
}

/// Whether a file name has the form of mask_name(): other files in the folder must not be removed.
bool is_mask_name(const std::string& name) {
    const std::string form = mask_tail(0);
    if (name.size() <= form.size()) return false;
    const std::string tail = name.substr(name.size() - form.size());
    // The zeros of the pattern stand for hexadecimal digits.
    const auto fits = [](char c, char formed) {
        return formed == '0' ? std::isxdigit(static_cast<unsigned char>(c)) != 0 : c == formed;
    };
    return std::equal(tail.begin(), tail.end(), form.begin(), fits);
}

}  // namespace

std::string mask_name(const std::string& muscle, const fibre::PaintedMask& mask) {
    Fingerprint print;
    print.add(mask.cell_size_m);
    print.add_all(mask.centroids_m);
    print.add_all(mask.weights);
    print.add_all(mask.directions);
    std::string name = muscle;
    // Muscle names may contain characters that file names must not.
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name + mask_tail(print.value());
}

std::set<std::string> named_masks(const fs::path& file, const fs::path& files) {
    std::set<std::string> names;
    std::error_code ignored;
    const Result<toml::TomlValue> document = fs::exists(file, ignored)
                                                 ? toml::read_toml(file)
                                                 : Result<toml::TomlValue>(Error{"not there", ""});
    if (!document) return names;
    for (const char* array : {"muscle", "painted"}) {
        const toml::TomlValue* const holders = document->find(array);
        if (holders == nullptr) continue;
        for (const toml::TomlValue& holder : holders->items) {
            const toml::TomlValue* const mask = holder.find("mask");
            const fs::path path = mask != nullptr ? mask->text : "";
            if (path.parent_path() == files.filename() && is_mask_name(path.filename().string()))
                names.insert(path.filename().string());
        }
    }
    return names;
}

bool is_named_beside(const fs::path& file, const std::string& mask) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(fs::absolute(file, ignored).parent_path(), ignored)) {
        // The ending is searched within the name: backups such as "finger.myoloop~" reference masks, too.
        const bool may_be_project = entry.is_regular_file(ignored) &&
                                    entry.path().filename().string().find(ui::commands::project_ending) !=
                                        std::string::npos;
        if (!may_be_project || fs::equivalent(entry.path(), file, ignored)) continue;
        const Result<std::string> text = read_file(entry.path());
        if (!text || text->find(mask) != std::string::npos) return true;  // an unreadable file may reference it
    }
    return false;
}

}  // namespace myo::backend
