#include "base/overwrites.hpp"

#include <system_error>

namespace myo {

namespace fs = std::filesystem;

Result<void> check_overwrites(const std::string& named_by, const std::vector<fs::path>& outputs,
                              const std::vector<fs::path>& inputs) {
    std::error_code missing;  // files that do not exist cannot be replaced
    for (const fs::path& output : outputs) {
        // Writing to a device or a pipe replaces nothing.
        if (!fs::is_regular_file(output, missing)) continue;
        for (const fs::path& input : inputs)
            if (fs::equivalent(output, input, missing))
                return Error{output.string() + " is read as input and would be replaced; choose another file or folder",
                             named_by};
    }
    return {};
}

}  // namespace myo
