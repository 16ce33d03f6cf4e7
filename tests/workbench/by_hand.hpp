#pragma once

#include <filesystem>
#include <string>

#include "ui/driver.hpp"

// What a person does with several widgets in a row.

namespace myo::test {

/// Replaces the text of a field.
inline void type_into(Driver& driver, const std::string& item, const std::string& text, bool enter = true) {
    driver.double_click(item);
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(text);
    if (enter) driver.key(ImGuiKey_Enter);
    driver.settle();
}

/// In the dialog that is open: goes to the folder of a file by typing where it is, and chooses the file.
inline void choose_file(Driver& driver, const std::filesystem::path& path) {
    type_into(driver, "browser/path", path.parent_path().string());
    driver.click("browser/entry/" + path.filename().string());
    driver.click("browser/open");
}

}  // namespace myo::test
