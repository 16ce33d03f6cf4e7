#include "check/declared_steps.hpp"

#include <algorithm>
#include <iterator>

#include "check/catalogue.hpp"
#include "prediction/time_step.hpp"

namespace myo::check {

std::vector<Finding> findings_on_units(const setup::Setup& setup) {
    std::vector<Finding> found;
    // Only these two checks are needed before the choice of steps; the others run with the chosen steps.
    for (const char* const check : {"units", "time_unit"}) {
        std::vector<Finding> more = run_check(*find_check(check), {setup});
        std::move(more.begin(), more.end(), std::back_inserter(found));
    }
    return found;
}

void choose_declared_steps(setup::Setup& setup, const std::vector<Finding>& on_units, const Progress& progress) {
    const bool in_doubt = std::any_of(on_units.begin(), on_units.end(),
                                      [](const Finding& finding) { return finding.level != CheckLevel::passed; });
    // Fixing h_s makes the steps not choosable(), so the rest of the command keeps them as well.
    if (in_doubt)
        setup.settings.h_s = prediction::shortest_step_s(setup);
    else
        prediction::set_steps(setup, prediction::choose_steps(setup, prediction::declared_values(setup), progress));
}

}  // namespace myo::check
