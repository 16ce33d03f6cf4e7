#include "dynamics/integrator.hpp"

#include <array>

namespace myo {
namespace {

struct IntegratorEntry {
    Integrator integrator;
    const char* id;
};
constexpr std::array<IntegratorEntry, 5> integrator_table{{
    {Integrator::tr_bdf2, "tr_bdf2"},
    {Integrator::implicit_euler, "implicit_euler"},
    {Integrator::bdf2, "bdf2"},
    {Integrator::trapezoidal, "trapezoidal"},
    {Integrator::generalized_alpha, "generalized_alpha"},
}};

}  // namespace

std::string to_string(Integrator integrator) {
    for (const IntegratorEntry& entry : integrator_table)
        if (entry.integrator == integrator) return entry.id;
    return {};
}

std::vector<std::string> integrator_ids() {
    std::vector<std::string> ids;
    for (const IntegratorEntry& entry : integrator_table) ids.emplace_back(entry.id);
    return ids;
}

bool parse_integrator(const std::string& id, Integrator& integrator) {
    for (const IntegratorEntry& entry : integrator_table)
        if (entry.id == id) {
            integrator = entry.integrator;
            return true;
        }
    return false;
}

}  // namespace myo
