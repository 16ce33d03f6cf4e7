#include "model/law_programs.hpp"

#include <cassert>
#include <cmath>

#include "base/random_stream.hpp"

namespace myo::model {
namespace {

using law::Node;
using law::Variable;

struct LawSymmetryPolicy {
    int states = 400;           // at which the symmetry of the derivatives is tested
    double tolerance = 1e-9;    // of the asymmetry over the size of the derivatives
    double size_m = 0.2;        // about the origin: where places at rest are drawn
    double least_m = 1e-5;      // displacements, from ...
    double largest_m = 0.1;     // ... to
    double least_m_s = 1e-4;    // velocities, from ...
    double largest_m_s = 10.0;  // ... to
    double end_s = 2.0;         // latest time
    double session_s = 3600.0;  // latest time of the session
    double factor = 5.0;        // on the typical values of parameters
    double gravity_m_s2 = 9.81;
};
constexpr LawSymmetryPolicy law_symmetry_policy;

/// Numbers of the variables by which a force is differentiated, and where the results stand.
struct DerivativeBlock {
    int first, count;
    std::size_t LawPrograms::*place;
};
constexpr DerivativeBlock derivative_blocks[] = {{Variable::x, 3, &LawPrograms::by_x},
                                                 {Variable::v, 3, &LawPrograms::by_v},
                                                 {Variable::n, 3, &LawPrograms::by_n},
                                                 {Variable::area_ratio, 1, &LawPrograms::by_area}};

/// Vector of random direction whose length is drawn evenly over its decades.
Eigen::Vector3d drawn_vector(RandomStream& random, double least, double largest) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return random.log_uniform(least, largest) * Eigen::Vector3d(x, y, z).normalized();
}

/// A state at which a force may be evaluated, one value per variable.
std::vector<double> drawn_state(const law::Law& law, const Eigen::VectorXd& numbers, RandomStream& random) {
    const LawSymmetryPolicy& policy = law_symmetry_policy;
    std::vector<double> state(static_cast<std::size_t>(law.variable_count), 0.0);
    const auto set = [&](int first, const Eigen::Vector3d& value) {
        for (int i = 0; i < 3; ++i) state[static_cast<std::size_t>(first + i)] = value(i);
    };
    const double a = random.uniform(-1.0, 1.0), b = random.uniform(-1.0, 1.0), c = random.uniform(-1.0, 1.0);
    const Eigen::Vector3d X = policy.size_m * Eigen::Vector3d(a, b, c);
    set(Variable::X, X);
    set(Variable::x, X + drawn_vector(random, policy.least_m, policy.largest_m));
    set(Variable::v, drawn_vector(random, policy.least_m_s, policy.largest_m_s));
    set(Variable::n, drawn_vector(random, 1.0, 1.0));
    set(Variable::gravity, drawn_vector(random, policy.gravity_m_s2, policy.gravity_m_s2));
    state[Variable::area_ratio] = 1.0;
    state[Variable::t] = random.uniform(0.0, policy.end_s);
    state[Variable::session_time] = random.uniform(0.0, policy.session_s);
    Eigen::Index k = 0;
    for (const law::Law::Parameter& parameter : law.parameters)
        for (int i = 0; i < parameter.count(); ++i)
            state[static_cast<std::size_t>(parameter.variable + i)] = numbers(k++) *
                                                                      random.log_uniform(1.0 / policy.factor,
                                                                                         policy.factor);
    for (const law::Law::Condition& condition : law.conditions)
        state[static_cast<std::size_t>(condition.variable)] = random.uniform(0.0, 1.0);
    return state;
}

/// Whether the derivatives by place and velocity are symmetric wherever they were looked at.
bool is_symmetric(const LawPrograms& programs, const Eigen::VectorXd& numbers) {
    RandomStream random({1});
    for (int k = 0; k < law_symmetry_policy.states; ++k) {
        const std::vector<double> values = law::run_once(programs.tangent, drawn_state(programs.law, numbers, random));
        for (const std::size_t block : {programs.by_x, programs.by_v}) {
            // The force does not depend on this variable.
            if (block == 0) continue;
            double size = 0.0, skew = 0.0;
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) {
                    size = std::max(size, std::abs(values[block + 3 * i + j]));
                    skew = std::max(skew, std::abs(values[block + 3 * i + j] - values[block + 3 * j + i]));
                }
            if (std::isfinite(size) && skew > law_symmetry_policy.tolerance * size) return false;
        }
    }
    return true;
}

/// Force at a state whose displacement and velocity are multiplied.
Eigen::Vector3d scaled_force(const LawPrograms& programs, std::vector<double> state, double factor) {
    for (std::size_t i = 0; i < 3; ++i) {
        state[Variable::v + i] *= factor;
        state[Variable::x + i] = state[Variable::X + i] + factor * (state[Variable::x + i] - state[Variable::X + i]);
    }
    const std::vector<double> force = law::run_once(programs.force, state);
    return {force[0], force[1], force[2]};
}

/// Power to which the force grows with displacement or velocity wherever it was looked at; 0: there is none.
double degree_of(const LawPrograms& programs, const Eigen::VectorXd& numbers) {
    if (programs.potential != LawPotential::of_positions && programs.potential != LawPotential::of_velocity) return 0.0;
    RandomStream random({2});
    double degree = 0.0;
    for (int k = 0; k < law_symmetry_policy.states; ++k) {
        const std::vector<double> state = drawn_state(programs.law, numbers, random);
        const Eigen::Vector3d here = scaled_force(programs, state, 1.0), there = scaled_force(programs, state, 2.0);
        // Twice the displacement or velocity: the first state gives the power, all others must agree with it.
        if (k == 0) degree = std::log2(there.norm() / here.norm());
        const double miss = (there - std::exp2(degree) * here).norm();
        if (!(degree > 0.0) || !(miss <= law_symmetry_policy.tolerance * there.norm())) return 0.0;
    }
    return degree;
}

/// True of a force with a potential of places, and of one that was against the velocity wherever it was looked at.
bool keeps_energy(const LawPrograms& programs, const Eigen::VectorXd& numbers) {
    if (programs.potential == LawPotential::energy || programs.potential == LawPotential::of_positions) return true;
    if (programs.potential != LawPotential::of_velocity) return false;
    RandomStream random({3});
    for (int k = 0; k < law_symmetry_policy.states; ++k) {
        const std::vector<double> state = drawn_state(programs.law, numbers, random);
        const Eigen::Map<const Eigen::Vector3d> v(state.data() + Variable::v);
        if (!(scaled_force(programs, state, 1.0).dot(v) <= 0.0)) return false;
    }
    return true;
}

/// Form of the potential. Forces that follow the normal or the area of a face are taken to have none.
LawPotential potential_of(const LawPrograms& programs, const Eigen::VectorXd& numbers) {
    if (programs.law.is_energy) return LawPotential::energy;
    if (programs.uses_n || programs.uses_area || !is_symmetric(programs, numbers)) return LawPotential::none;
    if (!programs.uses_v) return LawPotential::of_positions;
    return programs.uses_x ? LawPotential::of_both : LawPotential::of_velocity;
}

}  // namespace

std::shared_ptr<const LawPrograms> law_programs(law::Law law, const Eigen::VectorXd& numbers) {
    assert(numbers.size() == law.number_count());
    auto programs = std::make_shared<LawPrograms>();
    law::Expressions& e = law.expressions;
    std::vector<Node> force(law.result.begin(), law.result.end());
    // The force is minus the gradient of the energy; the energy itself is the fourth output.
    if (law.is_energy) {
        for (int i = 0; i < 3; ++i)
            force[static_cast<std::size_t>(i)] = e.make(law::Operation::negate,
                                                        e.derivative(law.result[0], Variable::x + i));
        force.push_back(law.result[0]);
    }
    programs->force = law::Program(e, force);
    const auto uses = [&](int first, int count) {
        for (int i = first; i < first + count; ++i)
            if (programs->force.uses(i)) return true;
        return false;
    };
    programs->uses_x = uses(Variable::x, 3);
    programs->uses_v = uses(Variable::v, 3);
    programs->uses_n = law.place != law::Place::point && uses(Variable::n, 3);
    programs->uses_area = uses(Variable::area_ratio, 1);
    programs->uses_time = uses(Variable::t, 1);
    // Only derivatives by variables that the force contains; the others are zero and need no outputs.
    std::vector<Node> tangent = force;
    for (const DerivativeBlock& block : derivative_blocks) {
        if (!uses(block.first, block.count)) continue;
        (*programs).*block.place = tangent.size();
        for (std::size_t i = 0; i < 3; ++i)
            for (int j = 0; j < block.count; ++j) tangent.push_back(e.derivative(force[i], block.first + j));
    }
    programs->tangent = law::Program(e, tangent);
    std::vector<Node> by_number;
    for (const law::Law::Parameter& parameter : law.parameters)
        for (int k = 0; k < parameter.count(); ++k)
            for (std::size_t i = 0; i < 3; ++i) by_number.push_back(e.derivative(force[i], parameter.variable + k));
    programs->by_number = law::Program(e, by_number);
    programs->law = std::move(law);
    // In this order: the degree and the sign of the power depend on the form of the potential.
    programs->potential = potential_of(*programs, numbers);
    programs->degree = degree_of(*programs, numbers);
    programs->keeps_energy = keeps_energy(*programs, numbers);
    return programs;
}

}  // namespace myo::model
