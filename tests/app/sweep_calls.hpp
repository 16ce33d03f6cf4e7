#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/json_at.hpp"
#include "app/sweep_texts.hpp"

namespace myo::test {

inline ProgramRun run_sweep(const Folder& folder, std::vector<std::string> more = {},
                            const std::string& interrupt_when = {}) {
    more.insert(more.begin(), {"sweep", folder.str("sweep.toml"), "--out", folder.str("out")});
    return run_program(more, interrupt_when);
}

inline nlohmann::json sweep_rows(const Folder& folder) { return json_at(folder, "out/sweep.json").at("rows"); }

/// Number of a row of sweep.json.
inline double number_of(const nlohmann::json& row, const std::string& name) {
    return row.at("numbers").at(name).at("value").get<double>();
}

}  // namespace myo::test
