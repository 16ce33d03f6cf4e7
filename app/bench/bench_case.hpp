#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "dynamics/stage.hpp"

namespace myo::bench {

/// A figure of another simulator for the same case, with its source.
struct BenchReference {
    std::string label;
    double ms_per_step = 0.0;
};

/// A physical result of a run beside what it should be.
struct BenchQuantity {
    std::string name;  // "tip under gravity, nu 0.499"
    double value = 0.0;
    std::string unit;                // as shown: "mm", "%"
    std::optional<double> expected;  // same unit, from elsewhere
    std::optional<double> target{};  // largest relative error aimed at

    /// Relative to what is expected.
    std::optional<double> error() const {
        return expected ? std::optional<double>(value / *expected - 1.0) : std::nullopt;
    }
};

/// What one run of a case measured. Times are processor time of the one thread that ran it.
struct BenchFigures {
    std::string name;  // "release, 4,608 DOF, hex8_full, residual 1e-6"
    int dofs = 0;
    int cells = 0;
    int steps = 0;  // 0: statics
    double h_s = 0.0;
    double setup_s = 0.0;  // mesh, patterns, mass
    double run_s = 0.0;
    double iterations_per_step = 0.0;
    double factorisations_per_step = 0.0;
    double limit_ms = 0.0;  // passes over factor and elements at the measured bandwidth; 0: not given
    double factor_bytes = 0.0;
    dynamics::SolverTimes times;    // of the run
    std::optional<double> goal_ms;  // per step
    std::vector<BenchReference> references;
    std::vector<BenchQuantity> quantities;  // what came out, where the case is about that
    std::string note;                       // for a person, below the row

    double ms_per_step() const { return steps > 0 ? 1e3 * run_s / steps : 0.0; }
    /// Simulated time over processor time.
    double real_time_factor() const { return run_s > 0.0 ? steps * h_s / run_s : 0.0; }
    double us_per_dof_and_step() const { return dofs > 0 ? 1e3 * ms_per_step() / dofs : 0.0; }
    /// The limit over the time that was needed; 0: not given.
    double share_of_limit() const { return ms_per_step() > 0.0 ? limit_ms / ms_per_step() : 0.0; }
};

/// A benchmark: a file bench_<id>.cpp and a line in catalogue.cpp. Each of its runs measures one row and can be run in
/// a process of its own, so that peak memory is its own too.
struct BenchRun {
    std::string name;
    std::function<Result<BenchFigures>()> run;
};
struct BenchCase {
    std::string id;
    std::string summary;
    std::vector<BenchRun> runs;
    bool over_size = false;  // rows differ in size alone: exponents of time and memory over it are fitted
};

const std::vector<BenchCase>& bench_catalogue();
std::vector<std::string> bench_ids();

}  // namespace myo::bench
