#include "reproduce/reproduction_cases.hpp"

namespace myo::reproduce {

// In the order of the paper: beam, arm, fish.
const std::vector<ReproductionCase>& reproduction_catalogue() {
    static const std::vector<ReproductionCase> cases = {
        reproduce_beam_static(), reproduce_beam_modulus(), reproduce_numerical_damping(), reproduce_lambda(),
        reproduce_arm_static(),  reproduce_arm_dynamic(),  reproduce_arm_chamber(),       reproduce_fish(),
    };
    return cases;
}

std::vector<std::string> reproduction_ids() {
    std::vector<std::string> ids;
    for (const ReproductionCase& one : reproduction_catalogue()) ids.push_back(one.id);
    return ids;
}

const ReproductionCase* find_reproduction(const std::string& id) {
    for (const ReproductionCase& one : reproduction_catalogue())
        if (one.id == id) return &one;
    return nullptr;
}

}  // namespace myo::reproduce
