#include <cstdio>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/solver_options.hpp"
#include "exit_status.hpp"
#include "fem/element_block.hpp"
#include "library_versions.hpp"
#include "material/catalogue.hpp"
#include "standard_output.hpp"

namespace myo {

std::function<int()> declare_info(CLI::App&) {
    return [] {
        const auto line = [](const char* name, const std::string& value) {
            print_format("%-12s %s\n", name, value.c_str());
        };
        line("myoloop", MYOLOOP_VERSION);
        line("compiler", "GCC " __VERSION__);
        line("threads", std::to_string(hardware_threads()));
        line("elements", join(element_ids()));
        line("integrators", join(integrator_ids()));
        line("strategies", join(strategy_ids()));
        line("materials", join(material_ids()));
        print_text("libraries\n");
        for (const LibraryVersion& library : library_versions)
            print_format("  %-12s %s\n", library.name, library.version);
        return static_cast<int>(status_done);
    };
}

}  // namespace myo
