#include "effect/effect_declaration.hpp"

#include <algorithm>

namespace myo::effect {
namespace {

bool same_value(const EffectParameter& a, const EffectParameter& b) {
    const auto *v = std::get_if<Eigen::VectorXd>(&a), *w = std::get_if<Eigen::VectorXd>(&b);
    // Eigen compares vectors of one length only.
    if (v != nullptr && w != nullptr) return v->size() == w->size() && *v == *w;
    return a.index() == b.index() && v == nullptr && a == b;
}

}  // namespace

bool EffectDeclaration::operator==(const EffectDeclaration& other) const {
    return id == other.id && calibrate == other.calibrate &&
           std::equal(
               parameters.begin(), parameters.end(), other.parameters.begin(), other.parameters.end(),
               [](const auto& a, const auto& b) { return a.first == b.first && same_value(a.second, b.second); });
}

}  // namespace myo::effect
