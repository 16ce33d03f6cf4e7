#include "base/overwrites.hpp"

#include <gtest/gtest.h>

#include "support/folder.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;

TEST(Overwrites, AnInputIsRefusedHoweverItIsSpelled) {
    const test::Folder folder("overwrites");
    folder.write("exp/drop.csv", "1");
    folder.write("other.csv", "1");
    fs::create_symlink("exp/drop.csv", folder.path() / "link.csv");
    fs::create_directory_symlink("exp", folder.path() / "linked");
    const std::vector<fs::path> inputs{folder.path() / "not there", folder.path() / "exp/drop.csv"};
    for (const char* const output : {"exp/drop.csv", "exp/../exp/drop.csv", "link.csv", "linked/drop.csv"}) {
        const Result<void> checked = check_overwrites("--json", {folder.path() / "new", folder.path() / output},
                                                      inputs);
        ASSERT_FALSE(checked) << output;
        EXPECT_EQ(checked.error().text(), "--json: " + folder.str(output) +
                                              " is read as input and would be replaced; choose another file or folder");
    }
    EXPECT_TRUE(check_overwrites("--json", {folder.path() / "other.csv", folder.path() / "new", folder.path() / "exp"},
                                 inputs));
}

TEST(Overwrites, ADeviceMayBeReadAndWritten) { EXPECT_TRUE(check_overwrites("--json", {"/dev/null"}, {"/dev/null"})); }

}  // namespace
}  // namespace myo
