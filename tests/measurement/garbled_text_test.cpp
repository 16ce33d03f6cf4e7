// Exports with a few bytes changed, cut or doubled: an error of one line that names the file, or a recording.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "measurement/test_files.hpp"
#include "measurement/trace_file.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

const std::vector<std::string> whole_exports{
    "Format Version,1.23,Export Frame Rate,100,Length Units,Meters\n\n,Type,Marker,Marker,Marker\n,Name,a:b,a:b,a:b\n"
    ",ID,1,1,1\n,,Position,Position,Position\nFrame,Time (Seconds),X,Y,Z\n0,0,1,2,3\n1,0.01,,,\n2,0.02,1,2,3\n",
    "Devices\n10\n\nTrajectories\n100\n,,a:b,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n2,0,,,\n3,0,1,2,3\n",
    "PathFileType\t4\nDataRate\tNumFrames\tNumMarkers\tUnits\n100\t3\t1\tmm\nFrame#\tTime\ta\t\t\n\t\tX1\tY1\tZ1\n"
    "1\t0\t1\t2\t3\n2\t0.01\t\t\t\n3\t0.02\t1\t2\t3\n",
    "time_s;a_x_m;a_y_m;a_z_m\n0;0,5;1;2\n0,01;nan;;\n0,02;0,5;1;2\n"};

/// One random change of the text.
void garble(std::string& text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    if (text.empty()) return;
    const std::size_t at = below(text.size()), length = std::min(text.size() - at, 1 + below(12));
    switch (below(4)) {
        case 0: text[at] = ",;\t\n0x-. \"\0"[below(11)]; break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(at, text.substr(at, length)); break;
        default: text.resize(at); break;
    }
}

TEST(GarbledText, GivesAnErrorOrARecording) {
    std::mt19937 random(1);
    int errors = 0, recordings = 0;
    for (const std::string& whole : whole_exports)
        for (int round = 0; round < 120; ++round) {
            std::string text = whole;
            for (int change = round % 3; change >= 0; --change) garble(text, random);
            const TemporaryFile file(text, "garbled.csv");
            for (const char* const format : {"motive_csv", "vicon_csv", "trc", "csv"}) {
                const Result<Recording> read = read_trace(file.path(), {.format = format});
                if (!read) {
                    ++errors;
                    EXPECT_THAT(read.error().text(), HasSubstr("garbled.csv"));
                    EXPECT_EQ(read.error().text().find('\n'), std::string::npos);
                    continue;
                }
                ++recordings;
                EXPECT_TRUE(read->time_s.allFinite());
                for (const Eigen::Matrix3Xd& track : read->tracks)
                    for (Eigen::Index t = 0; t < track.cols(); ++t)
                        EXPECT_TRUE(track.col(t).allFinite() || track.col(t).array().isNaN().all());
            }
        }
    EXPECT_GT(errors, 1440) << "each text has one format of four";
    EXPECT_GT(recordings, 25);
}

}  // namespace
}  // namespace myo::measurement
