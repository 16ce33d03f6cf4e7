#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/result.hpp"

namespace myo::diagnosis {

/// Fits that were finished, by a text that says what was fitted from where; so that work that was stopped goes on.
///
/// Safe to share between threads. Without a file it remembers nothing.
class FitStore {
public:
    FitStore() = default;
    /// Reads what is there; a file that is not, or is of another setup, is begun anew. `setup` says on what the fits
    /// were done.
    FitStore(std::filesystem::path file, std::string setup);

    std::optional<Eigen::VectorXd> find(const std::string& fit) const;
    /// Adds one and writes the file.
    Result<void> keep(const std::string& fit, const Eigen::VectorXd& values);

private:
    std::optional<std::filesystem::path> file_;
    std::string setup_;
    std::map<std::string, Eigen::VectorXd> fits_;
    mutable std::mutex mutex_;
};

}  // namespace myo::diagnosis
