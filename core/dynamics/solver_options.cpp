#include "dynamics/solver_options.hpp"

#include "base/name_table.hpp"

namespace myo::dynamics {
namespace {

constexpr NameTable<Strategy, 4> strategies{{{
    {Strategy::automatic, "automatic"},
    {Strategy::lagged_newton, "lagged_newton"},
    {Strategy::newton, "newton"},
    {Strategy::projective, "projective"},
}}};

}  // namespace

std::string to_string(Strategy strategy) { return strategies.name(strategy); }
std::vector<std::string> strategy_ids() { return strategies.names(); }
bool parse_strategy(const std::string& id, Strategy& strategy) { return strategies.find(id, strategy); }

}  // namespace myo::dynamics
