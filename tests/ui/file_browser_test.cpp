#include <gtest/gtest.h>

#include "base/files.hpp"
#include "panels/file_browser.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;
using test::Folder;

/// The browser shows this folder.
void go_to(Driver& driver, const std::filesystem::path& folder) {
    driver.click("browser/path");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(folder.string());
    driver.key(ImGuiKey_Enter);
}

void type_name(Driver& driver, const std::string& name) {
    driver.click("browser/name");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(name);
}

TEST(FileName, GetsTheEndingThatItLacks) {
    EXPECT_EQ(panels::with_ending("arm", {".myoloop"}), "arm.myoloop");
    EXPECT_EQ(panels::with_ending("arm.v2", {".myoloop"}), "arm.v2.myoloop");
    EXPECT_EQ(panels::with_ending("arm.myoloop", {".myoloop"}), "arm.myoloop");
    EXPECT_EQ(panels::with_ending("a.tsv", {".csv", ".tsv"}), "a.tsv");
    EXPECT_EQ(panels::with_ending("frames", {}), "frames");
    EXPECT_EQ(panels::with_ending("", {".png"}), "");
}

TEST(FileBrowser, AsksBeforeAFileIsReplacedWhoseEndingWasNotTyped) {
    const Folder folder("replace");
    folder.write("arm.myoloop", "of somebody else");
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_s, {.ctrl = true});
    go_to(driver, folder.path());
    EXPECT_FALSE(driver.has("browser/is_there"));
    type_name(driver, "arm");
    EXPECT_TRUE(driver.has("browser/is_there"));
    driver.key(ImGuiKey_Enter);
    EXPECT_TRUE(driver.backend->projects.empty()) << "Enter alone replaces nothing";
    ASSERT_TRUE(driver.has("browser/is_there"));
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.backend->projects.count(folder.path() / "arm.myoloop"), 1u);
    EXPECT_FALSE(driver.has("browser/name"));
}

TEST(FileBrowser, EnterSavesUnderTheTypedName) {
    const Folder folder("enter");
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_s, {.ctrl = true});
    go_to(driver, folder.path());
    type_name(driver, "swing");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().project, folder.path() / "swing.myoloop");
}

TEST(FileBrowser, TheNameCanBeTypedAtOnce) {
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_s, {.ctrl = true});
    driver.type("/nowhere/typed");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().project, "/nowhere/typed.myoloop");
}

TEST(FileBrowser, ATypedExperimentIsOpenedAndAMissingPathIsSaid) {
    const Folder folder("typed_experiment");
    folder.write("arm/experiment.toml", "");
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_o, {.ctrl = true});
    go_to(driver, folder.path() / "leg");
    EXPECT_TRUE(driver.has("browser/missing"));
    go_to(driver, folder.path() / "arm");
    EXPECT_FALSE(driver.has("browser/path")) << "the dialog is closed";
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.state().scene->path, folder.path() / "arm");
}

TEST(FileBrowser, MakesANewFolderToSaveIn) {
    const Folder folder("new_folder");
    folder.write("taken", "a file");
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_s, {.ctrl = true});
    go_to(driver, folder.path());
    driver.click("browser/new_folder");
    driver.type("taken");
    driver.key(ImGuiKey_Enter);
    ASSERT_TRUE(driver.has("browser/new_folder/name")) << "a file of this name is in the way";
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("monday");
    driver.click("browser/new_folder/make");
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "monday"));
    type_name(driver, "swing");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().project, folder.path() / "monday" / "swing.myoloop");
}

TEST(FileBrowser, AsksForAnotherNameWhereAFolderCannotBeMade) {
    const Folder folder("long_name");
    Driver driver;
    driver.open_beam();
    driver.key(ui::platform::key_s, {.ctrl = true});
    go_to(driver, folder.path());
    driver.click("browser/new_folder");
    driver.type(std::string(300, 'n'));
    ASSERT_NO_THROW(driver.key(ImGuiKey_Enter));
    ASSERT_TRUE(driver.has("browser/new_folder/name")) << "no file system takes a name of 300 characters";
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("monday");
    driver.key(ImGuiKey_Enter);
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "monday"));
    EXPECT_FALSE(driver.has("browser/new_folder/name"));
}

TEST(FileBrowser, EnterOpensWhatIsSelected) {
    const Folder folder("enter_opens");
    folder.write("beam/experiment.toml", "");
    Driver driver;
    driver.key(ui::platform::key_o, {.ctrl = true});
    EXPECT_FALSE(driver.has("browser/new_folder"));
    go_to(driver, folder.path());
    driver.click("browser/entry/beam");
    driver.key(ImGuiKey_Enter);
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().scene);
    EXPECT_EQ(driver.state().scene->path, folder.path() / "beam");
}

}  // namespace
}  // namespace myo::ui
