#include <algorithm>
#include <cmath>

#include "commands/workbench.hpp"

// What is shown: trial, marker, time, view, preferences, messages.

namespace myo::ui::commands {

void Workbench::choose_trial(int trial) {
    // A model that plays live belongs to one trial.
    if (trial != state_.trial) stop_live();
    const int count = state_.scene ? static_cast<int>(state_.scene->trials.size()) : 0;
    state_.trial = std::clamp(trial, 0, std::max(0, count - 1));
    // Each trial starts at t = 0, if it contains it.
    const auto span = time_span(state_);
    state_.time_s = std::clamp(0.0, span[0], span[1]);
    state_.playing = false;
    stop_preview();
    want_preview();
}

void Workbench::on(const ChooseTrial& c) { choose_trial(c.trial); }

void Workbench::on(const ChooseMarker& c) {
    const int count = state_.scene ? static_cast<int>(state_.scene->markers.size()) : 0;
    state_.marker = std::clamp(c.marker, 0, std::max(0, count - 1));
}

void Workbench::on(const SetTime& c) {
    const auto span = time_span(state_);
    if (std::isfinite(c.time_s)) state_.time_s = std::clamp(c.time_s, span[0], span[1]);
}

void Workbench::on(const Play& c) {
    if (c.playing) stop_live();
    const auto span = time_span(state_);
    state_.playing = c.playing && span[1] > span[0];
    // Playing at the end starts again from the beginning.
    if (state_.playing && state_.time_s >= span[1]) state_.time_s = span[0];
}

void Workbench::on(const SetSpeed& c) { state_.speed = std::clamp(c.speed, 0.01, 10.0); }

void Workbench::on(const ChangeView& c) { state_.view = c.view; }

void Workbench::on(const SetTheme& c) {
    state_.preferences.theme = c.theme;
    state_.preferences.scale = std::clamp(c.scale, min_scale, greatest_scale);
}

void Workbench::on(const SetLayout& c) { state_.preferences.layout = c.layout; }

void Workbench::on(const Bookmark& c) {
    auto& kept = state_.preferences.bookmarks;
    std::erase(kept, c.folder);
    if (c.kept) kept.push_back(c.folder);
}

void Workbench::on(const UsePreferences& c) {
    state_.preferences = c.preferences;
    // 0 stays: the screen suggests the scale then.
    if (c.preferences.scale > 0.0f)
        state_.preferences.scale = std::clamp(c.preferences.scale, min_scale, greatest_scale);
}

void Workbench::on(const ClearLog&) { state_.log.clear(); }

void Workbench::on(const LogMessage& c) { log(c.level, c.text); }

}  // namespace myo::ui::commands
