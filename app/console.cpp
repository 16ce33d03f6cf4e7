#include "console.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "report/json.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

/// Text without line breaks: messages are single lines, so that scripts can read them.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

/// Duration in the unit that matters: seconds, rounded up; from 59 s on, minutes with seconds; hours.
std::string duration_text(double seconds) {
    char text[32];
    if (seconds < 60.0) seconds = std::ceil(seconds);
    if (seconds < 60.0)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else if (seconds < 3600.0)
        std::snprintf(text, sizeof text, "%d min %02d s", static_cast<int>(seconds) / 60,
                      static_cast<int>(seconds) % 60);
    else
        std::snprintf(text, sizeof text, "%.1f h", std::min(seconds / 3600.0, 1e6));
    return text;
}

/// Bar of 24 characters with percent, "[######    ]  25 %".
///
/// @param share  0 ... 1
std::string bar_of(double share) {
    std::string bar(24, ' ');
    std::fill_n(bar.begin(), static_cast<std::ptrdiff_t>(std::lround(24.0 * share)), '#');
    char percent[16];
    std::snprintf(percent, sizeof percent, "]%4.0f %%", 100.0 * share);
    return "[" + bar + percent;
}

/// Progress of a fit: the bar shows the running evaluation, as only the largest possible number of evaluations is
/// known.
std::string evaluation_bar(const ProgressEvent& event, double elapsed_s) {
    const double complete = std::floor(event.done);
    std::string text = event.task + "  evaluation " + format_number(complete + 1.0, 4) + " " +
                       bar_of(event.done - complete) + "  " + duration_text(elapsed_s) + " so far";
    // `done` is fractional: whole evaluations plus the part of the running one. Before the first is complete, there is
    // no time to extrapolate.
    if (event.done >= 1.0 && event.done < event.total)
        text += ", at most " + duration_text(elapsed_s * (event.total - event.done) / event.done) + " left";
    return event.message.empty() ? text : text + "  " + event.message;
}

}  // namespace

Console::Console(bool quiet, bool json_progress)
    : quiet_(quiet),
      json_progress_(json_progress),
      terminal_(::isatty(STDERR_FILENO) == 1),
      task_start_(Clock::now()) {}

Console::~Console() { clear_bar(); }

Progress Console::progress() {
    return Progress([this](const ProgressEvent& event) { show(event); }, &interrupt_flag());
}

void Console::show(const ProgressEvent& event) {
    // Progress arrives from worker threads.
    const std::lock_guard<std::mutex> lock(mutex_);
    // Every event is a line, without throttling.
    if (json_progress_) {
        const std::string line = progress_line(event) + "\n";
        std::fputs(line.c_str(), stderr);
        return;
    }
    if (!terminal_ || quiet_) return;
    const Clock::time_point now = Clock::now();
    // A new task restarts the clock of its bar.
    if (event.task != task_) {
        task_ = event.task;
        task_start_ = now;
    }
    // The last report is always drawn; others are throttled.
    const bool last = event.total > 0.0 && event.done >= event.total;
    if (!last && !throttle_.ready()) return;
    bar_shown_ = true;
    // Return, erase the line, draw again: the bar stays in one line of the terminal.
    std::fprintf(stderr, "\r\033[K%s",
                 progress_bar(event, std::chrono::duration<double>(now - task_start_).count()).c_str());
    std::fflush(stderr);
}

void Console::clear_bar() {
    if (bar_shown_) std::fputs("\r\033[K", stderr);
    bar_shown_ = false;
}

void Console::print(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    clear_bar();
    if (quiet_) return;
    print_text(text + "\n");
}

void Console::warn(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    clear_bar();
    if (!quiet_) std::fputs(("myoloop: warning: " + one_line(text) + "\n").c_str(), stderr);
}

void Console::complain(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    clear_bar();
    std::fputs(("myoloop: " + one_line(text) + "\n").c_str(), stderr);
}

int Console::refuse(const Error& error) {
    complain(error.text());
    return status_wrong;
}

int Console::fail(const Error& error) {
    complain(error.text());
    return status_failed;
}

std::string progress_line(const ProgressEvent& event) {
    report::Json json{{"event", "progress"},
                      {"task", event.task},
                      {"done", report::json_number(event.done)},
                      {"total", report::json_number(event.total)},
                      {"unit", event.unit}};
    if (!event.message.empty()) json["message"] = event.message;
    return report::json_line(json);
}

std::string progress_bar(const ProgressEvent& event, double elapsed_s) {
    if (event.unit == "evaluations") return evaluation_bar(event, elapsed_s);
    // Without a known total, the elapsed time is shown.
    if (!(event.total > 0.0))
        return event.task + "  " + duration_text(elapsed_s) + " so far" +
               (event.message.empty() ? "" : "  " + event.message);
    const double share = std::clamp(event.done / event.total, 0.0, 1.0);
    std::string text = event.task + "  " + bar_of(share) + "  " + format_number(event.done, 4) + " of " +
                       format_number(event.total, 4) + " " + event.unit;
    // Early estimates of the remaining time are unreliable.
    if (share > 0.01 && share < 1.0 && elapsed_s > 0.5)
        text += "  " + duration_text(elapsed_s * (1.0 - share) / share) + " left";
    return event.message.empty() ? text : text + "  " + event.message;
}

}  // namespace myo::app
