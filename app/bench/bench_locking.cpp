#include <utility>

#include "base/text.hpp"
#include "bench/beam_statics.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {
namespace {

/// Deflection at three Poisson's ratios. Locking shows as one that is too small at nu close to 1/2 but correct at 0.3.
Result<BenchFigures> locking(const BenchBeam& beam) {
    BenchFigures figures;
    for (const ConvergedBeam& converged : converged_beam) {
        const Result<double> dz = measured_tip_dz_mm(static_beam(beam, converged.poissons_ratio), figures);
        if (!dz) return dz.error();
        figures.quantities.push_back(
            {"tip under gravity, nu " + format_number(converged.poissons_ratio), *dz, "mm", converged.dz_mm});
    }
    figures.name = std::to_string(figures.dofs) + " DOF, " + to_string(beam.element) + ", statics";
    return figures;
}

}  // namespace

BenchCase bench_locking() {
    BenchCase result{"locking",
                     "deflection of the soft beam's tip under gravity (neo-Hookean, statics) with every element, "
                     "against converged values",
                     {}};
    for (const std::string& id : fem::element_ids()) {
        BenchBeam beam;
        fem::parse_element(id, beam.element);
        // Near-cubic cells from 2 to 14 layers.
        for (const auto& [length, width] : {std::pair{7, 2}, {10, 3}, {13, 4}, {20, 6}, {23, 7}, {32, 9}, {46, 14}}) {
            if (fem::cell_type(beam.element) == mesh::CellType::tet10 && width > 7)
                continue;  // quadratic elements have as many nodes as linear ones with twice the cells
            beam.cells = {length, width, width};
            result.runs.push_back({id + ", " + std::to_string(width) + " layers", [beam] { return locking(beam); }});
        }
    }
    return result;
}

}  // namespace myo::bench
