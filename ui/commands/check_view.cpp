#include "commands/check_view.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace myo::ui::commands {
namespace {

using Order = std::array<CheckState, 3>;

/// "1 red, 2 amber": counts of the states that occur, in the given order.
std::string counted(const CheckRows& rows, const Order& order) {
    std::string words;
    for (const CheckState state : order) {
        const auto count = std::count_if(rows.begin(), rows.end(), [&](const CheckRow& r) { return r.state == state; });
        if (count > 0) words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + check_word(state);
    }
    return words;
}

}  // namespace

const char* check_word(CheckState state) {
    return state == CheckState::green ? "green" : state == CheckState::amber ? "amber" : "red";
}

CheckState worst_state(const CheckRows& rows) {
    CheckState worst = CheckState::green;
    for (const CheckRow& row : rows) worst = std::max(worst, row.state);
    return worst;
}

std::string count_text(const CheckRows& rows) {
    return counted(rows, {CheckState::green, CheckState::amber, CheckState::red});
}

std::string doubt_text(const CheckRows& rows) {
    if (worst_state(rows) == CheckState::green) return "all green";
    CheckRows doubts;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(doubts),
                 [](const CheckRow& row) { return row.state != CheckState::green; });
    return counted(doubts, {CheckState::red, CheckState::amber, CheckState::green});
}

}  // namespace myo::ui::commands
