#include "backend/law_settings.hpp"

#include <algorithm>

#include "material/catalogue.hpp"

namespace myo::backend {
namespace {

/// Parameters of the law of the settings, in its order; none for an unknown law.
std::vector<material::LawParameter> parameters_of(const ui::commands::Settings& settings) {
    const material::MaterialPointer law = material::find_material(settings.material);
    return law ? law->parameters() : std::vector<material::LawParameter>{};
}

}  // namespace

std::vector<ui::commands::Choice> law_choices() {
    std::vector<ui::commands::Choice> list;
    for (const material::MaterialPointer& law : material::material_catalogue()) {
        ui::commands::Choice choice{law->id(), law->label(),
                                    "Energy per rest volume [J/m³]\nψ = " + law->formula() + "\n" + law->explanation()};
        for (const material::LawParameter& p : law->parameters())
            choice.numbers.push_back({p.name, p.label, p.unit, p.meaning, p.usual, {p.lower, p.upper}});
        list.push_back(std::move(choice));
    }
    return list;
}

std::vector<double> law_values(const ui::commands::Settings& settings) {
    std::vector<double> values;
    for (const material::LawParameter& p : parameters_of(settings)) {
        // Settings also keep numbers of other laws; the range is that of this one.
        const auto set = settings.law.find(p.name);
        values.push_back(set != settings.law.end() ? std::clamp(set->second, p.lower, p.upper) : p.usual);
    }
    return values;
}

void set_law_values(const std::vector<double>& values, ui::commands::Settings& settings) {
    const std::vector<material::LawParameter> parameters = parameters_of(settings);
    for (std::size_t k = 0; k < std::min(values.size(), parameters.size()); ++k)
        settings.law[parameters[k].name] = values[k];
}

}  // namespace myo::backend
