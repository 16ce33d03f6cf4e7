#include <algorithm>

#include "effect/effect.hpp"
#include "experiment/law_file.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

std::vector<std::filesystem::path> law_files(const toml::TomlReader& document, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!document.has("laws")) return files;
    for (const std::string& name : document.texts("laws")) {
        // A path that cannot be examined, for lack of permission, counts as absent.
        std::error_code ignored;
        if (name.empty() || !std::filesystem::is_regular_file(folder / name, ignored))
            document.fail("laws", "there is no file \"" + name + "\"");
        files.push_back(folder / name);
    }
    return files;
}

effect::Laws read_laws(const toml::TomlReader& document, const std::vector<std::filesystem::path>& files) {
    effect::Laws laws;
    for (const std::filesystem::path& file : files) {
        Result<effect::LawPointer> law = read_law_file(file);
        if (!law) throw toml::TomlFailure{law.error()};
        // [[effect]] and results name a law by its id.
        const bool is_twice = std::any_of(laws.begin(), laws.end(),
                                          [&](const effect::LawPointer& other) { return other->id == (*law)->id; });
        if (is_twice) document.fail("laws", "two files state a law of the id \"" + (*law)->id + "\"");
        laws.push_back(std::move(*law));
    }
    return laws;
}

}  // namespace myo::experiment
