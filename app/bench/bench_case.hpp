#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "dynamics/stage.hpp"

namespace myo::bench {

/// Time of another simulator for the same case; the label names it.
struct BenchReference {
    std::string label;
    double ms_per_step = 0.0;
};

/// A physical result of a run with its expected value.
struct BenchQuantity {
    std::string name;  // "tip under gravity, nu 0.499"
    double value = 0.0;
    std::string unit;                // as displayed: "mm", "%"
    std::optional<double> expected;  // same unit, from an independent source
    std::optional<double> target{};  // largest relative error aimed at

    /// Error relative to the expected value.
    std::optional<double> error() const {
        return expected ? std::optional<double>(value / *expected - 1.0) : std::nullopt;
    }
};

/// Measurements of one run of a case. Times are processor time of the single thread that ran it.
struct BenchFigures {
    std::string name;  // "release, 4,608 DOF, hex8_full, residual 1e-6"
    int dofs = 0;
    int cells = 0;
    // Steps of the measured run.
    int steps = 0;         // 0: static case
    double h_s = 0.0;      // time step
    double setup_s = 0.0;  // meshing, sparsity patterns, mass
    double run_s = 0.0;    // of all steps
    double iterations_per_step = 0.0;
    double factorisations_per_step = 0.0;
    double limit_ms = 0.0;                   // memory-bound time per step at the measured bandwidth; 0: unknown
    double factor_bytes = 0.0;               // of the sparse factor
    dynamics::SolverTimes times;             // by part of the solver
    std::optional<double> goal_ms;           // target per step
    std::vector<BenchReference> references;  // of other simulators
    std::vector<BenchQuantity> quantities;   // physical results, if the case compares them
    std::string note;                        // displayed below the row

    /// 0 for a static case.
    double ms_per_step() const { return steps > 0 ? 1e3 * run_s / steps : 0.0; }
    /// Simulated time over processor time.
    double real_time_factor() const { return run_s > 0.0 ? steps * h_s / run_s : 0.0; }
    double us_per_dof_and_step() const { return dofs > 0 ? 1e3 * ms_per_step() / dofs : 0.0; }
    /// Memory-bound time over measured time; 0: unknown.
    double share_of_limit() const { return ms_per_step() > 0.0 ? limit_ms / ms_per_step() : 0.0; }
};

/// One row of a benchmark. A run can execute in its own process, so that its peak memory is its own.
///
/// Errors: a run did not complete, or its data cannot be read; the other rows go on.
struct BenchRun {
    std::string name;
    std::function<Result<BenchFigures>()> run;
};
/// A benchmark: a file bench_<id>.cpp and a line in catalogue.cpp.
struct BenchCase {
    std::string id;
    std::string summary;
    std::vector<BenchRun> runs;
    bool over_size = false;  // rows differ in size only: exponents of time and memory are fitted
};

/// All benchmarks, in the order in which they run.
const std::vector<BenchCase>& bench_catalogue();
/// Ids of all benchmarks.
std::vector<std::string> bench_ids();

}  // namespace myo::bench
