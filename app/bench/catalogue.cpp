#include "bench/bench_cases.hpp"

namespace myo::bench {

const std::vector<BenchCase>& bench_catalogue() {
    static const std::vector<BenchCase> cases = {
        bench_release(),    bench_tip_load(),  bench_elements(),
        bench_tetrahedra(), bench_arm(),       bench_threads(),
        bench_tangents(),   bench_backward(),  bench_gradient_memory(),
        bench_scaling(),    bench_published(), bench_locking(),
        bench_converged(),  bench_accuracy(),  bench_default_meshes(),
        bench_actuators(),  bench_holds(),     bench_live(),
        bench_laws(),
    };
    return cases;
}

std::vector<std::string> bench_ids() {
    std::vector<std::string> ids;
    for (const BenchCase& one : bench_catalogue()) ids.push_back(one.id);
    return ids;
}

}  // namespace myo::bench
