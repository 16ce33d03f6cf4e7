#include <gtest/gtest.h>

#include "app/small_experiment.hpp"
#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"
#include "support/setup_of_folder.hpp"

namespace myo::setup {
namespace {

/// The muscled block with these signals, run with steps of 5 ms.
setup::Setup muscled_setup(const std::string& signals) {
    const test::Folder folder("switched_signal");
    std::string trace = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    for (int k = 0; k <= 40; ++k) trace += std::to_string(0.01 * k) + ",0.04,0.01,0.02,0.02,0.01,0.02\n";
    folder.write("experiment.toml", test::muscled_toml());
    folder.write("signals.csv", signals);
    folder.write("wave.csv", trace);
    SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    settings.h_s = 0.005;
    return test::setup_of_folder(folder, settings);
}

/// Also of a muscle that follows another.
TEST(SwitchedSignal, OfAFileIsAJumpOfTheTrialsModel) {
    for (const char* rows : {"0,1\n0.1,1\n0.100001,0.9\n", "0,1\n0.1,1\n0.1,0.9\n"}) {
        const std::vector<fibre::Signal>
            activation = muscled_setup(std::string("time_s,upper\n") + rows).trials.front().model.activation;
        ASSERT_EQ(activation.size(), 2u);
        for (const fibre::Signal& signal : activation) {
            EXPECT_EQ(signal.jumps(), std::vector<double>{0.1});
            EXPECT_EQ(signal.value_before(0.1), 1.0);
        }
        EXPECT_NEAR(activation[0].value(0.1), 0.9, 1e-12);
        EXPECT_NEAR(activation[1].value(0.1), 1.05, 1e-12);
    }
}

TEST(SwitchedSignal, ARampOfSeveralStepsStaysOne) {
    const setup::Setup setup = muscled_setup("time_s,upper\n0,1\n0.1,1\n0.13,0.9\n");
    EXPECT_TRUE(setup.trials.front().model.activation.front().jumps().empty());
}

}  // namespace
}  // namespace myo::setup
