#include "calibration/values_at_bounds.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace myo::calibration {
namespace {

struct ValuesAtBoundsPolicy {
    /// Distance to a bound relative to the scale, as closely as the fit's internal variables reach bounds.
    double nearly = 1e-6;
};
constexpr ValuesAtBoundsPolicy values_at_bounds_policy;

/// Whether the data say nothing about a parameter; it then keeps its start, wherever that is. Parameters that are
/// determined in combination with others do not count.
bool has_no_influence(const Calibration& calibration, std::size_t parameter) {
    const std::vector<inverse::Undetermined>& all = calibration.fit.undetermined;
    return std::any_of(all.begin(), all.end(), [&](const inverse::Undetermined& group) {
        return group.parameters.size() == 1 && group.parameters.front() == static_cast<Eigen::Index>(parameter);
    });
}

}  // namespace

std::vector<ValueAtBound> values_at_bounds(const Calibration& calibration) {
    std::vector<ValueAtBound> found;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const inverse::Parameter& p = calibration.parameters[i].parameter;
        const double value = calibration.fit.values(static_cast<Eigen::Index>(i)),
                     near = values_at_bounds_policy.nearly * p.scale;
        if (has_no_influence(calibration, i)) continue;
        if (value >= p.upper - near)
            found.push_back({i, value, p.upper, true});
        else if (value <= p.lower + near)
            found.push_back({i, value, p.lower, false});
    }
    return found;
}

std::string bound_sentence(const setup::Setup& setup, const Calibration& calibration, const ValueAtBound& at) {
    const prediction::ModelParameter& p = calibration.parameters[at.parameter];
    const std::string bound = std::string(at.upper ? "upper" : "lower") + " bound, " + format_number(at.bound) +
                              (p.unit.empty() ? "" : " " + p.unit);
    const std::vector<experiment::UnknownDeclaration>& unknowns = setup.experiment.unknowns;
    if (std::any_of(unknowns.begin(), unknowns.end(),
                    [&](const auto& unknown) { return unknown.name == p.parameter.name; }))
        return p.parameter.name + ": the fit ended at its " + bound +
               ", as [[unknown]] declares; the model may lack an effect, or the bounds are too narrow";
    if (p.kind != prediction::ModelParameter::Kind::youngs_modulus)
        return p.parameter.name + ": the fit ended at its " + bound;
    return "material.youngs_modulus_Pa: the fit ended at its " + bound + ", the edge of the declared tolerance of " +
           format_number(100.0 * setup.experiment.material.youngs_modulus_tolerance, 3) +
           " %; the model may lack an effect, or material.youngs_modulus_tolerance is too narrow";
}

}  // namespace myo::calibration
