#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "support/experiment_folder.hpp"
#include "support/swung_beam.hpp"

// Probes (markers.probe_m): places whose motion is simulated and that no recording holds.

namespace myo::setup {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string with_probe(const std::string& place = "[0.07, 0.015, 0.03]", const std::string& more = "") {
    return testing_support::replaced(test::swung_beam_toml(), "[markers.rest_m]",
                                     more + "[markers.probe_m]\nelbow = " + place + "\n[markers.rest_m]");
}

TEST(Probe, IsInNoRecordingAndChangesNothingThatIsMeasured) {
    const test::Folder folder("probe");
    const setup::Setup without = test::swung_beam(folder);
    folder.write("experiment.toml", with_probe());
    const setup::Setup setup = test::setup_in(folder);
    ASSERT_EQ(setup.marker_names, (std::vector<std::string>{"tip_left", "tip_right", "tip_low", "middle", "elbow"}));
    for (const PreparedTrial& trial : setup.trials) {
        ASSERT_EQ(trial.measured.tracks.size(), 5u);
        EXPECT_TRUE(trial.measured.tracks[4].array().isNaN().all());
        for (std::size_t m = 0; m < 4; ++m) EXPECT_EQ(trial.measured.tracks[m], without.trials[0].measured.tracks[m]);
    }
    EXPECT_THAT(setup.warnings, Not(testing::Contains(HasSubstr("elbow"))));
    EXPECT_EQ(setup.noise_m.head(4), without.noise_m);
}

TEST(Probe, NeedsNoReferenceWhereDisplacementsAreCompared) {
    const test::Folder folder("probe_displacement");
    test::swung_beam(folder);
    std::string text = testing_support::replaced(with_probe(), "noise_m = 1e-4",
                                                 "noise_m = 1e-4\ncompare = \"displacement\"");
    for (const char* name : {"swing", "swing again"})
        text = testing_support::replaced(text, "name = \"" + std::string(name) + "\"",
                                         "name = \"" + std::string(name) + "\"\nstart_s = 0.1");
    folder.write("experiment.toml", text);
    const setup::Setup setup = test::setup_in(folder);
    ASSERT_EQ(setup.trials[0].reference_m.size(), 5u);
    EXPECT_EQ(setup.trials[0].reference_m[4], Eigen::Vector3d(0.07, 0.015, 0.03));
}

TEST(Probe, OfATrialWithoutARecordingMovesFromRest) {
    const test::Folder folder("probe_planned");
    std::string text = with_probe();
    text = text.substr(0, text.find("[[trial]]")) +
           "[[trial]]\nname = \"planned\"\nrole = \"simulate\"\nduration_s = 0.1\nstart = \"straight\"\n";
    folder.write("experiment.toml", testing_support::replaced(text, "noise_m = 1e-4", "compare = \"displacement\""));
    const setup::Setup setup = test::setup_in(folder);
    ASSERT_EQ(setup.trials[0].reference_m.size(), setup.marker_names.size());
    EXPECT_EQ(setup.trials[0].reference_m[0], Eigen::Vector3d(0.1, 0.0, 0.03));
}

TEST(Probe, IsRefusedWithASentenceWhereItCannotServe) {
    const test::Folder folder("probe_refused");
    test::swung_beam(folder);
    const auto error_of = [&](const std::string& toml) {
        folder.write("experiment.toml", toml);
        const Result<experiment::Experiment> read = experiment::read_experiment(folder.path());
        return read ? std::string() : read.error().text();
    };
    EXPECT_THAT(error_of(with_probe("[0.07, 0.015, 0.05]")), HasSubstr("markers.probe_m.elbow"));
    EXPECT_THAT(error_of(testing_support::replaced(with_probe(), "elbow =", "middle =")), HasSubstr("duplicate name"));
    EXPECT_THAT(
        error_of(with_probe() + "[[effect]]\nid = \"marker_offset\"\nmarker = \"elbow\"\nshift_m = [0, 0, 0.001]\n"),
        HasSubstr("unknown marker \"elbow\""));
    EXPECT_THAT(error_of(with_probe("[0.07, 0.015, 0.03]", "[markers.labels]\nelbow = \"e\"\n")),
                HasSubstr("markers.labels.elbow"));
}

}  // namespace
}  // namespace myo::setup
