#pragma once

#include <functional>
#include <memory>

#include "commands/live_model.hpp"

namespace myo::ui::commands {

/// What is shown of a model that plays live.
struct LiveView {
    LiveControls controls;                   // that the next step follows
    std::vector<LiveActuator> actuators;     // empty until the model is ready
    bool ready = false;                      // the first frame is there
    std::shared_ptr<const LiveFrame> frame;  // the last one; null until ready
    double rate = 0.0;                       // simulated time over real time; 0: not known yet
    std::string problem;                     // why it stopped; empty: it moves
};

/// Policy of playing live.
struct LivePlayPolicy {
    double longest_step_s = 0.02;    // beyond it the motion of the mouse is not followed smoothly
    double lengthen_at = 0.9;        // of the real time a step may take, before the next steps are twice as long
    int steps_before = 8;            // after which the length is judged: the first steps factor the matrix
    double rate_over_s = 1.0;        // real time over which the rate is measured
    double behind_below = 0.95;      // rate below which the model is said to be behind real time
    double hand_share = 0.08;        // reach of the hand over the diagonal of the body: a patch that does not tear
    double longest_pause_s = 0.005;  // between two looks at the controls while a step waits for its time
};
inline constexpr LivePlayPolicy live_play_policy;

/// Plays a model in real time on a thread of its own. The destructor stops it.
class LivePlay {
public:
    /// Makes the model on the thread, going on from the one that moved before (null: from its start state).
    using Make = std::function<Result<std::unique_ptr<LiveModel>>(const LiveModel* before, const Progress&)>;

    /// Starts the thread, which makes the model and moves it. Failures appear as LiveView::problem.
    LivePlay(Make make, const LiveControls& controls);
    ~LivePlay();
    LivePlay(const LivePlay&) = delete;
    LivePlay& operator=(const LivePlay&) = delete;

    /// Replaces the controls; the next step follows them.
    void steer(const LiveControls& controls);
    /// Goes on with another model, where the present one is.
    void replace(Make make);
    /// What to show now.
    LiveView view() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace myo::ui::commands
