#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prediction/prediction.hpp"
#include "setup/signal_span.hpp"
#include "support/chambered_beam.hpp"

namespace myo::prediction {
namespace {

using experiment::Experiment;

/// The swung beam with a tendon above its axis, pulled and held.
setup::Setup held_beam(const test::Folder& folder, experiment::TendonDrive drive, double command) {
    return test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.chambers.clear();
        experiment::TendonDeclaration tendon = test::upper_tendon();
        tendon.drive = drive;
        tendon.friction = 0.2;
        e.tendons = {tendon};
        e.trials[0].hold = true;
        e.trials[0].start = experiment::StartState::equilibrium;
        e.trials[0].constant_commands = {{"upper", command}};
    });
}

TEST(Holds, AreOnePoseForAllSamples) {
    const test::Folder folder("tendon_hold");
    const setup::Setup setup = held_beam(folder, experiment::TendonDrive::tension, 6.0);
    ASSERT_EQ(setup.tendons.size(), 1u);
    const std::vector<model::TendonGuide>& guides = setup.tendons[0].route.guides;
    EXPECT_FALSE(guides[0].on_body) << "a guide in the clamp stands still";
    EXPECT_TRUE(guides[3].on_body);
    const TrialPrediction held = predict_trial(setup, 0, declared_values(setup));
    ASSERT_TRUE(held.ok()) << held.message;
    EXPECT_EQ(held.trace.times_s.size(), 1u) << "statics only";
    const Eigen::Matrix3Xd& tip = held.positions_m[0];
    EXPECT_EQ(tip.cols(), 1) << "all samples are measurements of one pose";
    // The tendon lifts the tip against its weight.
    const setup::Setup loose = held_beam(folder, experiment::TendonDrive::tension, 0.0);
    EXPECT_GT(tip(2, 0), predict_trial(loose, 0, declared_values(loose)).positions_m[0](2, 0) + 0.002);
}

/// A thread in a channel follows the material between two guides far apart, as if guides stood close together.
TEST(Holds, AThreadInAChannelBendsTheBodyAsCloseGuidesDo) {
    enum class Path { straight, channel, close_guides };
    const auto tip = [](Path path, experiment::TendonDrive drive) {
        const test::Folder folder("channel_hold");
        const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](Experiment& e) {
            e.chambers.clear();
            const Eigen::Vector3d from(0.0, 0.015, 0.028), to(0.095, 0.015, 0.028);
            experiment::TendonDeclaration tendon;
            tendon.name = "upper";
            tendon.drive = drive;
            tendon.channel = path == Path::channel;
            const int legs = path == Path::close_guides ? 12 : 1;
            tendon.path_m.resize(3, legs + 1);
            for (int i = 0; i <= legs; ++i) tendon.path_m.col(i) = from + (to - from) * i / legs;
            e.tendons = {tendon};
            e.trials[0].hold = true;
            e.trials[0].start = experiment::StartState::equilibrium;
            e.trials[0].constant_commands = {{"upper", drive == experiment::TendonDrive::tension ? 6.0 : 0.008}};
        });
        if (path == Path::channel) {
            EXPECT_EQ(setup::moving_guides(setup.tendons[0]), 1u);
            EXPECT_GT(setup.tendons[0].route.guides.size(), 6u);
        }
        const TrialPrediction held = predict_trial(setup, 0, declared_values(setup));
        EXPECT_TRUE(held.ok()) << held.message;
        return Eigen::Vector3d(held.positions_m[0].col(0));
    };
    for (const auto drive : {experiment::TendonDrive::tension, experiment::TendonDrive::shortening}) {
        const Eigen::Vector3d channel = tip(Path::channel, drive), close = tip(Path::close_guides, drive),
                              straight = tip(Path::straight, drive);
        EXPECT_LT((channel - close).norm(), 5e-5);
        EXPECT_GT((straight - close).norm(), 20.0 * (channel - close).norm());
    }
}

/// A signal in another clock is told of tendons, too.
TEST(TendonSignals, ThatMissTheTrialAreFound) {
    const test::Folder folder("tendon_signal");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.chambers.clear();
        experiment::TendonDeclaration tendon;
        tendon.name = "upper";
        tendon.path_m.resize(3, 2);
        tendon.path_m << 0.0, 0.095, 0.015, 0.015, 0.028, 0.028;
        e.tendons = {tendon};
        folder.write("late.csv", "time_s,upper_N\n50,0\n60,3\n");
        e.trials[0].actuation = folder.path() / "late.csv";
    });
    const std::vector<setup::MissedSignal> missed = setup::missed_signals(setup);
    ASSERT_EQ(missed.size(), 1u);
    EXPECT_EQ(missed[0].actuators, std::vector<std::string>{"upper"});
}

/// Tangents of a hold against central differences, for the modulus.
TEST(Holds, KnowTheirDerivatives) {
    const test::Folder folder("hold_tangent");
    setup::Setup setup = held_beam(folder, experiment::TendonDrive::shortening, 0.002);
    setup.trials[0].options.solver.tolerance = 1e-10;
    setup.trials[0].options.solver.tangent_tolerance = 1e-10;
    const ParameterValues values = declared_values(setup);
    std::vector<ModelParameter> parameters = free_parameters(setup, {"youngs_modulus"});
    ASSERT_FALSE(parameters.empty());
    const ModelParameter& modulus = parameters.front();
    const TrialPrediction here = predict_trial(setup, 0, values, {modulus});
    ASSERT_TRUE(here.ok()) << here.message;
    const double step = 1e-3 * values.youngs_modulus_Pa;
    const auto at = [&](double E) {
        ParameterValues changed = values;
        changed.youngs_modulus_Pa = E;
        return predict_trial(setup, 0, changed).positions_m[0];
    };
    const Eigen::Matrix3Xd difference = (at(values.youngs_modulus_Pa + step) - at(values.youngs_modulus_Pa - step)) /
                                        (2.0 * step);
    EXPECT_GT(difference.norm(), 0.0);
    EXPECT_LT((here.tangents[0][0] - difference).norm(), 1e-4 * difference.norm());
}

}  // namespace
}  // namespace myo::prediction
