#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/result.hpp"

namespace myo::diagnosis {

/// Finished fits, stored under a text that describes problem and start; a stopped diagnosis resumes from them.
///
/// Thread-safe. Without a file nothing is stored.
class FitStore {
public:
    FitStore() = default;
    /// Reads the file. It starts empty if the file does not exist or belongs to another setup.
    /// @param setup  description of everything that all fits depend on
    FitStore(std::filesystem::path file, std::string setup);

    /// Note that the file holds fits of another setup, mesh or version, which are not used; empty: it does not.
    std::string unused_note() const;

    /// Values of a stored fit; empty if there is none.
    std::optional<Eigen::VectorXd> find(const std::string& fit) const;
    /// Stores the values of a fit and writes the file. Errors: the file cannot be written.
    Result<void> keep(const std::string& fit, const Eigen::VectorXd& values);

private:
    std::optional<std::filesystem::path> file_;
    std::string setup_;
    bool holds_other_fits_ = false;
    std::map<std::string, Eigen::VectorXd> fits_;
    mutable std::mutex mutex_;
};

}  // namespace myo::diagnosis
