#include "law/program.hpp"

#include <cmath>

namespace myo::law {
namespace {

/// Terms on which the outputs depend.
std::vector<bool> needed_terms(const Expressions& expressions, const std::vector<Node>& outputs) {
    std::vector<bool> needed(expressions.size(), false);
    for (const Node output : outputs) needed[static_cast<std::size_t>(output)] = true;
    // Operands precede their term.
    for (std::size_t i = expressions.size(); i-- > 0;) {
        if (!needed[i]) continue;
        const Term& term = expressions.term(static_cast<Node>(i));
        for (const Node operand : {term.a, term.b, term.c})
            if (operand >= 0) needed[static_cast<std::size_t>(operand)] = true;
    }
    return needed;
}

/// Loop of constant length over the lanes, which compilers unroll into vector instructions.
template <class Function>
void each_lane(Lanes& to, const Function& function) {
    for (std::size_t l = 0; l < to.size(); ++l) to[l] = function(l);
}

}  // namespace

Program::Program(const Expressions& expressions, const std::vector<Node>& outputs) {
    const std::vector<bool> needed = needed_terms(expressions, outputs);
    std::vector<int> register_of(expressions.size(), -1);
    // A missing operand reads register 0, which exists whenever there is an instruction; its value is not used.
    const auto at = [&](Node node) { return node < 0 ? 0 : register_of[static_cast<std::size_t>(node)]; };
    for (std::size_t i = 0; i < needed.size(); ++i) {
        if (!needed[i]) continue;
        const Term& term = expressions.term(static_cast<Node>(i));
        // Terms are stored after their operands: their order is an order of evaluation.
        const int to = register_of[i] = count_++;
        if (term.operation == Operation::constant) {
            constants_.push_back({to, term.value});
        } else if (term.operation == Operation::variable) {
            const auto number = static_cast<std::size_t>(term.variable);
            if (inputs_.size() <= number) inputs_.resize(number + 1, -1);
            inputs_[number] = to;
        } else {
            instructions_.push_back({term.operation, to, at(term.a), at(term.b), at(term.c)});
        }
    }
    for (const Node output : outputs) outputs_.push_back(at(output));
}

Program::Registers Program::registers() const {
    Registers registers(static_cast<std::size_t>(count_), Lanes{});
    for (const Constant& constant : constants_) registers[static_cast<std::size_t>(constant.to)].fill(constant.value);
    return registers;
}

bool Program::uses(int variable) const {
    const auto number = static_cast<std::size_t>(variable);
    return number < inputs_.size() && inputs_[number] >= 0;
}

Lanes* Program::input(Registers& registers, int variable) const {
    return uses(variable) ? &registers[static_cast<std::size_t>(inputs_[static_cast<std::size_t>(variable)])] : nullptr;
}

void Program::run(Registers& registers) const {
    for (const Instruction& now : instructions_) {
        Lanes& to = registers[static_cast<std::size_t>(now.to)];
        const Lanes &a = registers[static_cast<std::size_t>(now.a)], &b = registers[static_cast<std::size_t>(now.b)],
                    &c = registers[static_cast<std::size_t>(now.c)];
        // The frequent ones as loops that compilers make vector instructions of.
        switch (now.operation) {
            case Operation::add: each_lane(to, [&](std::size_t l) { return a[l] + b[l]; }); break;
            case Operation::subtract: each_lane(to, [&](std::size_t l) { return a[l] - b[l]; }); break;
            case Operation::multiply: each_lane(to, [&](std::size_t l) { return a[l] * b[l]; }); break;
            case Operation::divide: each_lane(to, [&](std::size_t l) { return a[l] / b[l]; }); break;
            case Operation::ratio: each_lane(to, [&](std::size_t l) { return b[l] == 0.0 ? 0.0 : a[l] / b[l]; }); break;
            case Operation::negate: each_lane(to, [&](std::size_t l) { return -a[l]; }); break;
            case Operation::square_root: each_lane(to, [&](std::size_t l) { return std::sqrt(a[l]); }); break;
            case Operation::less: each_lane(to, [&](std::size_t l) { return a[l] < b[l] ? 1.0 : 0.0; }); break;
            case Operation::choose: each_lane(to, [&](std::size_t l) { return a[l] != 0.0 ? b[l] : c[l]; }); break;
            default: each_lane(to, [&](std::size_t l) { return evaluated(now.operation, a[l], b[l], c[l]); });
        }
    }
}

std::vector<double> run_once(const Program& program, const std::vector<double>& variables) {
    Program::Registers registers = program.registers();
    for (std::size_t i = 0; i < variables.size(); ++i)
        if (Lanes* const lanes = program.input(registers, static_cast<int>(i))) lanes->fill(variables[i]);
    program.run(registers);
    std::vector<double> values;
    for (std::size_t i = 0; i < program.output_count(); ++i) values.push_back(program.output(registers, i).front());
    return values;
}

}  // namespace myo::law
