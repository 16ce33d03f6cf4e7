#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>

#include "measurement/recording_edit.hpp"
#include "measurement/trace_csv.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// The bundled beam in a folder of its own.
inline std::filesystem::path beam_in(const Folder& folder) {
    std::filesystem::copy(std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets/examples/silicone_beam",
                          folder.path() / "beam", std::filesystem::copy_options::recursive);
    return folder.path() / "beam";
}

inline const measurement::RigidMotion camera{
    Eigen::AngleAxisd(1.9, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()).toRotationMatrix(), {0.8, -0.2, 1.5}};

/// A trial of the beam as other cameras would have recorded it: still for 0.6 s, then the motion; other names, another
/// order, another frame.
inline std::filesystem::path take_of(const Folder& folder, const std::filesystem::path& trace) {
    measurement::Recording recording = *measurement::read_trace_csv(trace);
    const double step = 1.0 / recording.rate_Hz;
    const auto still = static_cast<Eigen::Index>(0.6 / step);
    const Eigen::Index first = (recording.time_s.array() < -1e-9).count();
    measurement::Recording take;
    take.rate_Hz = recording.rate_Hz;
    take.time_s = Eigen::VectorXd::LinSpaced(still + recording.sample_count() - first, 0.0,
                                             step * static_cast<double>(still + recording.sample_count() - first - 1));
    for (std::size_t i = recording.labels.size(); i-- > 0;) {
        take.labels.push_back("p" + std::to_string(take.labels.size()));
        Eigen::Matrix3Xd track(3, take.time_s.size());
        track.leftCols(still).colwise() = Eigen::Vector3d(recording.tracks[i].col(first));
        track.rightCols(recording.sample_count() - first) = recording.tracks[i].rightCols(recording.sample_count() -
                                                                                          first);
        // Cameras are never still.
        for (Eigen::Index t = 0; t < still; ++t)
            track.col(t) += 2e-5 * Eigen::Vector3d(std::sin(7.0 * static_cast<double>(t)),
                                                   std::sin(11.0 * static_cast<double>(t)),
                                                   std::cos(5.0 * static_cast<double>(t)));
        take.tracks.push_back(track);
    }
    take = measurement::transform(take, camera);
    const std::filesystem::path file = folder.path() / "take 7.csv";
    EXPECT_TRUE(measurement::write_trace_csv(file, take));
    return file;
}

}  // namespace myo::test
