#include "dynamics/integrator.hpp"

#include "base/name_table.hpp"

namespace myo::dynamics {
namespace {

constexpr NameTable<Integrator, 5> integrators{{{
    {Integrator::tr_bdf2, "tr_bdf2"},
    {Integrator::implicit_euler, "implicit_euler"},
    {Integrator::bdf2, "bdf2"},
    {Integrator::trapezoidal, "trapezoidal"},
    {Integrator::generalized_alpha, "generalized_alpha"},
}}};

}  // namespace

std::string to_string(Integrator integrator) { return integrators.name(integrator); }
std::vector<std::string> integrator_ids() { return integrators.names(); }
bool parse_integrator(const std::string& id, Integrator& integrator) { return integrators.find(id, integrator); }

}  // namespace myo::dynamics
