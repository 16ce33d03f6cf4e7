#include <cstdio>

#include "backend/library_versions.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/solver_options.hpp"
#include "exit_status.hpp"
#include "fem/element_block.hpp"
#include "material/catalogue.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

// Clang's __VERSION__ begins with its name, and GCC's is a number alone.
#ifdef __clang__
const char* const compiler = __VERSION__;
#else
const char* const compiler = "GCC " __VERSION__;
#endif

}  // namespace

std::function<int()> declare_info(CLI::App&) {
    return [] {
        const auto line = [](const char* name, const std::string& value) {
            print_format("%-12s %s\n", name, value.c_str());
        };
        line("myoloop", MYOLOOP_VERSION);
        line("compiler", compiler);
        line("threads", std::to_string(hardware_threads()));
        line("elements", join(fem::element_ids()));
        line("integrators", join(dynamics::integrator_ids()));
        line("strategies", join(dynamics::strategy_ids()));
        line("materials", join(material::material_ids()));
        print_text("libraries\n");
        for (const backend::LibraryVersion& library : backend::library_versions)
            print_format("  %-12s %s\n", library.name, library.version);
        return static_cast<int>(status_done);
    };
}

}  // namespace myo::app
