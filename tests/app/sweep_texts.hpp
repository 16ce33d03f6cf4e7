#pragma once

#include <string>

#include "app/small_experiment.hpp"

namespace myo::test {

/// The head of a sweep file of the small experiment in "exp", 1 cm cells.
inline std::string sweep_head(const std::string& command = "simulate") {
    return "schema = \"sweep/1\"\nexperiment = \"exp\"\ncommand = \"" + command +
           "\"\narguments = [\"--resolution\", \"0.01\"]\n";
}

/// An axis of a sweep file.
inline std::string axis(const std::string& key, const std::string& values) {
    const char* const kind = key.starts_with("--") ? "option" : "key";
    return "[[vary]]\n" + std::string(kind) + " = \"" + key + "\"\nvalues = " + values + "\n";
}

/// The small experiment, and sweep.toml beside it.
inline void write_sweep(const Folder& folder, const std::string& text, double end_s = 0.1) {
    write_small_experiment(folder, end_s);
    folder.write("sweep.toml", text);
}

}  // namespace myo::test
