#include "commands/live_play.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace myo::ui::commands {
namespace {

using Clock = std::chrono::steady_clock;

/// Real time between two points in time [s].
double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

/// Simulated time over real time, of the last steps.
class Rate {
public:
    /// Takes a step that ends at this simulated time [s]. Returns the rate over the last second, 0 for the first step.
    double after(double simulated_s) {
        const Clock::time_point now = Clock::now();
        steps_.push_back({now, simulated_s});
        while (steps_.size() > 2 && seconds_between(steps_.front().at, now) > live_play_policy.rate_over_s)
            steps_.pop_front();
        const double passed = seconds_between(steps_.front().at, now);
        return passed > 0.0 ? (simulated_s - steps_.front().simulated_s) / passed : 0.0;
    }

private:
    struct Step {
        Clock::time_point at;  // real time at which the step ended
        double simulated_s;    // time of the model then
    };
    std::deque<Step> steps_;
};

/// Length of the steps: as set, or longer where a step takes longer than the time it covers and a longer one is worth
/// its cost.
class StepLength {
public:
    /// Length of the next step [s]. A change of the setting starts the judgement again.
    double next(const LiveControls& controls) {
        if (controls.own_step || controls.time_step_s != set_s_) {
            set_s_ = length_s_ = controls.time_step_s;
            steps_ = 0, cost_s_ = 0.0, shorter_s_ = 0.0, settled_ = false;
        }
        return length_s_;
    }
    /// Takes the real time that a step took [s].
    void took(double seconds) {
        cost_s_ += seconds;
        if (++steps_ < live_play_policy.steps_before) return;
        const double load = cost_s_ / steps_ / length_s_;  // real time over simulated time
        steps_ = 0, cost_s_ = 0.0;
        // A longer step that costs more per simulated time falls farther behind: the shorter one stays until the
        // setting changes.
        if (!settled_ && shorter_s_ > 0.0 && load > shorter_load_) {
            length_s_ = shorter_s_;
            settled_ = true;
        } else if (!settled_ && load > live_play_policy.lengthen_at && length_s_ < live_play_policy.longest_step_s) {
            shorter_s_ = length_s_, shorter_load_ = load;
            length_s_ = std::min(2.0 * length_s_, live_play_policy.longest_step_s);
        }
    }

private:
    double set_s_ = 0.0, length_s_ = 0.0, cost_s_ = 0.0;
    double shorter_s_ = 0.0, shorter_load_ = 0.0;  // before the last lengthening; 0: none
    bool settled_ = false;                         // a longer step was not worth its cost
    int steps_ = 0;
};

}  // namespace

/// State that the two threads share. On the heap: its address must not change while the thread runs.
struct LivePlay::Content {
    mutable std::mutex mutex;  // guards the following
    LiveControls controls;
    Make make;  // of a model that has to be made; empty: none
    LiveView shown;

    std::atomic<bool> stop = false;
    std::thread thread;
    bool current = false;  // on the thread: the model is the last one that was asked for

    /// Makes the model that was asked for, if any. Returns false if there is none, or if it cannot be made: then the
    /// present one stands still until another is asked for, which goes on from it.
    bool make_asked(std::unique_ptr<LiveModel>& model, const Progress& progress) {
        Make asked;
        {
            const std::lock_guard lock(mutex);
            asked = std::exchange(make, {});
        }
        if (!asked) return current;
        Result<std::unique_ptr<LiveModel>> made = asked(model.get(), progress);
        const std::lock_guard lock(mutex);
        shown.problem = made ? "" : made.error().text();
        current = static_cast<bool>(made);
        if (!made) return false;
        model = std::move(*made);
        shown.actuators = model->actuators();
        // Levels that were set go on; those of a model with other actuators mean nothing for this one.
        if (controls.levels.size() != shown.actuators.size()) {
            controls.levels.clear();
            for (const LiveActuator& actuator : shown.actuators) controls.levels.push_back(actuator.level);
        }
        // A stiffness that was set goes on; otherwise the model proposes one.
        if (!(controls.spring_N_m > 0.0)) controls.spring_N_m = model->spring_N_m();
        return true;
    }

    /// Shows a frame, or why there is none. A step without a solution leaves the last frame.
    void show(const Result<LiveFrame>& frame, double rate) {
        const std::lock_guard lock(mutex);
        if (!frame) {
            shown.problem = frame.error().text();
            return;
        }
        shown.problem.clear();
        shown.frame = std::make_shared<const LiveFrame>(*frame);
        shown.ready = true;
        shown.rate = rate;
    }

    static Clock::duration duration_of(double seconds) {
        return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    }
    /// Longest sleep at once, so that a stop is followed soon.
    static Clock::duration pause() { return duration_of(live_play_policy.longest_pause_s); }
    /// Sleeps until a time, or until the play is stopped.
    void wait_until(Clock::time_point due) const {
        while (!stop && Clock::now() < due) std::this_thread::sleep_until(std::min(due, Clock::now() + pause()));
    }

    /// Work of the thread: makes models that are asked for, and steps the present one in real time.
    void play() {
        const Progress progress({}, &stop);
        std::unique_ptr<LiveModel> model;
        Rate rate;
        StepLength length;
        Clock::time_point due = Clock::now();
        while (!stop) {
            if (!make_asked(model, progress)) {
                wait_until(Clock::now() + pause());
                continue;
            }
            // A copy: the mutex must not be held during a step, as the UI thread steers and looks meanwhile.
            LiveControls now;
            {
                const std::lock_guard lock(mutex);
                now = controls;
            }
            now.time_step_s = length.next(now);
            const Clock::time_point before = Clock::now();
            const Result<LiveFrame> frame = model->step(now, progress);
            if (stop) return;
            length.took(seconds_between(before, Clock::now()));
            show(frame, frame ? rate.after(frame->time_s) : 0.0);
            due += duration_of(now.time_step_s);
            // What is lost cannot be made up for: the model goes on from now.
            if (Clock::now() > due) due = Clock::now();
            wait_until(due);
        }
    }
};

LivePlay::LivePlay(Make make, const LiveControls& controls) : content_(std::make_unique<Content>()) {
    content_->controls = controls;
    content_->make = std::move(make);
    content_->thread = std::thread([content = content_.get()] {
        try {
            content->play();
        } catch (const std::exception& e) {
            const std::lock_guard lock(content->mutex);
            content->shown.problem = e.what();
        }
    });
}

LivePlay::~LivePlay() {
    content_->stop = true;
    content_->thread.join();
}

void LivePlay::steer(const LiveControls& controls) {
    const std::lock_guard lock(content_->mutex);
    // Who steers may not have seen yet what the model began with.
    LiveControls told = controls;
    if (told.levels.empty()) told.levels = content_->controls.levels;
    if (!(told.spring_N_m > 0.0)) told.spring_N_m = content_->controls.spring_N_m;
    content_->controls = std::move(told);
}

void LivePlay::replace(Make make) {
    const std::lock_guard lock(content_->mutex);
    content_->make = std::move(make);
}

LiveView LivePlay::view() const {
    const std::lock_guard lock(content_->mutex);
    LiveView view = content_->shown;
    view.controls = content_->controls;
    return view;
}

}  // namespace myo::ui::commands
