#include "check/declared_steps.hpp"

#include <algorithm>
#include <iterator>

#include "check/catalogue.hpp"
#include "project/time_step.hpp"

namespace myo {

std::vector<Finding> findings_on_units(const Study& study) {
    std::vector<Finding> found;
    for (const char* const check : {"units", "time_unit"}) {
        std::vector<Finding> more = run_check(*find_check(check), {study});
        std::move(more.begin(), more.end(), std::back_inserter(found));
    }
    return found;
}

void choose_declared_steps(Study& study, const std::vector<Finding>& on_units, const Progress& progress) {
    const bool in_doubt = std::any_of(on_units.begin(), on_units.end(),
                                      [](const Finding& finding) { return finding.level != CheckLevel::fine; });
    if (in_doubt) study.settings.h_s = shortest_step_s(study);
    else set_steps(study, choose_steps(study, declared_values(study), progress));
}

}  // namespace myo
