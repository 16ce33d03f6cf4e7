#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

namespace myo::test {

inline const std::vector<std::string> coarse{"--resolution", "0.01"};

inline std::vector<std::string> call(std::vector<std::string> words, const std::vector<std::string>& more = coarse) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The parsed result of a command that wrote to "out".
inline nlohmann::json json_of(const Folder& folder, const std::string& command) {
    return nlohmann::json::parse(content_of(folder.path() / "out" / (command + ".json")));
}

/// A command on this experiment, interrupted as soon as a text stands in its progress.
inline ProgramRun interrupted(const Folder& folder, const std::string& command, const std::string& resolution,
                              const std::string& when) {
    return run_program(
        {command, folder.str("exp"), "--out", folder.str("out"), "--resolution", resolution, "--json-progress"}, when);
}

/// No null and no NaN anywhere, and no temporary file left.
inline void expect_clean(const Folder& folder) {
    for (const std::filesystem::directory_entry& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
        if (entry.path().extension() != ".json") continue;
        const std::string text = content_of(entry.path());
        EXPECT_EQ(text.find("null"), std::string::npos) << entry.path();
        EXPECT_TRUE(nlohmann::json::accept(text)) << entry.path();
    }
}

/// What --json-progress has written among the warnings.
inline std::vector<nlohmann::json> progress_events(const ProgramRun& run) {
    std::vector<nlohmann::json> events;
    std::istringstream lines(run.err);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("myoloop: ", 0) == 0) continue;
        events.push_back(nlohmann::json::parse(line));
        EXPECT_EQ(events.back().at("event"), "progress");
    }
    return events;
}

}  // namespace myo::test
