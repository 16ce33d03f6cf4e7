#include "dynamics/solver_options.hpp"

#include <array>

namespace myo {
namespace {

struct StrategyEntry {
    Strategy strategy;
    const char* id;
};
constexpr std::array<StrategyEntry, 4> strategy_table{{
    {Strategy::automatic, "automatic"},
    {Strategy::lagged_newton, "lagged_newton"},
    {Strategy::newton, "newton"},
    {Strategy::projective, "projective"},
}};

}  // namespace

std::string to_string(Strategy strategy) {
    for (const StrategyEntry& entry : strategy_table)
        if (entry.strategy == strategy) return entry.id;
    return {};
}

std::vector<std::string> strategy_ids() {
    std::vector<std::string> ids;
    for (const StrategyEntry& entry : strategy_table) ids.emplace_back(entry.id);
    return ids;
}

bool parse_strategy(const std::string& id, Strategy& strategy) {
    for (const StrategyEntry& entry : strategy_table)
        if (entry.id == id) {
            strategy = entry.strategy;
            return true;
        }
    return false;
}

}  // namespace myo
