#include "material/catalogue.hpp"

namespace myo::material {

const std::vector<MaterialPointer>& material_catalogue() {
    static const std::vector<MaterialPointer> laws = {
        neo_hookean(),
        corotational(),
        projective_corotational(),
        st_venant_kirchhoff(),
    };
    return laws;
}

MaterialPointer find_material(const std::string& id) {
    for (const MaterialPointer& law : material_catalogue())
        if (law->id() == id) return law;
    return nullptr;
}

std::vector<std::string> material_ids() {
    std::vector<std::string> ids;
    for (const MaterialPointer& law : material_catalogue()) ids.push_back(law->id());
    return ids;
}

}  // namespace myo::material
