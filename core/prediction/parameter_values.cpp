#include "prediction/prediction.hpp"
#include "setup/trial_effects.hpp"

namespace myo::prediction {
namespace {

using Kind = ModelParameter::Kind;

}  // namespace

double value_of(const ModelParameter& p, const ParameterValues& values) {
    switch (p.kind) {
        case Kind::youngs_modulus: return values.youngs_modulus_Pa;
        case Kind::damping: return values.damping_s;
        case Kind::law: return values.law[p.index];
        case Kind::part_modulus: return values.part_modulus_Pa[p.index];
        case Kind::part_damping: return values.part_damping_s[p.index];
        case Kind::translation: return values.translation_m(static_cast<Eigen::Index>(p.index));
        case Kind::rotation: return values.rotation_rad(static_cast<Eigen::Index>(p.index));
        case Kind::start_shift: return values.start_shift_s[p.trial];
        case Kind::level: return values.levels[p.trial].at(p.index);
        case Kind::effect: return setup::effect_number(values.effects[p.index], p.of_effect, p.component, p.base);
    }
    return 0.0;
}

void set_value(const ModelParameter& p, double value, ParameterValues& values) {
    switch (p.kind) {
        case Kind::youngs_modulus: values.youngs_modulus_Pa = value; break;
        case Kind::damping: values.damping_s = value; break;
        case Kind::law: values.law[p.index] = value; break;
        case Kind::part_modulus: values.part_modulus_Pa[p.index] = value; break;
        case Kind::part_damping: values.part_damping_s[p.index] = value; break;
        case Kind::translation: values.translation_m(static_cast<Eigen::Index>(p.index)) = value; break;
        case Kind::rotation: values.rotation_rad(static_cast<Eigen::Index>(p.index)) = value; break;
        case Kind::start_shift: values.start_shift_s[p.trial] = value; break;
        case Kind::level: values.levels[p.trial][p.index] = value; break;
        case Kind::effect:
            setup::set_effect_number(values.effects[p.index], p.of_effect, p.component, value, p.base);
            break;
    }
}

}  // namespace myo::prediction
