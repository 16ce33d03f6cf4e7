#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "measurement/gaps.hpp"
#include "measurement/swinging_markers.hpp"
#include "measurement/trace_csv.hpp"
#include "support/folder.hpp"

// [[trial.repair]]: repairs of a recording by hand, which every command applies on reading.

namespace myo::experiment {
namespace {

using Eigen::Index;
using testing::HasSubstr;

class Repairs : public testing::Test {
protected:
    Repairs() : folder_("repairs") {
        recording_.labels = {"m0", "m1", "m2", "m3", "m4"};
        recording_.tracks = test::swinging_markers(1e-4, 1);
        recording_.time_s = Eigen::VectorXd::LinSpaced(120, 0.0, 1.19);
        EXPECT_TRUE(measurement::write_trace_csv(folder_.path() / "swing.csv", recording_));
    }

    /// An experiment whose trial has these tables.
    Result<Experiment> with(const std::string& repairs) {
        std::string text =
            "schema = \"experiment/1\"\nname = \"beam\"\n[geometry]\nkind = \"box\"\nsize_m = [0.12, 0.03, 0.02]\n"
            "[clamp]\nbox_m = [[-0.001, -0.001, -0.001], [0.001, 0.04, 0.03]]\n[material]\nmodel = \"neo_hookean\"\n"
            "youngs_modulus_Pa = 2e5\npoissons_ratio = 0.4\ndensity_kg_m3 = 1000\n[markers.rest_m]\n";
        for (int m = 0; m < 5; ++m)
            text += "m" + std::to_string(m) + " = [" + std::to_string(0.024 * (1 + m)) + ", 0.0, 0.01]\n";
        text +=
            "[[trial]]\nname = \"swing\"\nrole = \"fit\"\ntrace = \"swing.csv\"\nformat = \"csv\"\n"
            "start = \"straight\"\n";
        folder_.write("experiment.toml", text + repairs);
        return read_experiment(folder_.path());
    }
    std::string refused(const std::string& repairs) {
        const Result<Experiment> read = with(repairs);
        if (!read) return read.error().text();
        const Result<TrialRecording> trial = read_trial(*read, read->trials[0]);
        return trial ? "read" : trial.error().text();
    }

    test::Folder folder_;
    measurement::Recording recording_;
};

const std::string cut = "[[trial.repair]]\nkind = \"cut\"\nmarker = \"m2\"\nfrom_s = 0.3\nto_s = 0.33\n";
const std::string fill = "[[trial.repair]]\nkind = \"fill\"\nmarker = \"m2\"\nfrom_s = 0.0\nto_s = 1.19\n";

TEST_F(Repairs, AreMadeInOrderAndTold) {
    const Result<Experiment> gap = with(cut), filled = with(cut + fill);
    ASSERT_TRUE(gap) << gap.error().text();
    ASSERT_TRUE(filled) << filled.error().text();
    ASSERT_EQ(filled->trials[0].repairs.size(), 2u);
    const Result<TrialRecording> with_gap = read_trial(*gap, gap->trials[0]);
    const Result<TrialRecording> without = read_trial(*filled, filled->trials[0]);
    ASSERT_TRUE(with_gap) << with_gap.error().text();
    ASSERT_TRUE(without) << without.error().text();
    for (Index t = 30; t < 34; ++t) {
        EXPECT_FALSE(measurement::is_seen(with_gap->recording.tracks[2], t)) << t;
        EXPECT_LT((without->recording.tracks[2].col(t) - recording_.tracks[2].col(t)).norm(), 2e-3) << t;
        EXPECT_NE(without->recording.tracks[2].col(t), recording_.tracks[2].col(t));
    }
    ASSERT_EQ(without->warnings.size(), 2u);
    EXPECT_EQ(without->warnings[0], "trial[0].repair[0]: repaired by hand: cut \"m2\" from 0.3 s to 0.33 s, 4 samples");
    EXPECT_THAT(without->warnings[1], HasSubstr("trial[0].repair[1]: repaired by hand: filled the gaps of \"m2\""));
}

TEST_F(Repairs, WrongOnesAreRefusedAtTheirLine) {
    const auto repair = [](const std::string& lines) { return "[[trial.repair]]\n" + lines; };
    EXPECT_THAT(refused(repair("kind = \"erase\"\nmarker = \"m2\"\nfrom_s = 0.1\nto_s = 0.2\n")),
                HasSubstr("trial[0].repair[0].kind"));
    EXPECT_THAT(refused(repair("kind = \"cut\"\nmarker = \"n2\"\nfrom_s = 0.1\nto_s = 0.2\n")),
                HasSubstr("trial[0].repair[0]: no marker \"n2\""));
    EXPECT_THAT(refused(repair("kind = \"cut\"\nmarker = \"n2\"\nfrom_s = 0.1\nto_s = 0.2\n")), HasSubstr(".toml:"));
    EXPECT_THAT(refused(repair("kind = \"cut\"\nmarker = \"m2\"\nfrom_s = 0.3\nto_s = 0.2\n")),
                HasSubstr("to_s: lies before from_s (0.2 < 0.3)"));
    EXPECT_THAT(refused(repair("kind = \"cut\"\nmarker = \"m2\"\nfrom_s = 7.0\nto_s = 8.0\n")),
                HasSubstr("no sample lies from 7 s to 8 s"));
    EXPECT_THAT(refused(repair("kind = \"cut\"\nmarker = \"m2\"\nwith = \"m1\"\nfrom_s = 0.1\nto_s = 0.2\n")),
                HasSubstr("belongs to kind = \"swap\""));
    EXPECT_THAT(refused(repair("kind = \"smooth\"\nmarker = \"m2\"\nfrom_s = 0.1\nto_s = 0.2\n")),
                HasSubstr("window_s"));
    EXPECT_THAT(refused(repair("kind = \"swap\"\nmarker = \"m2\"\nfrom_s = 0.1\nto_s = 0.2\n")), HasSubstr("with"));
    EXPECT_EQ(refused(cut), "read");
}

}  // namespace
}  // namespace myo::experiment
