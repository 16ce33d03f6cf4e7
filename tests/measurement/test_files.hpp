#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>

#include "measurement/recording.hpp"

namespace myo::test {

/// A file in a folder of its own that is removed with the object.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& content, const std::string& name = "recording.dat") {
        static int count = 0;
        folder_ = std::filesystem::temp_directory_path() /
                  ("myo_measurement_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
        path_ = folder_ / name;
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~TemporaryFile() {
        std::error_code code;
        std::filesystem::remove_all(folder_, code);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};

/// What a reader says of a file with this content.
template <class Read>
std::string error_of_reading(const Read& read, const std::string& content, const std::string& name) {
    const auto result = read(TemporaryFile(content, name).path());
    return result ? "no error" : result.error().text();
}

/// A recording of normal numbers around places up to half a metre away, with a gap in every marker when asked.
inline measurement::Recording random_recording(int markers, int samples, unsigned seed, bool gaps = false) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(-0.5, 0.5);
    measurement::Recording recording;
    recording.rate_Hz = 100.0;
    recording.time_s = Eigen::VectorXd::LinSpaced(samples, 0.0, (samples - 1) / 100.0);
    for (int i = 0; i < markers; ++i) {
        recording.labels.push_back("marker " + std::to_string(i + 1));
        recording.tracks.emplace_back(Eigen::Matrix3Xd(3, samples).unaryExpr([&](double) { return place(generator); }));
        if (gaps && samples > 4) {
            recording.tracks.back()
                .middleCols(1 + i % (samples - 3), 2)
                .setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    }
    return recording;
}

/// Largest difference of positions; infinite when gaps or sizes differ.
inline double largest_difference(const measurement::Recording& a, const measurement::Recording& b) {
    const double infinite = std::numeric_limits<double>::infinity();
    if (a.labels.size() != b.labels.size() || a.sample_count() != b.sample_count()) return infinite;
    double largest = 0.0;
    for (std::size_t i = 0; i < a.tracks.size(); ++i) {
        for (Eigen::Index t = 0; t < a.sample_count(); ++t) {
            const bool seen = a.tracks[i].col(t).allFinite();
            if (seen != b.tracks[i].col(t).allFinite()) return infinite;
            if (seen)
                largest = std::max(largest, (a.tracks[i].col(t) - b.tracks[i].col(t)).cwiseAbs().maxCoeff());
            else if (!b.tracks[i].col(t).array().isNaN().all())
                return infinite;
        }
    }
    return largest;
}

}  // namespace myo::test
