#include "experiment/law_values.hpp"

#include <algorithm>
#include <cassert>

#include "material/catalogue.hpp"
#include "toml/toml_text.hpp"

namespace myo::experiment {

std::vector<double> read_law_values(const toml::TomlReader& table, const material::Material& law) {
    std::vector<double> values;
    const std::vector<material::LawParameter> parameters = law.parameters();
    for (const material::LawParameter& p : parameters)
        values.push_back(table.number(p.name, toml::between(p.lower, p.upper)));
    // Keys of all laws are known to the reader, so a key of another law must be refused here, or it would have no
    // effect.
    for (const material::LawParameter& any : material::all_law_parameters()) {
        const auto is_it = [&](const material::LawParameter& p) { return p.name == any.name; };
        if (table.has(any.name) && std::none_of(parameters.begin(), parameters.end(), is_it))
            table.fail(any.name, "is no parameter of the law \"" + law.id() + "\"");
    }
    return values;
}

std::string law_values_text(const material::Material& law, const std::vector<double>& values) {
    const std::vector<material::LawParameter> parameters = law.parameters();
    assert(parameters.size() == values.size());
    std::string text;
    for (std::size_t k = 0; k < values.size(); ++k)
        text += parameters[k].name + " = " + toml::toml_number(values[k]) + "\n";
    return text;
}

}  // namespace myo::experiment
