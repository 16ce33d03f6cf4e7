#pragma once

#include <array>
#include <vector>

#include "law/expressions.hpp"

namespace myo::law {

/// Values of a term at several places.
using Lanes = std::array<double, 8>;
inline constexpr std::size_t lane_count = std::tuple_size_v<Lanes>;

/// Expressions as a list of instructions that is run for several places at once.
class Program {
public:
    /// Registers of one run; constants are set. One per thread.
    using Registers = std::vector<Lanes>;

    Program() = default;
    Program(const Expressions& expressions, const std::vector<Node>& outputs);

    Registers registers() const;
    /// Where the values of a variable go before a run; null: the outputs do not depend on it.
    Lanes* input(Registers& registers, int variable) const;
    /// Whether any output depends on the variable.
    bool uses(int variable) const;
    void run(Registers& registers) const;
    /// Values of an output after a run.
    const Lanes& output(const Registers& registers, std::size_t output) const {
        return registers[static_cast<std::size_t>(outputs_[output])];
    }
    std::size_t output_count() const { return outputs_.size(); }

private:
    struct Instruction {
        Operation operation;
        int to, a, b, c;  // registers
    };
    struct Constant {
        int to;
        double value;
    };

    int count_ = 0;  // of registers
    std::vector<Constant> constants_;
    std::vector<int> inputs_;  // register per variable; -1: not used
    std::vector<Instruction> instructions_;
    std::vector<int> outputs_;
};

/// Values of all outputs at one place.
///
/// @param variables  one per variable number; those that the outputs do not use may be missing
std::vector<double> run_once(const Program& program, const std::vector<double>& variables);

}  // namespace myo::law
