#include "setup/signal_span.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/chambered_beam.hpp"
#include "support/experiment_folder.hpp"
#include "support/muscle_beam.hpp"

namespace myo::setup {
namespace {

using testing::HasSubstr;

std::vector<MissedSignal> missed_with(const std::string& signal, double first_s = 0.0, const std::string& start = "") {
    const test::Folder folder("signal_span");
    std::string toml = test::muscle_beam_toml();
    if (!start.empty())
        for (std::size_t at = toml.find("trace ="); at != std::string::npos;
             at = toml.find("trace =", at + start.size() + 8))
            toml.insert(at, start + "\n");
    const Result<setup::Setup> setup = test::muscle_beam_setup(folder, toml, "time_s,up\n" + signal, first_s,
                                                               first_s + 1.0);
    EXPECT_TRUE(setup) << setup.error().text();
    return missed_signals(*setup);
}

TEST(SignalSpan, SignalsWithinTheirTrialAreNotFound) {
    EXPECT_TRUE(missed_with("0.2,1\n0.4,0.8\n").empty());
    EXPECT_TRUE(missed_with("-1,1\n0.5,0.8\n3,0.8\n").empty());
    EXPECT_TRUE(missed_with("0,1\n2,0.8\n").empty());  // a ramp that the trial sees half of
    EXPECT_TRUE(missed_with("-1,1\n2,0.8\n").empty());
    EXPECT_TRUE(missed_with("0,0.8\n").empty());  // constant
    EXPECT_TRUE(missed_with("1000,0.8\n1001,0.8\n").empty());
}

TEST(SignalSpan, FindsSignalsBeforeAfterAndInMilliseconds) {
    for (const char* signal : {"1000.2,1\n1000.4,0.8\n", "-3,1\n-2,0.8\n", "1700000000,1\n1700000001,0.8\n",
                               "0,1\n200,1\n400,0.8\n800,0.8\n"}) {
        const std::vector<MissedSignal> missed = missed_with(signal);
        ASSERT_EQ(missed.size(), 1u) << signal;
        EXPECT_EQ(missed[0].trial, 0u);
        EXPECT_EQ(missed[0].key, "trial[0].actuation");
        EXPECT_EQ(missed[0].actuators, std::vector<std::string>{"up"});
        EXPECT_NEAR(missed[0].end_s, 1.0, 1e-9);
    }
    EXPECT_EQ(missed_with("0,1\n200,1\n400,0.8\n800,0.8\n")[0].clock, SignalClock::milliseconds);
    EXPECT_EQ(missed_with("1700000000,1\n1700000001,0.8\n")[0].clock, SignalClock::unknown);
    EXPECT_EQ(missed_with("1000.2,1\n1000.4,0.8\n", 1000.0, "start_s = 1000")[0].clock, SignalClock::of_the_recording);
}

/// A curve that stands in the experiment has a key of its own.
TEST(SignalSpan, NamesTheCurveThatMissesItsTrial) {
    const test::Folder folder("signal_span_curve");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons = {test::upper_tendon()};
        e.trials[0].constant_commands = {{"upper", 0.0, "tension_N", fibre::Signal{{50.0, 60.0}, {0.0, 3.0}}}};
    });
    const std::vector<MissedSignal> missed = missed_signals(setup);
    ASSERT_EQ(missed.size(), 1u);
    EXPECT_EQ(missed[0].key, "trial[0].tension_N.upper");
    EXPECT_EQ(missed[0].first_s, 50.0);
}

TEST(SignalSpan, ASentenceNamesBothSpansAndTheStart) {
    const test::Folder folder("signal_span");
    std::string toml = test::muscle_beam_toml();
    toml = testing_support::replaced(toml, "actuation = \"s.csv\"", "actuation = \"s.csv\"\nstart_s = 1000");
    toml = testing_support::replaced(toml, "name = \"swing again\"", "name = \"swing again\"\nstart_s = 1000");
    const Result<setup::Setup> setup = test::muscle_beam_setup(folder, toml, "time_s,up\n1000.2,1\n1000.4,0.8\n",
                                                               1000.0, 1001.0);
    ASSERT_TRUE(setup) << setup.error().text();
    const std::vector<MissedSignal> missed = missed_signals(*setup);
    ASSERT_EQ(missed.size(), 1u);
    EXPECT_THAT(missed_signal_sentence(*setup, missed[0]),
                testing::AllOf(HasSubstr("trial[0].actuation: the rows of up run from 1000.2 s to 1000.4 s"),
                               HasSubstr("runs from 0 s to 1 s"), HasSubstr("subtract start_s, 1000 s")));
}

}  // namespace
}  // namespace myo::setup
