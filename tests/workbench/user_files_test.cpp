#include "backend/user_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>

#include "backend/project_masks.hpp"
#include "support/folder.hpp"

// Places of the user's own files, and what they hold however they came about.

namespace myo::backend::user_files_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

/// A variable of the environment for the lifetime of the object; null: unset.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    void set(const char* value) const { value != nullptr ? ::setenv(name_, value, 1) : ::unsetenv(name_); }
    const char* name_;
    std::optional<std::string> before_;
};

TEST(UserFiles, StandInTheFoldersThatTheSystemNames) {
    {
        const Variable config("XDG_CONFIG_HOME", "/conf"), state("XDG_STATE_HOME", "/state"), home("HOME", "/user");
        EXPECT_EQ(preferences_file(), fs::path("/conf/myoloop/preferences.toml"));
        EXPECT_EQ(recovery_file().parent_path(), fs::path("/state/myoloop"));
    }
    // A variable that is set to nothing counts as unset.
    for (const char* const unset : {static_cast<const char*>(nullptr), ""}) {
        const Variable config("XDG_CONFIG_HOME", unset), state("XDG_STATE_HOME", unset), home("HOME", "/user");
        EXPECT_EQ(preferences_file(), fs::path("/user/.config/myoloop/preferences.toml"));
        EXPECT_EQ(recovery_file().parent_path(), fs::path("/user/.local/state/myoloop"));
        const Variable homeless("HOME", unset);
        EXPECT_TRUE(preferences_file().empty());
        EXPECT_TRUE(recovery_file().empty());
    }
}

TEST(UserFiles, TheFileForRecoveryIsOfThisProcessAndStays) {
    const Variable state("XDG_STATE_HOME", "/state");
    const std::string name = recovery_file().filename().string();
    EXPECT_EQ(name, recovery_file().filename().string());
    EXPECT_THAT(name, testing::StartsWith("unsaved-" + std::to_string(::getpid()) + "-"));
    EXPECT_EQ(fs::path(name).extension(), ".myoloop");
}

/// File names are bytes: those that no text can hold are not kept, and the others come back.
TEST(UserFiles, PathsThatAFileCannotHoldAreLeftOut) {
    const test::Folder folder("odd_paths");
    const fs::path file = folder.path() / "preferences.toml";
    ui::commands::Preferences p;
    p.theme = ui::platform::ThemeName::light;
    p.bookmarks = {"/a/it's", "/a/line\nbreak", "/a/latin \xe9", "/a/bell\a", "/a/tab\tand \"quotes\" \\", "/a/grün"};
    ASSERT_TRUE(write_preferences(file, p));
    const Result<ui::commands::Preferences> read = read_preferences(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->theme, ui::platform::ThemeName::light);
    EXPECT_THAT(read->bookmarks, ElementsAre(fs::path("/a/tab\tand \"quotes\" \\"), fs::path("/a/grün")));
}

TEST(UserFiles, ValuesOutOfRangeAndUnknownKeysAreToldWithTheirLine) {
    const test::Folder folder("wrong_preferences");
    struct Wrong {
        const char *text, *told;
    };
    for (const Wrong& wrong :
         {Wrong{"theme = 'dark'\nscale = 2.6\n", ":2: scale"}, Wrong{"scale = -0.1\n", ":1: scale"},
          Wrong{"side_width = 99\n", ":1: side_width"}, Wrong{"strip_height = 4001\n", ":1: strip_height"},
          Wrong{"recent = ['a', 3]\n", ":1: recent"}, Wrong{"colour = 'red'\n", ":1: colour: unknown key"},
          Wrong{"[[step_cost]]\nelement = 'hex9'\ndofs = 10\nseconds = 1\n", "element"},
          Wrong{"[[step_cost]]\nelement = 'hex8'\ndofs = 0\nseconds = 1\n", "dofs"}, Wrong{"theme = \n", ""}}) {
        folder.write("preferences.toml", wrong.text);
        const Result<ui::commands::Preferences> read = read_preferences(folder.path() / "preferences.toml");
        ASSERT_FALSE(read) << wrong.text;
        EXPECT_THAT(read.error().text(), HasSubstr(wrong.told));
    }
    for (const char* fine : {"", "scale = 0\n", "scale = 2.5\n", "side_width = 100\nstrip_height = 4000\n"}) {
        folder.write("preferences.toml", fine);
        EXPECT_TRUE(read_preferences(folder.path() / "preferences.toml")) << fine;
    }
}

/// Sets the time of a file to the minute of a local date.
void set_time(const fs::path& file, int year, int month, int day, int hour, int minute) {
    std::tm local{};
    local.tm_year = year - 1900, local.tm_mon = month - 1, local.tm_mday = day;
    local.tm_hour = hour, local.tm_min = minute, local.tm_isdst = -1;
    const std::time_t at = std::mktime(&local);
    const std::array<::timespec, 2> times{::timespec{at, 0}, ::timespec{at, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times.data(), 0), 0);
}

TEST(UserFiles, UnsavedWorkIsNamedByWhatItBelongsTo) {
    const test::Folder folder("unsaved_words");
    const auto words = [&](const std::string& text) {
        folder.write("unsaved-1.myoloop", text);
        set_time(folder.path() / "unsaved-1.myoloop", 2025, 11, 29, 14, 5);
        return unsaved_work_words(folder.path() / "unsaved-1.myoloop");
    };
    EXPECT_EQ(words("copy_of = '/user/finger.myoloop'\nsource = '/data/beam/experiment.toml'\n"),
              "finger.myoloop, 29 Nov 2025, 14:05");
    EXPECT_EQ(words("source = '/data/beam/experiment.toml'\n"), "beam, 29 Nov 2025, 14:05");
    EXPECT_EQ(words("source = '/data/body.stl'\n"), "body.stl, 29 Nov 2025, 14:05");
    EXPECT_EQ(words("theme = 'dark'\n"), "without a name, 29 Nov 2025, 14:05");
    EXPECT_EQ(words("half = "), "without a name, 29 Nov 2025, 14:05");
    folder.write("unsaved-2.myoloop", "source = 'a.stl'\n");
    set_time(folder.path() / "unsaved-2.myoloop", 2026, 3, 5, 7, 0);
    EXPECT_EQ(unsaved_work_words(folder.path() / "unsaved-2.myoloop"), "a.stl, 5 Mar 2026, 07:00");
    EXPECT_EQ(unsaved_work_words(folder.path() / "absent.myoloop"), "without a name");
}

TEST(UserFiles, UnsavedWorkIsFoundOldestFirst) {
    const test::Folder folder("unsaved_order");
    for (const auto& [name, day] : {std::pair{"unsaved-999999991.myoloop", 3},
                                    {"unsaved-999999992.myoloop", 1},
                                    {"unsaved-999999993-5.myoloop", 2},
                                    {"unsaved-999999994.txt", 1}}) {
        folder.write(name, "");
        set_time(folder.path() / name, 2025, 5, day, 12, 0);
    }
    std::vector<std::string> names;
    for (const fs::path& file : found_recoveries(folder.path())) names.push_back(file.filename().string());
    EXPECT_THAT(names,
                ElementsAre("unsaved-999999992.myoloop", "unsaved-999999993-5.myoloop", "unsaved-999999991.myoloop"));
}

fibre::PaintedMask mask_of(double weight) {
    fibre::PaintedMask mask;
    mask.cell_size_m = 0.01;
    mask.centroids_m = Eigen::Matrix3Xd::Constant(3, 2, 0.5);
    mask.weights = Eigen::Vector2d(1.0, weight);
    mask.directions = Eigen::Matrix3Xd::Zero(3, 2);
    return mask;
}

TEST(ProjectMasks, NamesFollowTheContentAndSuitAFile) {
    const std::string name = mask_name("left/upper ä", mask_of(0.5));
    EXPECT_THAT(name, testing::MatchesRegex("left_upper_+-[0-9a-f]+\\.csv"));
    EXPECT_EQ(name, mask_name("left/upper ä", mask_of(0.5)));
    EXPECT_NE(name, mask_name("left/upper ä", mask_of(0.25)));
    EXPECT_EQ(name.size(), std::string("left_upper_").size() + 2 + std::string("-0123456789abcdef.csv").size());
}

TEST(ProjectMasks, OnlyMasksOfTheProjectsOwnFolderAreItsOwn) {
    const test::Folder folder("masks_named");
    const std::string own = mask_name("left", mask_of(0.5)), other = mask_name("right", mask_of(0.5));
    folder.write("finger.myoloop", "[[muscle]]\nmask = 'finger.files/" + own + "'\n[[muscle]]\nmask = 'elsewhere/" +
                                       other +
                                       "'\n[[muscle]]\nmask = 'finger.files/mine.csv'\n[[muscle]]\nname = 'x'\n");
    const fs::path file = folder.path() / "finger.myoloop", files = folder.path() / "finger.files";
    EXPECT_THAT(named_masks(file, files), ElementsAre(own));
    EXPECT_THAT(named_masks(folder.path() / "absent.myoloop", files), IsEmpty());
    // A backup beside it may need the mask, also one that is no valid file; the project itself does not count.
    EXPECT_FALSE(is_named_beside(file, own));
    folder.write("notes.txt", own);
    EXPECT_FALSE(is_named_beside(file, own));
    folder.write("finger.myoloop~", "half = " + own);
    EXPECT_TRUE(is_named_beside(file, own));
    EXPECT_FALSE(is_named_beside(file, "left-0000000000000000.csv"));
}

}  // namespace
}  // namespace myo::backend::user_files_test
