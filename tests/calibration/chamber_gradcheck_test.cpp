#include <gtest/gtest.h>

#include "calibration/gradcheck.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

namespace myo::calibration {
namespace {

/// The adjoint gradient by every knot of a recorded pressure and by a free level.
TEST(ChamberGradient, AgreesWithDifferences) {
    const test::Folder folder("chamber_gradient");
    setup::Setup setup = test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.trials[0].actuation_steps = {{"upper", std::nullopt}};
        e.material.calibrate = {"actuation_level"};
    });
    std::vector<double> errors;
    for (const bool recorded : {false, true}) {
        setup::PreparedTrial& trial = setup.trials[0];
        if (recorded) {
            trial.free_levels.clear();
            trial.recorded_commands = {{{-0.1, 0.0, 0.004, 0.02, 0.5}, {0.0, 1000.0, 2500.0, 4000.0, 4000.0}}};
            setup::set_step(trial, trial.options.h_s);
        }
        const TrialGradientCheck check = gradcheck(setup, 0, 3);
        ASSERT_TRUE(check.check.complete()) << check.check.message;
        int pressures = 0;
        for (const sensitivity::GradientCheckRow& row : check.check.rows)
            pressures += row.name.find("pressure_Pa") != std::string::npos;
        EXPECT_EQ(pressures, recorded ? 3 : 2) << "knots that act on the run";
        errors.push_back(check.check.median_error());
        EXPECT_LE(errors.back(), 1e-6);
    }
    test::record("median_errors", errors);
}

}  // namespace
}  // namespace myo::calibration
