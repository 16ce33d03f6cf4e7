#pragma once

#include <string>
#include <vector>

namespace myo::ui::commands {

/// Undo and redo for a value that is edited as a whole.
///
/// A continued edit (the same drag of a slider) replaces the value without a new entry. Keeps the last 200 entries.
/// Used on the UI thread.
template <class Value>
class UndoStack {
public:
    /// Records an edit and discards the redo entries.
    ///
    /// @param before  value before the edit
    /// @param what  name of the edit, for merging
    /// @param goes_on  this edit continues the previous one of the same name
    void record(const Value& before, const std::string& what, bool goes_on) {
        future_.clear();
        // The value before the first edit of a drag is in the list already.
        if (goes_on && !past_.empty() && what == last_) return;
        past_.push_back(before);
        last_ = what;
        if (past_.size() > limit) past_.erase(past_.begin());
    }
    /// Whether undo() has a value to return to.
    bool can_undo() const { return !past_.empty(); }
    /// Whether redo() has a value to return to.
    bool can_redo() const { return !future_.empty(); }

    /// The previous or next value. Returns `now` unchanged if there is none.
    Value undo(const Value& now) { return step(past_, future_, now); }
    Value redo(const Value& now) { return step(future_, past_, now); }
    /// Removes all entries.
    void clear() { *this = UndoStack(); }

private:
    static constexpr std::size_t limit = 200;  // number of entries

    /// Moves one entry between the lists. Clears the name, so that the next edit gets an entry of its own.
    Value step(std::vector<Value>& from, std::vector<Value>& to, const Value& now) {
        last_.clear();
        if (from.empty()) return now;
        to.push_back(now);
        Value value = from.back();
        from.pop_back();
        return value;
    }

    std::vector<Value> past_;    // newest last
    std::vector<Value> future_;  // next redo last
    std::string last_;           // name of the last edit
};

}  // namespace myo::ui::commands
