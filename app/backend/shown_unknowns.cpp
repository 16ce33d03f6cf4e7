#include "backend/shown_unknowns.hpp"

#include "prediction/prediction.hpp"
#include "results/readable_parameter.hpp"

namespace myo::backend {

ui::commands::SceneUnknowns shown_unknowns(const setup::Setup& setup) {
    ui::commands::SceneUnknowns shown;
    const std::vector<experiment::UnknownDeclaration>& declared = setup.experiment.unknowns;
    for (const prediction::ModelParameter& entry : prediction::free_parameters(setup)) {
        const inverse::Parameter& p = entry.parameter;
        ui::commands::SceneUnknown unknown;
        unknown.name = p.name;
        unknown.label = results::readable_parameter(entry, setup).name;
        unknown.unit = entry.unit;
        unknown.value = p.value;
        unknown.lowest = p.lower;
        unknown.highest = p.upper;
        // Declared bounds are shown apart: p.lower and p.upper include limits that the model sets itself.
        for (std::size_t i = 0; i < declared.size(); ++i) {
            if (declared[i].name != p.name) continue;
            unknown.declared = static_cast<int>(i);
            unknown.declared_lowest = declared[i].lowest;
            unknown.declared_highest = declared[i].highest;
            unknown.declared_tolerance = declared[i].tolerance;
        }
        shown.push_back(std::move(unknown));
    }
    return shown;
}

}  // namespace myo::backend
