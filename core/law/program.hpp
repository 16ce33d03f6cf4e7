#pragma once

#include <array>
#include <vector>

#include "law/expressions.hpp"

namespace myo::law {

/// Values of a term at several places; eight doubles fill one AVX-512 or two AVX registers.
using Lanes = std::array<double, 8>;
inline constexpr std::size_t lane_count = std::tuple_size_v<Lanes>;

/// Expressions as a list of instructions that is run for lane_count places at once. Constant after its construction;
/// one program can be run by several threads, each with its own registers.
class Program {
public:
    /// Registers of one run; constants are set. One per thread.
    using Registers = std::vector<Lanes>;

    Program() = default;
    /// @param outputs  nodes of `expressions`, which is read here only; terms that they do not need are left out
    Program(const Expressions& expressions, const std::vector<Node>& outputs);

    /// New registers with constants set and variables at 0.
    Registers registers() const;
    /// Where the values of a variable go before a run; null: the outputs do not depend on it.
    Lanes* input(Registers& registers, int variable) const;
    /// Whether any output depends on the variable.
    bool uses(int variable) const;
    /// Computes all outputs. Inputs stay as set, so that the next run sets only the variables that change.
    void run(Registers& registers) const;
    /// Values of an output after a run.
    /// @param output  index in the outputs given to the constructor
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
