#include "reference_files.hpp"

#include <system_error>

#include "bench/published_beam.hpp"

namespace myo::app {

namespace fs = std::filesystem;

std::vector<fs::path> reference_files() {
    std::vector<fs::path> files;
    std::error_code missing;
    // A missing folder has no files; an unreadable one is skipped.
    for (const char* const part : {"data", "design/reference"}) {
        const auto skip = fs::directory_options::skip_permission_denied;
        fs::recursive_directory_iterator entry(bench::data_folder() / part, skip, missing);
        for (; !missing && entry != fs::recursive_directory_iterator(); entry.increment(missing))
            if (entry->is_regular_file(missing)) files.push_back(entry->path());
    }
    return files;
}

}  // namespace myo::app
