#include <gtest/gtest.h>

#include <cmath>

#include "bench/beam_statics.hpp"
#include "support/figures.hpp"

namespace myo::bench {
namespace {

double tip_error(const BenchBeam& beam, const ConvergedBeam& converged) {
    BenchFigures figures;
    const Result<double> dz = measured_tip_dz_mm(static_beam(beam, converged.poissons_ratio), figures);
    EXPECT_TRUE(dz) << dz.error().text();
    return *dz / converged.dz_mm - 1.0;
}

/// The default elements are within 1 % of the converged tip at every Poisson's ratio: hex8 on the paper's mesh, tet10
/// on three layers.
TEST(Locking, DefaultElementsMeetTheConvergedTipAtEveryPoissonsRatio) {
    for (const ConvergedBeam& converged : converged_beam)
        for (const BenchBeam& beam :
             {BenchBeam{fem::ElementKind::hex8, {23, 7, 7}}, BenchBeam{fem::ElementKind::tet10, {10, 3, 3}}}) {
            const double error = tip_error(beam, converged);
            test::record("error_" + to_string(beam.element) + "_nu" + format_number(converged.poissons_ratio), error);
            EXPECT_LT(std::abs(error), 0.01) << to_string(beam.element) << " nu " << converged.poissons_ratio;
        }
}

/// What locks does so by Poisson's ratio, not by bending: the same mesh is far better at 0.3.
TEST(Locking, ComparisonElementsLockAsPoissonsRatioGrows) {
    for (const fem::ElementKind element : {fem::ElementKind::hex8_full, fem::ElementKind::tet4}) {
        const BenchBeam beam{element, {13, 4, 4}};
        double before = 0.0;
        for (const ConvergedBeam& converged : converged_beam) {
            const double error = tip_error(beam, converged);
            test::record("error_" + to_string(element) + "_nu" + format_number(converged.poissons_ratio), error);
            EXPECT_LT(error, before - 0.03) << to_string(element) << " nu " << converged.poissons_ratio;
            before = error;
        }
        EXPECT_LT(before, -0.5);
    }
}

}  // namespace
}  // namespace myo::bench
