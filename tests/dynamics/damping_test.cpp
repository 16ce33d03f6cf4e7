#include <gtest/gtest.h>

#include <numbers>

#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo {
namespace {

using Eigen::VectorXd;

using std::numbers::pi;

test::BeamSpec ringing(const char* element) {
    test::BeamSpec spec = test::ringing_beam();
    spec.kind = test::element(element);
    // What tet10 resists at its points besides distortion is not damped: 15, 2.2, 1.2 % less damping with 1, 2, 3 layers.
    if (spec.kind == ElementKind::tet10) spec.cells = {10, 3, 3};
    return spec;
}

/// Kelvin-Voigt: damping ratio damping_s * omega / 2 of small vibrations. The rest of the ratio 2 (1 + nu) / 3 = 0.9993 is
/// volumetric and not damped.
TEST(MaterialDamping, SmallVibrationsHaveTheStatedDampingRatio) {
    for (const char* element : {"hex8", "tet10"})
        for (const double damping : {0.001, 0.004}) {
            test::BeamSpec spec = ringing(element);
            spec.damping_s = damping;
            const Model model = test::held(spec);
            const NaturalMode mode = test::first_mode(model);
            const double h = 2.0 * pi / mode.omega_rad_s / 60.0;
            const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 60);
            ASSERT_GT(q.size(), 0);
            const double error = test::fit_oscillation(q, h).damping_ratio / (0.5 * damping * mode.omega_rad_s) - 1.0;
            test::record(std::string(element) + "_error_at_ms_" + std::to_string(static_cast<int>(1e3 * damping)), error);
            EXPECT_LT(std::abs(error), 0.02) << element << " " << damping;
        }
}

}  // namespace
}  // namespace myo
