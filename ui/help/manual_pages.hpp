#pragma once

#include <array>
#include <string_view>

namespace myo::ui::help {

/// A page of the manual that the window shows.
struct ManualPage {
    const char* name;   // of its file in assets/manual, without the ending
    const char* title;  // in the list of pages
};
inline constexpr std::array<ManualPage, 8> manual_pages{{{"workbench", "Workbench"},
                                                         {"experiment", "Experiment folder"},
                                                         {"laws", "Laws of one's own"},
                                                         {"theory", "Theory"},
                                                         {"diagnosis", "Diagnosis"},
                                                         {"glossary", "Glossary"},
                                                         {"verification", "Verification"},
                                                         {"commands", "Command line"}}};

/// Markdown of a page, embedded when the program was built; empty if there is none of that name.
std::string_view manual_text(std::string_view name);

}  // namespace myo::ui::help
