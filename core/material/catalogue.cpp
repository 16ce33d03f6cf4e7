#include "material/catalogue.hpp"

namespace myo::material {

/// One line per law: the name of the function that its file defines.
// clang-format off
#define MYOLOOP_MATERIALS(entry) \
    entry(neo_hookean) \
    entry(corotational) \
    entry(projective_corotational) \
    entry(st_venant_kirchhoff) \
    entry(gent) \
    entry(mooney_rivlin)
// clang-format on

#define MYOLOOP_DECLARE(name) MaterialPointer name();
MYOLOOP_MATERIALS(MYOLOOP_DECLARE)
#undef MYOLOOP_DECLARE

const std::vector<MaterialPointer>& material_catalogue() {
#define MYOLOOP_CALL(name) name(),
    static const std::vector<MaterialPointer> laws = {MYOLOOP_MATERIALS(MYOLOOP_CALL)};
#undef MYOLOOP_CALL
    return laws;
}

MaterialPointer find_material(const std::string& id, const std::vector<double>& values) {
    for (const MaterialPointer& law : material_catalogue())
        if (law->id() == id) return values.empty() ? law : law->with_values(values);
    return nullptr;
}

std::vector<std::string> material_ids() {
    std::vector<std::string> ids;
    for (const MaterialPointer& law : material_catalogue()) ids.push_back(law->id());
    return ids;
}

std::vector<LawParameter> all_law_parameters() {
    std::vector<LawParameter> all;
    for (const MaterialPointer& law : material_catalogue())
        for (const LawParameter& parameter : law->parameters()) all.push_back(parameter);
    return all;
}

}  // namespace myo::material
