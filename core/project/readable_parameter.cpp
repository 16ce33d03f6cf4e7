#include "project/readable_parameter.hpp"

#include <numbers>

namespace myo {

ReadableParameter readable_parameter(const StudyParameter& p, const Study& study) {
    using Kind = StudyParameter::Kind;
    const std::string axis(1, "xyz"[p.index % 3]);
    switch (p.kind) {
        case Kind::youngs_modulus: return {"Young’s modulus E", "kPa", 1e-3};
        case Kind::damping: return {"Damping time", "ms", 1e3};
        case Kind::translation: return {"Camera shift " + axis, "mm", 1e3};
        case Kind::rotation: return {"Camera turn about " + axis, "°", 180.0 / std::numbers::pi};
        case Kind::start_shift: return {"Later start of " + study.trials[p.trial].name, "ms", 1e3};
        case Kind::effect: return {p.parameter.name, p.unit, 1.0};
        case Kind::level: return {"Level of " + study.experiment.muscles[p.index].name + " in " + study.trials[p.trial].name, "", 1.0};
    }
    return {p.parameter.name, p.unit, 1.0};
}

}  // namespace myo
