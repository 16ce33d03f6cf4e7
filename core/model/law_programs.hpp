#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "law/law.hpp"
#include "law/program.hpp"

namespace myo::model {

/// How the potential of a law's force is computed, if it has one.
enum class LawPotential {
    none,
    energy,        // the law states it
    of_positions,  // integral of the force along the way from rest
    of_velocity,   // the same from no velocity
    of_both,
};

/// A law of a force with its derivatives, compiled once for all models.
struct LawPrograms {
    law::Law law;
    law::Program force;      // 3 components, and the energy if the law states it
    law::Program tangent;    // those, then the derivatives as the blocks below say
    law::Program by_number;  // 3 components per number of the parameters
    LawPotential potential = LawPotential::none;
    /// Power of the displacement or velocity to which the force grows everywhere, so that its potential is the force
    /// along the way over this power plus 1; 0: none, and the potential is integrated.
    double degree = 0.0;
    bool keeps_energy = false;  // the force never adds to the sum of its potential and other energies
    bool uses_x = false, uses_v = false, uses_n = false, uses_area = false, uses_time = false;
    // Blocks of outputs of `tangent`: row by row, derivative of component i by component j; 0: none.
    std::size_t by_x = 0, by_v = 0, by_n = 0, by_area = 0;
};

/// Compiles a law on a surface, at a point or in a volume.
///
/// Whether its force has a potential is seen from the symmetry of its derivatives at many states about the given
/// values.
/// @param numbers  typical values of the parameters, one per number
std::shared_ptr<const LawPrograms> law_programs(law::Law law, const Eigen::VectorXd& numbers);

}  // namespace myo::model
