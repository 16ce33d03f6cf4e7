#pragma once

#include <string>
#include <vector>

namespace myo::ui::commands {

/// Past and future values of something that is edited.
///
/// An edit that goes on (a slider being dragged) replaces the value without a new step.
template <class Value>
class UndoStack {
public:
    /// @param before   the value until now
    /// @param what     what is edited, for merging
    /// @param goes_on  this edit continues the previous one of the same name
    void record(const Value& before, const std::string& what, bool goes_on) {
        future_.clear();
        if (goes_on && !past_.empty() && what == last_) return;
        past_.push_back(before);
        last_ = what;
        if (past_.size() > limit) past_.erase(past_.begin());
    }
    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

    Value undo(const Value& now) { return step(past_, future_, now); }
    Value redo(const Value& now) { return step(future_, past_, now); }
    void clear() { *this = UndoStack(); }

private:
    static constexpr std::size_t limit = 200;

    Value step(std::vector<Value>& from, std::vector<Value>& to, const Value& now) {
        last_.clear();
        if (from.empty()) return now;
        to.push_back(now);
        Value value = from.back();
        from.pop_back();
        return value;
    }

    std::vector<Value> past_;
    std::vector<Value> future_;
    std::string last_;
};

}  // namespace myo::ui::commands
