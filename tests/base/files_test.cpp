#include "base/files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace myo {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, with a blank in its name.
class Files : public testing::Test {
protected:
    const fs::path folder_ = fs::temp_directory_path() / ("myoloop files " + std::to_string(::getpid())) /
                             testing::UnitTest::GetInstance()->current_test_info()->name();
    void TearDown() override { fs::remove_all(folder_.parent_path()); }
    int files_in_folder() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
        return count;
    }
};

TEST_F(Files, RoundTripKeepsEveryByte) {
    std::string content;
    for (int i = 0; i < 3000; ++i) content.push_back(static_cast<char>(i % 256));
    ASSERT_TRUE(write_file(folder_ / "new" / "deep" / "x.bin", content));
    EXPECT_EQ(read_file(folder_ / "new" / "deep" / "x.bin").value(), content);
    ASSERT_TRUE(write_file(folder_ / "new" / "deep" / "x.bin", ""));
    EXPECT_EQ(read_file(folder_ / "new" / "deep" / "x.bin").value(), "");
}

TEST_F(Files, AFailingWriterLeavesTheOldFileAndNothingElse) {
    const fs::path path = folder_ / "result.vtu";
    ASSERT_TRUE(write_file(path, "old"));
    fs::path temporary;
    const Result<void> result = write_file_with(path, [&](const fs::path& given) {
        temporary = given;
        std::ofstream(given) << "half a fi";
        EXPECT_EQ(read_file(path).value(), "old");   // a reader meanwhile
        return false;
    });
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().text().find("result.vtu"), std::string::npos);
    EXPECT_EQ(temporary.extension(), ".vtu");        // VTK chooses the format by it
    EXPECT_NE(temporary, path);
    EXPECT_EQ(read_file(path).value(), "old");
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(Files, AWriterThatWritesNothingIsAnError) {
    EXPECT_FALSE(write_file_with(folder_ / "x.csv", [](const fs::path&) { return true; }));
    EXPECT_FALSE(fs::exists(folder_ / "x.csv"));
}

TEST_F(Files, ReadingTellsWhatIsWrong) {
    EXPECT_EQ(read_file(folder_ / "none").error().what, "file not found");
    fs::create_directories(folder_);
    EXPECT_EQ(read_file(folder_).error().what, "is a folder, not a file");
}

TEST_F(Files, PlacesThatCannotBeWrittenAreErrors) {
    ASSERT_TRUE(write_file(folder_ / "file", "x"));
    EXPECT_FALSE(write_file(folder_ / "file" / "below.txt", "y"));   // a file where a folder should be
    fs::create_directories(folder_ / "taken" / "inside");
    EXPECT_FALSE(write_file(folder_ / "taken", "y"));                // a folder where the file should be
    EXPECT_EQ(files_in_folder(), 2);
}

}  // namespace
}  // namespace myo
