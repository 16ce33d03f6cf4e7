#include <algorithm>
#include <utility>

#include "base/letter_case.hpp"
#include "commands/workbench.hpp"

// Checks of the workbench's jobs, and the time step that they concern.

namespace myo::ui::commands {
namespace {

/// Whether one of the rows has this sentence.
bool says(const CheckRows& rows, const std::string& sentence) {
    return std::any_of(rows.begin(), rows.end(), [&](const CheckRow& row) { return row.sentence == sentence; });
}

}  // namespace

void Workbench::show_checks(const CheckRows& rows, const Settings& settings) {
    if (rows.empty() || !request_) return;
    const std::shared_ptr<const CheckReport> before = std::exchange(
        state_.checks,
        std::make_shared<const CheckReport>(CheckReport{request_->name, request_->clock, settings, rows}));
    for (const CheckRow& row : rows) {
        // A finding that was logged before is not repeated after every job.
        if (row.state == CheckState::green || row.warned || (before && says(before->rows, row.sentence))) continue;
        log(LogLevel::warning, upper_first(row.sentence) + (row.way_out.empty() ? "" : "; " + row.way_out));
    }
}

void Workbench::log_done(const std::string& text, const CheckRows& rows) {
    const bool trusted = worst_state(rows) == CheckState::green;
    log(trusted ? LogLevel::done : LogLevel::warning, text + (trusted ? "" : " Checks: " + doubt_text(rows) + "."));
}

void Workbench::take_step(double time_step_s) {
    const auto take = [&](Settings& settings) {
        // A step that the user has set is kept.
        if (settings.own_step) return;
        settings.time_step_s = time_step_s;
    };
    take(state_.saved_settings);  // so that the program's own choice does not count as an unsaved change
    take(autosaved_);
    Settings settings = state_.settings;
    take(settings);
    if (!(settings == state_.settings)) set_settings(settings);
}

}  // namespace myo::ui::commands
