#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_elements() {
    BenchCase result{
        "elements", "the default step (neo-Hookean, damped, TR-BDF2, h = 10 ms, 40 steps) with every element", {}};
    for (const std::string& id : fem::element_ids()) {
        // Ids of the catalogue of elements: a new one gets a row.
        BenchBeam beam;
        fem::parse_element(id, beam.element);
        beam.damping_s = 0.003;
        // Meshes with similar numbers of nodes, so that the time per step compares the elements.
        beam.cells = fem::cell_type(beam.element) == mesh::CellType::hex8   ? Eigen::Vector3i(23, 7, 7)
                     : fem::cell_type(beam.element) == mesh::CellType::tet4 ? Eigen::Vector3i(20, 6, 6)
                                                                            : Eigen::Vector3i(10, 3, 3);
        result.runs.push_back({id, [beam] {
                                   return measure_run("TR-BDF2, residual 1e-6", beam,
                                                      bench_options(dynamics::Integrator::tr_bdf2, 0.01, 40, 1e-6));
                               }});
    }
    return result;
}

}  // namespace myo::bench
