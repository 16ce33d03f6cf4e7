#include <gtest/gtest.h>

#include <numbers>

#include "support/experiment_folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::setup {
namespace {

using testing_support::replaced;

/// The beam of 7.3 Hz with this many times its modulus, whose damping nobody declares.
setup::Setup beam_without_damping(const test::Folder& folder, const std::string& modulus_Pa) {
    test::swung_beam(folder, 0.1);
    const std::string toml = replaced(test::swung_beam_toml(), "damping_s = 0.004\ncalibrate = [\"youngs_modulus\"]\n",
                                      "");
    folder.write("experiment.toml", replaced(toml, "youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = " + modulus_Pa));
    return test::setup_in(folder);
}

/// A slow body gets that of silicones, a fast one a share of its critical damping: it swings.
TEST(AssumedDamping, LetsFastBodiesSwing) {
    const test::Folder folder("assumed_damping");
    EXPECT_EQ(beam_without_damping(folder, "2.6e5").trials.front().model.damping_s, 0.003);
    setup::Setup fast = beam_without_damping(folder, "2.6e9");
    check_integration(fast);
    const double omega = 2.0 * std::numbers::pi * fast.integration->frequency_Hz;
    EXPECT_GT(fast.integration->frequency_Hz, 700.0);
    EXPECT_NEAR(0.5 * omega * fast.trials.front().model.damping_s, 0.09, 1e-6);
}

}  // namespace
}  // namespace myo::setup
