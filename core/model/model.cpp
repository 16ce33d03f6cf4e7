#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include "model/force_element.hpp"

namespace myo::model {

std::vector<double> poissons_ratios(const std::vector<material::Moduli>& moduli) {
    std::vector<double> result;
    for (const material::Moduli& m : moduli) result.push_back(material::young_from_moduli(m).poissons_ratio);
    return result;
}

std::vector<material::Moduli> uniform_moduli(int cell_count, double youngs_modulus_Pa, double poissons_ratio) {
    return std::vector<material::Moduli>(static_cast<std::size_t>(cell_count),
                                         material::moduli_from_young(youngs_modulus_Pa, poissons_ratio));
}

// The weight acts on the isotropic mass only.
Eigen::Matrix3Xd external_forces(const Model& model, const MassMatrix& mass, double t, bool before) {
    Eigen::Matrix3Xd f = model.gravity_m_s2 * mass.nodal_kg.transpose();
    for (const DeadForce& load : model.forces)
        if (const double factor = load.factor(t, before); factor != 0.0)
            f += factor * load.force_N * load.share.transpose();
    return f;
}

std::vector<double> activations(const Model& model, double t, bool before) {
    std::vector<double> a;
    for (const fibre::Signal& signal : model.activation) a.push_back(before ? signal.value_before(t) : signal.value(t));
    return a;
}

std::vector<double> jump_times(const Model& model) {
    std::vector<double> times;
    for (const DeadForce& load : model.forces) {
        for (const double t : {load.from_s, load.until_s})
            if (std::isfinite(t)) times.push_back(t);
        for (const double t : load.course.jumps()) times.push_back(t);
    }
    for (const DirectionalMass& mass : model.directional_masses)
        for (const double t : {mass.from_s, mass.until_s})
            if (std::isfinite(t)) times.push_back(t);
    for (const fibre::Signal& signal : model.activation)
        for (const double t : signal.jumps()) times.push_back(t);
    for (const ForceElementPointer& element : model.force_elements)
        for (const double t : element->jumps()) times.push_back(t);
    // Time steps end at these times, at each only once.
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace myo::model
