#include "backend/examples.hpp"

#include <algorithm>
#include <map>
#include <system_error>

#include "backend/example_picture.hpp"
#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"

namespace myo::backend {

namespace fs = std::filesystem;

std::vector<ui::commands::Example> bundled_examples() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    std::vector<ui::commands::Example> examples;
    std::map<fs::path, std::size_t> trials;
    // A program in build/bin finds the source tree, an installed one its share folder; the first with examples counts.
    for (const fs::path& folder : {program / "../../assets/examples", program / "../share/myoloop/examples"}) {
        for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored)) {
            const fs::path home = fs::weakly_canonical(it->path(), ignored);
            if (!fs::is_regular_file(home / "experiment.toml", ignored)) continue;
            const Result<experiment::Experiment> experiment = experiment::read_experiment(home);
            if (!experiment) continue;
            const Result<mesh::SurfaceMesh> body = experiment::read_body_surface(*experiment);
            examples.push_back({home, experiment->name, experiment->description,
                                body ? picture_of(*body) : ui::commands::ExamplePicture{}});
            trials[home] = experiment->trials.size();
        }
        // A folder that does not exist sets the error code, which must not end the next loop.
        ignored.clear();
        if (!examples.empty()) break;
    }
    // Examples with the most trials come first.
    std::sort(examples.begin(), examples.end(), [&](const ui::commands::Example& a, const ui::commands::Example& b) {
        return trials[a.path] != trials[b.path] ? trials[a.path] > trials[b.path] : a.path < b.path;
    });
    return examples;
}

}  // namespace myo::backend
