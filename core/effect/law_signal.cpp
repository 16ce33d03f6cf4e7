#include "effect/law_signal.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>

namespace myo::effect {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using law::Variable;

struct LawSignalPolicy {
    int parts = 4;             // of the time between two samples, which are a quarter of a step of the run apart
    int most_iterations = 20;  // of Newton's method for the stages of a part
    double tolerance = 1e-13;  // of its last step over the size of the states
};
constexpr LawSignalPolicy law_signal_policy;

// Radau IIA of fifth order: Hairer & Wanner 1996, ch. IV.5.
constexpr int stages = Eigen::Matrix3d::RowsAtCompileTime;
const double root6 = std::sqrt(6.0);

/// Nodes c of the method; the last one is the end of the interval.
const std::array<double, stages>& stage_times() {
    static const std::array<double, stages> c{(4.0 - root6) / 10.0, (4.0 + root6) / 10.0, 1.0};
    return c;
}

/// Matrix A of the method. Its last row are the weights (stiffly accurate).
const Eigen::Matrix3d& stage_weights() {
    static const Eigen::Matrix3d A = (Eigen::Matrix3d() << (88.0 - 7.0 * root6) / 360.0,
                                      (296.0 - 169.0 * root6) / 1800.0, (-2.0 + 3.0 * root6) / 225.0,
                                      (296.0 + 169.0 * root6) / 1800.0, (88.0 + 7.0 * root6) / 360.0,
                                      (-2.0 - 3.0 * root6) / 225.0, (16.0 - root6) / 36.0, (16.0 + root6) / 36.0,
                                      1.0 / 9.0)
                                         .finished();
    return A;
}

/// Registers in which the values that do not vary are set.
law::Program::Registers registers_of(const law::Program& program, const std::vector<double>& variables) {
    law::Program::Registers registers = program.registers();
    for (std::size_t i = 0; i < variables.size(); ++i)
        if (law::Lanes* const lanes = program.input(registers, static_cast<int>(i))) lanes->fill(variables[i]);
    return registers;
}

/// The input at an instant.
/// Signal less its passive value, with its slope [1/s].
struct Input {
    double time_s, u, rate;
};

/// Integrates the states of one signal.
class States {
public:
    States(const SignalPrograms& law, const std::vector<double>& variables, const Input& start)
        : law_(law),
          rates_(registers_of(law.rates, variables)),
          signal_(registers_of(law.signal, variables)),
          y_(static_cast<Index>(law.law.states.size())) {
        law::Program::Registers initial = registers_of(law.initial, variables);
        set(law.initial, initial, 0, start);
        law.initial.run(initial);
        for (Index i = 0; i < y_.size(); ++i) y_(i) = law.initial.output(initial, static_cast<std::size_t>(i)).front();
    }

    /// The signal that acts, with the present states.
    double signal(const Input& at) {
        set(law_.signal, signal_, 0, at);
        set_states(law_.signal, signal_, 0, y_);
        law_.signal.run(signal_);
        return law_.signal.output(signal_, 0).front();
    }

    /// Goes on by h from an input that is linear.
    void advance(const Input& from, double h) {
        const Index m = y_.size();
        if (m == 0) return;
        VectorXd Z = VectorXd::Zero(stages * m);
        // Unknowns are the stages less the state, Z = Y - y: differences lose fewer digits than values.
        for (int k = 0; k < law_signal_policy.most_iterations; ++k) {
            // Full Newton: the systems have three times as many unknowns as the law has states, a few.
            const auto [residual, slope] = stage_equations(from, h, Z);
            const VectorXd step = slope.partialPivLu().solve(residual);
            Z -= step;
            const double size = y_.lpNorm<Eigen::Infinity>() + Z.lpNorm<Eigen::Infinity>();
            if (!(step.lpNorm<Eigen::Infinity>() > law_signal_policy.tolerance * size)) break;
        }
        // The last stage is the state at the end of the interval.
        y_ += Z.tail(m);
    }

private:
    /// Sets a variable in one lane; without effect if the program does not use it.
    static void put(const law::Program& program, law::Program::Registers& registers, int variable, std::size_t lane,
                    double value) {
        if (law::Lanes* const lanes = program.input(registers, variable)) (*lanes)[lane] = value;
    }
    /// Sets time, input and its slope in one lane.
    static void set(const law::Program& program, law::Program::Registers& registers, std::size_t lane,
                    const Input& at) {
        put(program, registers, Variable::t, lane, at.time_s);
        put(program, registers, Variable::a, lane, at.u);
        put(program, registers, Variable::rate, lane, at.rate);
    }
    /// Sets the states in one lane.
    void set_states(const law::Program& program, law::Program::Registers& registers, std::size_t lane,
                    const VectorXd& y) const {
        for (Index i = 0; i < y.size(); ++i)
            put(program, registers, law_.law.states[static_cast<std::size_t>(i)].variable, lane, y(i));
    }

    /// Z - h (A x I) f(y + Z) with its derivative by Z; the stages are the lanes of one run.
    std::pair<VectorXd, MatrixXd> stage_equations(const Input& from, double h, const VectorXd& Z) {
        const Index m = y_.size();
        for (std::size_t s = 0; s < stages; ++s) {
            const double later = stage_times()[s] * h;
            set(law_.rates, rates_, s, {from.time_s + later, from.u + later * from.rate, from.rate});
            set_states(law_.rates, rates_, s, y_ + Z.segment(static_cast<Index>(s) * m, m));
        }
        law_.rates.run(rates_);
        VectorXd residual = Z;
        MatrixXd slope = MatrixXd::Identity(stages * m, stages * m);
        const auto output = [&](Index k, Index stage) {
            return law_.rates.output(rates_, static_cast<std::size_t>(k))[static_cast<std::size_t>(stage)];
        };
        for (Index s = 0; s < stages; ++s)
            for (Index r = 0; r < stages; ++r)
                for (Index i = 0; i < m; ++i) {
                    residual(s * m + i) -= h * stage_weights()(s, r) * output(i, r);
                    for (Index j = 0; j < m; ++j)
                        slope(s * m + i, r * m + j) -= h * stage_weights()(s, r) * output(m + m * i + j, r);
                }
        return {residual, slope};
    }

    const SignalPrograms& law_;
    law::Program::Registers rates_, signal_;
    VectorXd y_;
};

}  // namespace

std::shared_ptr<const SignalPrograms> signal_programs(law::Law law) {
    auto programs = std::make_shared<SignalPrograms>();
    law::Expressions& e = law.expressions;
    std::vector<law::Node> initial, rates;
    for (const law::Law::State& state : law.states) {
        initial.push_back(state.initial);
        rates.push_back(state.rate);
    }
    for (const law::Law::State& of : law.states)
        for (const law::Law::State& by : law.states) rates.push_back(e.derivative(of.rate, by.variable));
    programs->initial = law::Program(e, initial);
    programs->rates = law::Program(e, rates);
    programs->signal = law::Program(e, {law.result[0]});
    programs->law = std::move(law);
    return programs;
}

std::vector<double> law_response(const SignalPrograms& law, const std::vector<double>& variables,
                                 const std::vector<double>& times_s, const std::vector<double>& u) {
    States states(law, variables, {0.0, u.front(), 0.0});
    std::vector<double> response{states.signal({0.0, u.front(), 0.0})};
    for (std::size_t k = 1; k < u.size(); ++k) {
        const double width = times_s[k] - times_s[k - 1];
        // No time passes over a jump.
        const double rate = width > 0.0 ? (u[k] - u[k - 1]) / width : 0.0;
        const double h = width / law_signal_policy.parts;
        for (int part = 0; part < law_signal_policy.parts && h > 0.0; ++part)
            states.advance({times_s[k - 1] + part * h, u[k - 1] + part * h * rate, rate}, h);
        response.push_back(states.signal({times_s[k], u[k], rate}));
    }
    return response;
}

}  // namespace myo::effect
