#include "measurement/c3d_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "c3d_writer.hpp"
#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::c3d_file;
using test::C3dOptions;
using test::Processor;
using test::TemporaryFile;
using testing::HasSubstr;

Result<Recording> read_bytes(const std::string& bytes, std::optional<double> unit = std::nullopt) {
    const TemporaryFile file(bytes, "recording.c3d");
    return read_c3d(file.path(), unit);
}

class C3dFormats : public testing::TestWithParam<std::tuple<Processor, bool, int>> {};

TEST_P(C3dFormats, RoundTripKeepsPositionsGapsLabelsAndResiduals) {
    const auto [processor, real, analog] = GetParam();
    const Recording original = test::random_recording(7, 40, 1, true);
    C3dOptions options;
    options.processor = processor;
    options.real = real;
    options.analog_channels = analog;
    options.analog_per_frame = 4;
    const Result<Recording> read = read_bytes(c3d_file(original, options));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, original.labels);
    EXPECT_DOUBLE_EQ(read->rate_Hz, 100.0);
    EXPECT_NEAR(read->time_s(39), 0.39, 1e-12);
    // Half a step of the integers, or the 24 digits of a float.
    EXPECT_LT(test::largest_difference(original, *read), real ? 3.1e-8 : 0.5001e-4);
    ASSERT_EQ(read->residual_m.size(), 7U);
    EXPECT_NEAR(read->residual_m[0](0), 5e-4, 1e-10);
    EXPECT_TRUE(std::isnan(read->residual_m[0](1)));
}

INSTANTIATE_TEST_SUITE_P(AllWords, C3dFormats,
                         testing::Combine(testing::Values(Processor::intel, Processor::dec, Processor::sgi),
                                          testing::Bool(), testing::Values(-1, 0, 6)));

TEST(C3d, UnitsComeFromTheFile) {
    const Recording original = test::random_recording(2, 10, 2);
    for (const auto& [name, per_metre] :
         std::vector<std::pair<std::string, double>>{{"mm", 1e3}, {"cm", 1e2}, {"m", 1.0}, {"IN", 1.0 / 0.0254}}) {
        C3dOptions options;
        options.units = name;
        options.units_per_metre = per_metre;
        const Result<Recording> read = read_bytes(c3d_file(original, options));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_LT(test::largest_difference(original, *read), 1e-7) << name;
    }
}

TEST(C3d, MissingOrUnknownUnitIsAskedFor) {
    const Recording original = test::random_recording(2, 10, 3);
    C3dOptions options;
    options.units = "";
    EXPECT_THAT(read_bytes(c3d_file(original, options)).error().text(), HasSubstr("POINT:UNITS is missing"));
    const Result<Recording> told = read_bytes(c3d_file(original, options), 1e-3);
    ASSERT_TRUE(told);
    EXPECT_NEAR(told->tracks[0](0, 0), 1e-3 * original.tracks[0](0, 0), 1e-10);
    options.units = "ell";
    EXPECT_THAT(read_bytes(c3d_file(original, options)).error().text(), HasSubstr("'ell'"));
}

TEST(C3d, LabelsFallBackToNumbersAndStayUnique) {
    Recording original = test::random_recording(3, 5, 4);
    C3dOptions options;
    options.labels = false;
    EXPECT_EQ(read_bytes(c3d_file(original, options))->labels,
              (std::vector<std::string>{"point 1", "point 2", "point 3"}));
    original.labels = {"  left  ", "left", ""};
    EXPECT_EQ(read_bytes(c3d_file(original))->labels, (std::vector<std::string>{"left", "left (2)", "point 3"}));
    original.labels = {"Gr\xFC\xDF", "b", "c"};  // Latin-1 becomes UTF-8
    EXPECT_EQ(read_bytes(c3d_file(original))->labels[0], "Gr\xC3\xBC\xC3\x9F");
}

TEST(C3d, MoreThan255PointsHaveTheirLabelsInSeveralParameters) {
    const Recording original = test::random_recording(600, 3, 5);
    const Result<Recording> read = read_bytes(c3d_file(original));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, original.labels);
    EXPECT_LT(test::largest_difference(original, *read), 1e-7);
}

TEST(C3d, LongRecordingsByEveryConvention) {
    Recording original = test::random_recording(1, 70000, 6);
    for (const char* convention : {"FRAMES real", "LONG_FRAMES", "TRIAL"}) {
        C3dOptions options;
        options.frames_as = convention;
        const Result<Recording> read = read_bytes(c3d_file(original, options));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->sample_count(), 70000) << convention;
        EXPECT_LT(test::largest_difference(original, *read), 1e-7);
    }
    original = test::random_recording(1, 40000, 6);  // above 32767: words are unsigned
    for (const char* convention : {"FRAMES", "header"}) {
        C3dOptions options;
        options.frames_as = convention;
        EXPECT_EQ(read_bytes(c3d_file(original, options))->sample_count(), 40000) << convention;
    }
}

TEST(C3d, SectionsAreFoundByTheirPointersAndGroupsInAnyOrder) {
    const Recording original = test::random_recording(4, 20, 7, true);
    C3dOptions options;
    options.parameter_block = 4;
    options.spare_blocks = 3;
    options.groups_last = true;
    options.header_rate_only = true;
    const Result<Recording> read = read_bytes(c3d_file(original, options));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LT(test::largest_difference(original, *read), 1e-7);
    EXPECT_DOUBLE_EQ(read->rate_Hz, 100.0);
}

TEST(C3d, OccludedSamplesAreNaNHoweverTheyAreWritten) {
    Recording original = test::random_recording(2, 10, 8, true);
    for (const bool real : {true, false}) {
        for (const double word : {-1.0, -16512.0, 0.0}) {  // 0: zeros all through, as some programs fill gaps
            C3dOptions options;
            options.real = real;
            options.occluded_word = word;
            EXPECT_LT(test::largest_difference(original, *read_bytes(c3d_file(original, options))), 1e-4) << word;
        }
    }
    // A marker that was measured at the origin has a residual and stays; one beside it may have none.
    original.tracks[0].col(0).setZero();
    EXPECT_TRUE(read_bytes(c3d_file(original))->tracks[0].col(0).isZero(0.0));
    C3dOptions computed;
    computed.residual_steps = 0;
    const Result<Recording> read = read_bytes(c3d_file(original, computed));
    EXPECT_TRUE(read->tracks[0].col(0).array().isNaN().all());
    EXPECT_TRUE(read->tracks[1].col(0).allFinite());
}

TEST(C3d, ErrorsSayWhatIsWrongInOneSentence) {
    const Recording original = test::random_recording(3, 100, 9);
    const std::string good = c3d_file(original);
    EXPECT_THAT(read_bytes("").error().text(), HasSubstr("0 bytes are too few"));
    EXPECT_THAT(read_bytes(good.substr(0, 300)).error().text(), HasSubstr("300 bytes are too few"));
    EXPECT_THAT(read_bytes(good.substr(0, 514)).error().text(),
                HasSubstr("the parameter section should start at byte 512"));
    EXPECT_THAT(read_bytes(good.substr(0, good.size() - 1024)).error().text(),
                HasSubstr("100 frames of 3 points from byte 1024 need"));
    std::string bad = good;
    bad[1] = 'x';
    EXPECT_THAT(read_bytes(bad).error().text(), HasSubstr("is no C3D file"));
    bad = good;
    bad[515] = 83;
    EXPECT_THAT(read_bytes(bad).error().text(), HasSubstr("unknown processor code 83 at byte 515"));
    Recording far = original;
    far.tracks[1](2, 7) = 3e7;
    EXPECT_THAT(read_bytes(c3d_file(far)).error().text(), HasSubstr("'marker 2' is more than 10 km away in frame 8"));
    EXPECT_THAT(read_c3d("does/not/exist.c3d").error().text(), HasSubstr("not found"));
    Recording empty = original;
    empty.labels.clear();
    empty.tracks.clear();
    EXPECT_THAT(read_bytes(c3d_file(empty)).error().text(), HasSubstr("no 3D points"));
}

TEST(C3d, UnitsCutShortAreLeftToTheKey) {
    const Recording original = test::random_recording(2, 10, 3);
    C3dOptions options;
    options.units = "METERS";  // the parameter holds four characters
    const std::string refused = read_bytes(c3d_file(original, options)).error().text();
    EXPECT_THAT(refused, HasSubstr("POINT:UNITS is 'METE'"));
    EXPECT_THAT(refused, HasSubstr("the trial's key unit"));
    EXPECT_LT(test::largest_difference(original, *read_bytes(c3d_file(original, options), 1.0)), 1e-7);
    options.units = "mm";
    EXPECT_THAT(read_bytes(c3d_file(original, options), 1.0).error().text(), HasSubstr("says m, but POINT:UNITS"));
}

/// A count above that of the header is right only if the file holds so many frames.
TEST(C3d, AFrameCountAboveHeaderAndFileIsReadWithAWarning) {
    for (const int samples : {20, 100})  // with room for a frame more in the last block, and without
        for (const int points : {2, 32}) {
            const Recording original = test::random_recording(points, samples, 13);
            C3dOptions options;
            options.more_frames = 1;
            const Result<Recording> read = read_bytes(c3d_file(original, options));
            ASSERT_TRUE(read) << read.error().text();
            EXPECT_LT(test::largest_difference(original, *read), 1e-7);
            ASSERT_EQ(read->warnings.size(), 1u);
            EXPECT_THAT(read->warnings[0], HasSubstr("POINT:FRAMES says " + std::to_string(samples + 1)));
        }
    const Recording original = test::random_recording(2, 20, 13);
    EXPECT_TRUE(read_bytes(c3d_file(original))->warnings.empty());
    std::string short_header = c3d_file(original);
    short_header[8] = 19;  // the header's last frame
    const Result<Recording> whole = read_bytes(short_header);
    ASSERT_TRUE(whole) << whole.error().text();
    EXPECT_EQ(whole->sample_count(), 20) << "the file holds what POINT:FRAMES says";
}

TEST(C3d, ParametersEndWithTheirBlocks) {
    for (const int spare : {0, 2})
        for (const bool groups_last : {false, true}) {
            const Recording original = test::random_recording(4, 20, 14);
            C3dOptions options;
            options.end_mark = false;
            options.spare_blocks = spare;
            options.groups_last = groups_last;
            const Result<Recording> read = read_bytes(c3d_file(original, options));
            ASSERT_TRUE(read) << read.error().text();
            EXPECT_EQ(read->labels, original.labels);
            EXPECT_LT(test::largest_difference(original, *read), 1e-7);
        }
}

TEST(C3d, OutputsOfAModelAreNoMarkers) {
    Recording original = test::random_recording(5, 20, 15);
    original.tracks[3] *= 1e6;  // newton-millimetres are no positions
    C3dOptions options;
    options.angles = {"marker 2"};
    options.own_outputs = {"marker 4"};
    const Result<Recording> read = read_bytes(c3d_file(original, options));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, (std::vector<std::string>{"marker 1", "marker 3", "marker 5"}));
    EXPECT_EQ(read->residual_m.size(), 3u);
    EXPECT_LT((read->tracks[1] - original.tracks[2]).cwiseAbs().maxCoeff(), 1e-7);
    options.angles = original.labels;
    EXPECT_THAT(read_bytes(c3d_file(original, options)).error().text(), HasSubstr("outputs of a model only"));
}

// Every error is one line and names the file; every value is finite or a whole gap.
void expect_sane(const Result<Recording>& read) {
    if (!read) {
        EXPECT_THAT(read.error().text(), HasSubstr("recording.c3d: "));
        EXPECT_EQ(read.error().text().find('\n'), std::string::npos);
        return;
    }
    EXPECT_TRUE(read->time_s.allFinite());
    for (const Eigen::Matrix3Xd& track : read->tracks) {
        for (Eigen::Index t = 0; t < track.cols(); ++t) {
            EXPECT_TRUE(track.col(t).allFinite() || track.col(t).array().isNaN().all());
        }
    }
}

TEST(C3d, TruncatedAndGarbledFilesNeverCrash) {
    std::mt19937 generator(10);
    int errors = 0;
    for (int round = 0; round < 3000; ++round) {
        C3dOptions options;
        options.processor = static_cast<Processor>(84 + round % 3);
        options.real = round % 2 == 0;
        options.analog_channels = round % 5 - 1;
        std::string bytes = c3d_file(test::random_recording(3, 12, 11, true), options);
        if (round % 4 == 0) {
            bytes.resize(std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(generator));
        } else {
            // Mostly where the structure stands: the header and the parameters.
            const std::size_t reach = round % 4 == 1 ? bytes.size() : 1024;
            for (int flips = 1 + round % 7; flips > 0; --flips) {
                const auto at = std::uniform_int_distribution<std::size_t>(0, reach - 1)(generator);
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << std::uniform_int_distribution<int>(0, 7)(generator)));
            }
        }
        const Result<Recording> read = read_bytes(bytes);
        expect_sane(read);
        errors += read ? 0 : 1;
    }
    EXPECT_GT(errors, 700);  // every truncation at the least
}

TEST(C3d, NoiseBehindAValidMarkNeverCrashes) {
    std::mt19937 generator(12);
    std::uniform_int_distribution<int> any(0, 255);
    for (int round = 0; round < 1000; ++round) {
        std::string bytes(2048, '\0');
        for (char& c : bytes) c = static_cast<char>(any(generator));
        bytes[0] = 2;
        bytes[1] = 0x50;
        bytes[515] = static_cast<char>(84 + round % 3);
        expect_sane(read_bytes(bytes));
    }
}

}  // namespace
}  // namespace myo::measurement
