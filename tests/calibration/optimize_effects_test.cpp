#include <gtest/gtest.h>

#include <cmath>

#include "calibration/optimize.hpp"
#include "prediction/trial_target.hpp"
#include "support/figures.hpp"
#include "support/muscle_beam.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Commands of the muscle every 0.1 s, linear in between.
const std::vector<double> commanded{1.0, 0.8, 0.85, 1.1};

const std::string creep = "\n[[effect]]\nid = \"viscoelastic_creep\"\nmodulus_ratio = 0.3\nrelaxation_time_s = 0.08\n";
const std::string lag = "\n[[effect]]\nid = \"actuation_lag\"\ntime_constant_s = 0.06\n";
const std::string hysteresis = "\n[[effect]]\nid = \"actuation_hysteresis\"\nfraction = 0.4\nwidth = 0.1\n";

/// The beam moved by its muscle, with these declared effects. Its recording is the motion under the commands.
setup::Setup moved_beam(const test::Folder& folder, const std::string& effects) {
    std::string signal = "time_s,up\n";
    for (std::size_t k = 0; k < commanded.size(); ++k)
        signal += std::to_string(0.1 * static_cast<double>(k)) + "," + std::to_string(commanded[k]) + "\n";
    Result<setup::Setup> whole = test::muscle_beam_setup(folder, test::muscle_beam_toml() + effects, signal, 0.0, 0.3);
    EXPECT_TRUE(whole) << whole.error().text();
    setup::Setup setup = prediction::with_one_trial(std::move(*whole), 0);
    const prediction::TrialPrediction motion = prediction::predict_trial(setup, 0, prediction::declared_values(setup));
    EXPECT_TRUE(motion.ok()) << motion.message;
    setup.trials[0].measured.tracks = motion.positions_m;
    return setup;
}

OptimizeSettings settings() {
    OptimizeSettings settings;
    settings.frequency_Hz = 10.0;
    settings.smoothness_m_s = 1e-7;
    return settings;
}

/// The gradient by the commands, through what the actuators make of them and what the body remembers.
void expect_gradient(const std::string& effects, double h, double bound) {
    const test::Folder folder("optimize_gradient");
    const setup::Setup setup = moved_beam(folder, effects);
    Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings());
    ASSERT_TRUE(problem) << problem.error().text();
    problem->options.solver.tolerance = problem->options.solver.tangent_tolerance = 1e-11;
    MatrixXd values(1, static_cast<Index>(commanded.size()));
    values << 0.95, 0.9, 0.9, 1.05;
    const inverse::ActuationEvaluation here = inverse::evaluate_actuation(*problem, values);
    ASSERT_TRUE(here.ok()) << here.message;
    std::vector<double> errors;
    for (Index k = 0; k < values.size(); ++k) {
        const auto loss = [&](double by) {
            MatrixXd changed = values;
            changed(k) += by;
            const inverse::ActuationEvaluation there = inverse::evaluate_actuation(*problem, changed);
            EXPECT_TRUE(there.ok()) << there.message;
            return there.loss_m2;
        };
        const double difference = (8.0 * (loss(h) - loss(-h)) - (loss(2.0 * h) - loss(-2.0 * h))) / (12.0 * h);
        errors.push_back(std::abs(here.gradient(k) / difference - 1.0));
        EXPECT_LT(errors.back(), bound) << "knot " << k;
    }
    test::record("relative_errors", errors);
}

TEST(OptimizeWithEffects, HasTheGradientOfItsCommands) { expect_gradient(creep + lag, 1e-3, 1e-5); }
TEST(OptimizeWithEffects, HasTheGradientThroughHysteresis) { expect_gradient(creep + lag + hysteresis, 1e-4, 1e-4); }

/// With the effects declared the commands are found that made the motion; without them others are, and miss it.
TEST(OptimizeWithEffects, FindsTheCommandsAndNotWhatActs) {
    const test::Folder folder("optimize_recovers");
    setup::Setup setup = moved_beam(folder, creep + lag);
    const auto search = [&](const setup::Setup& in) {
        const Result<inverse::ActuationProblem> problem = actuation_problem(in, settings());
        EXPECT_TRUE(problem) << problem.error().text();
        return search_signals(in, *problem, settings(), inverse::unmoved_values(problem->sought));
    };
    const Optimization found = search(setup);
    ASSERT_TRUE(found.usable());
    for (std::size_t k = 0; k + 1 < commanded.size(); ++k)
        EXPECT_NEAR(found.fit.values(0, static_cast<Index>(k)), commanded[k], 0.01) << "knot " << k;
    setup.experiment.effects.clear();
    const Optimization blind = search(setup);
    ASSERT_TRUE(blind.usable());
    EXPECT_GT(blind.fit.best.rms_m, 10.0 * found.fit.best.rms_m);
    EXPECT_GT(std::abs(blind.fit.values(0, 1) - commanded[1]), 0.02);
    test::record("rms_m", std::vector<double>{found.fit.best.rms_m, blind.fit.best.rms_m});
}

TEST(OptimizeWithEffects, RefusesWhatOnlyChangesTheView) {
    const test::Folder folder("optimize_view");
    const setup::Setup setup = moved_beam(folder, "\n[[effect]]\nid = \"scale_error\"\nrelative_error = 0.02\n");
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings());
    ASSERT_FALSE(problem);
    EXPECT_NE(problem.error().what.find("\"scale_error\" changes what is seen"), std::string::npos)
        << problem.error().text();
}

}  // namespace
}  // namespace myo::calibration
