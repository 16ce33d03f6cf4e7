#pragma once

#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// A JSON file that the program wrote into a folder.
inline nlohmann::json json_at(const Folder& folder, const char* path) {
    return nlohmann::json::parse(content_of(folder.path() / path));
}

}  // namespace myo::test
