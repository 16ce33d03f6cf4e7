#include "base/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

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

TEST_F(Files, AFileThatCannotBeWrittenWholeLeavesTheOldOneAndNothingElse) {
    const fs::path path = folder_ / "result.vtu";
    ASSERT_TRUE(write_file(path, "old"));
    // A disk that is full after eight bytes, as far as a process can make one.
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{8, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result<void> result = write_file(path, "too much for it");
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().text(), path.string() + ": cannot be written: File too large");
    EXPECT_EQ(read_file(path).value(), "old");
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(Files, LinksStayAndLeadToTheNewContent) {
    ASSERT_TRUE(write_file(folder_ / "target", "old"));
    fs::create_symlink("target", folder_ / "link");
    fs::create_symlink("link", folder_ / "link_of_link");
    ASSERT_TRUE(write_file(folder_ / "link_of_link", "new"));
    EXPECT_EQ(read_file(folder_ / "target").value(), "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link_of_link"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    fs::create_symlink("not there yet", folder_ / "early");
    ASSERT_TRUE(write_file(folder_ / "early", "made"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "early"));
    EXPECT_EQ(read_file(folder_ / "not there yet").value(), "made");
    EXPECT_EQ(files_in_folder(), 5);
    fs::create_symlink("loop", folder_ / "loop");
    EXPECT_FALSE(write_file(folder_ / "loop", "x"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "loop"));
}

TEST_F(Files, APipeIsWrittenInto) {
    fs::create_directories(folder_);
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = read_file(pipe).value(); });
    EXPECT_TRUE(write_file(pipe, "through it"));
    reader.join();
    EXPECT_EQ(read, "through it");
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(Files, ADeviceIsWrittenIntoAndSaysThatItIsFull) {
    fs::create_directories(folder_);
    // A link, lest a failing test replace the system's own.
    fs::create_symlink("/dev/full", folder_ / "full");
    const Result<void> full = write_file(folder_ / "full", "x");
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().what, "cannot be written: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(Files, StandardOutputIsWrittenIntoWhereItStands) {
    ASSERT_TRUE(write_file(folder_ / "out", "before\n"));
    const pid_t child = ::fork();
    if (child == 0) {
        const int out = ::open((folder_ / "out").c_str(), O_WRONLY | O_APPEND);
        ::dup2(out, STDOUT_FILENO);
        ::_exit(write_file("/dev/stdout", "one\n") && write_file(folder_ / "out", "two\n") ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read_file(folder_ / "out").value(), "before\none\ntwo\n");
}

TEST_F(Files, ReadingTellsWhatIsWrong) {
    EXPECT_EQ(read_file(folder_ / "none").error().what, "file not found");
    fs::create_directories(folder_);
    EXPECT_EQ(read_file(folder_).error().what, "is a folder, not a file");
}

TEST_F(Files, PlacesThatCannotBeWrittenAreErrors) {
    ASSERT_TRUE(write_file(folder_ / "file", "x"));
    EXPECT_FALSE(write_file(folder_ / "file" / "below.txt", "y"));  // a file where a folder should be
    fs::create_directories(folder_ / "taken" / "inside");
    EXPECT_FALSE(write_file(folder_ / "taken", "y"));  // a folder where the file should be
    EXPECT_EQ(files_in_folder(), 2);
}

}  // namespace
}  // namespace myo
