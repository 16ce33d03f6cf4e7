#include "commands/window_title.hpp"

namespace myo::ui::commands {

std::string window_title(const WorkbenchState& state) {
    const std::string program = "Myoloop";
    if (!state.scene) return program;
    const std::string open = state.project.empty() ? state.scene->name : state.project.stem().string();
    return (state.unsaved() ? "\xe2\x80\xa2 " : "") + open + " \xe2\x80\x93 " + program;
}

}  // namespace myo::ui::commands
