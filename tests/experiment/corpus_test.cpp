#include "support/corpus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "experiment_values.hpp"
#include "measurement/trace_file.hpp"

namespace myo::experiment {
namespace {

TEST(Corpus, ExperimentsHaveTheValuesThatTheFormerProgramRead) {
    test::ValueLines lines;
    for (const std::string name : {"least", "every_key", "surface", "effects"}) {
        const Result<Experiment> read = read_experiment(test::corpus("experiments/" + name + ".toml"));
        ASSERT_TRUE(read) << read.error().text();
        test::ExperimentValues(name, *read, lines).add();
    }
    test::expect_values_of(lines, "experiments/values.txt");
    for (const auto& [key, line] : lines.lines())
        EXPECT_FALSE(key.ends_with(".recording") || key.ends_with(".actuation")) << key << " cannot be read: " << line;
}

TEST(Corpus, AugmentedExperimentHasTheEffectOfItsReport) {
    const Result<Experiment> read = read_experiment(test::corpus("diagnose/experiment_augmented.toml"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->trials.size(), 3u);
    ASSERT_EQ(read->effects.size(), 1u);
    const nlohmann::json named = test::corpus_json("diagnose/report.json").at("verdict").at("effects").at(0);
    EXPECT_EQ(read->effects[0].id, named.at("id"));
    EXPECT_TRUE(read->effects[0].calibrate);
    const double found = named.at("parameters").at("coefficient_kg_m3").get<double>();
    EXPECT_NEAR(std::get<double>(read->effects[0].parameters.at("coefficient_kg_m3")), found, 1e-7 * found);
}

/// The table of simulated markers is a recording, whose difference to the measured one is the reported rms per axis.
TEST(Corpus, SimulatedMarkersAreReadAsARecording) {
    const Result<Experiment> read = read_experiment(test::corpus("experiments/least.toml"));
    ASSERT_TRUE(read) << read.error().text();
    const Result<measurement::Recording> measured = read_trial_recording(*read, read->trials[0]);
    TrialDeclaration as_simulated = read->trials[0];
    as_simulated.trace = test::corpus("simulate/release.csv");
    const Result<measurement::Recording> simulated = read_trial_recording(*read, as_simulated);
    ASSERT_TRUE(measured && simulated);
    ASSERT_EQ(simulated->time_s, measured->time_s);
    double squares = 0.0;
    for (std::size_t i = 0; i < measured->tracks.size(); ++i)
        squares += (simulated->tracks[i] - measured->tracks[i]).squaredNorm();
    const double count = 3.0 * static_cast<double>(measured->tracks.size()) *
                         static_cast<double>(measured->sample_count());
    const double told = test::corpus_json("simulate/simulate.json").at("trials").at(0).at("rms_m").get<double>();
    EXPECT_NEAR(std::sqrt(squares / count), told, 1e-6);
}

/// Jumps were written as rises of a microsecond.
TEST(Corpus, SignalsThatWereFoundAreRead) {
    for (const std::string folder : {"optimize", "optimize_hold"}) {
        const Result<measurement::ActuationTable> table = measurement::read_actuation_csv(
            test::corpus(folder + "/reach_actuation.csv"));
        ASSERT_TRUE(table) << table.error().text();
        EXPECT_TRUE(table->warnings.empty());
        const nlohmann::json signal = test::corpus_json(folder + "/optimize.json").at("signals").at(0);
        EXPECT_EQ(table->muscles, std::vector<std::string>{signal.at("name")});
        const auto values = signal.at("values").get<std::vector<double>>();
        const bool held = folder == "optimize_hold";
        ASSERT_EQ(table->values.cols(), static_cast<Eigen::Index>(held ? 2 * values.size() : values.size() + 1));
        EXPECT_EQ(table->values(0, 0), signal.at("before").get<double>());
        for (std::size_t k = 0; k < values.size(); ++k)
            EXPECT_EQ(table->values(0, static_cast<Eigen::Index>(held ? 2 * k + 1 : k + 1)), values[k]);
    }
}

}  // namespace
}  // namespace myo::experiment
