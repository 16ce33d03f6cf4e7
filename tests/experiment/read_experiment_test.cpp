#include "experiment/read_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"
#include "support/shared_data.hpp"

namespace myo::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;

TEST(ReadExperiment, TakesEveryValueOfTheSchema) {
    const Folder folder("good");
    write_files(folder, good_toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const Experiment& e = *read;

    EXPECT_EQ(e.name, "tail");
    const auto& box = std::get<BoxGeometry>(e.geometry);
    EXPECT_EQ(box.size_m, Eigen::Vector3d(0.1, 0.03, 0.03));
    EXPECT_EQ(e.clamp_box_m.highest, Eigen::Vector3d(5e-4, 0.031, 0.031));
    EXPECT_EQ(e.material.youngs_modulus_Pa, 2.6e5);
    EXPECT_EQ(e.material.youngs_modulus_tolerance, 0.25);
    EXPECT_EQ(e.material.damping_s, 0.003);
    EXPECT_THAT(e.material.calibrate, ElementsAre("youngs_modulus", "actuation_level"));
    EXPECT_EQ(e.gravity_m_s2, Eigen::Vector3d(0, 0, -9.8));

    ASSERT_EQ(e.muscles.size(), 2u);
    EXPECT_EQ(std::get<MuscleBox>(e.muscles[0].part).fibre, Eigen::Vector3d::UnitX())
        << "a nearly unit direction is normalised";
    EXPECT_EQ(e.muscles[1].follows->muscle, "left");
    EXPECT_EQ(e.muscles[1].follows->ratio, -0.5);

    EXPECT_FALSE(e.registration.known);
    EXPECT_EQ(e.registration.max_rotation_deg, 0.5);
    EXPECT_EQ(e.markers.compare, Comparison::displacement);
    ASSERT_EQ(e.markers.on_body.size(), 2u);
    EXPECT_EQ(e.markers.on_body[0].name, "tip") << "order of the file, not of the alphabet";
    EXPECT_EQ(e.markers.on_body[0].label, "Tip - 1");
    EXPECT_EQ(e.markers.on_body[1].label, "side");
    EXPECT_EQ(e.markers.fixed.at(0).rest_m, Eigen::Vector3d(-0.09, -0.01, 0));

    ASSERT_EQ(e.trials.size(), 3u);
    EXPECT_EQ(e.trials[0].trace, folder.path() / "release.csv");
    EXPECT_EQ(e.trials[0].actuation, folder.path() / "signal.csv");
    EXPECT_EQ(e.trials[0].session_time_s, 60.0);
    EXPECT_EQ(e.trials[0].start_s, 0.5);
    EXPECT_EQ(e.trials[0].loads.at(0).mass_kg, 0.05);
    EXPECT_EQ(e.trials[0].loads.at(0).until_s, std::numeric_limits<double>::infinity());
    EXPECT_EQ(e.trials[0].loads.at(1).from_s, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(e.trials[0].loads.at(1).until_s, 0.0);
    EXPECT_THAT(e.trials[1].columns->labels, ElementsAre("side", "base", "tip"));
    EXPECT_EQ(e.trials[1].columns->metres_per_unit, 1e-3);
    EXPECT_EQ(e.trials[1].columns->separator, ';');
    EXPECT_EQ(e.trials[1].columns->rate_Hz, 50.0);
    EXPECT_FALSE(e.trials[1].actuation_steps.at(0).level.has_value());
    EXPECT_EQ(e.trials[2].role, TrialRole::validate);
    EXPECT_EQ(e.trials[2].format, "qtm_tsv");
    EXPECT_EQ(e.trials[2].condition.at("pressure_mbar"), 125.0);

    ASSERT_EQ(e.effects.size(), 2u);
    EXPECT_TRUE(e.effects[0].calibrate);
    EXPECT_EQ(std::get<double>(e.effects[0].parameters.at("stiffness_Pa_per_m")), 1.2e7);
    EXPECT_THAT(std::get<std::vector<std::string>>(e.effects[1].parameters.at("markers")), ElementsAre("tip", "side"));
    EXPECT_TRUE(e.warnings.empty()) << e.warnings.front();
}

TEST(ReadExperiment, DefaultsAreTheSchemas) {
    const Folder folder("defaults");
    write_files(folder, R"(schema = "experiment/1"
name = "least"
geometry = { kind = "stl", file = "body.stl", unit = "mm" }
clamp.box_m = [[0, 0, 0], [0, 1, 1]]
material = { model = "neo_hookean", youngs_modulus_Pa = 1e5, poissons_ratio = 0.3, density_kg_m3 = 1e3 }
markers.rest_m.tip = [1, 0, 0]
trial = [{ name = "a", role = "fit", trace = "release.csv", format = "csv", start = "straight" }]
)");
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const auto& stl = std::get<StlGeometry>(read->geometry);
    EXPECT_EQ(stl.metres_per_unit, 1e-3);
    EXPECT_EQ(stl.rotation, Eigen::Matrix3d::Identity());
    EXPECT_EQ(read->material.youngs_modulus_tolerance, 0.3);
    EXPECT_THAT(read->material.calibrate, ElementsAre("youngs_modulus", "damping"));
    EXPECT_FALSE(read->material.damping_s);
    EXPECT_EQ(read->gravity_m_s2, Eigen::Vector3d(0, 0, -9.81));
    EXPECT_TRUE(read->registration.known);
    EXPECT_EQ(read->markers.max_standoff_m, 1e-3);
    EXPECT_EQ(read->markers.placement_m, 0.0);
    EXPECT_EQ(read->markers.compare, Comparison::position);
    EXPECT_FALSE(read->markers.noise_m);
    EXPECT_EQ(read->trials[0].session_time_s, 0.0);
    EXPECT_TRUE(read->warnings.empty()) << "that no trial is left for validation is for fits to tell";
}

TEST(ReadExperiment, RotationMapsTheFile) {
    const Folder folder("rotation");
    const std::string stl = replaced(
        good_toml, "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]\norigin_m = [0.0, 0.0, 0.0]",
        "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"mm\"\nrotation = [[0,0,-1],[0,1,0],[1,0,0]]");
    write_files(folder, stl);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const Eigen::Matrix3d R = std::get<StlGeometry>(read->geometry).rotation;
    EXPECT_EQ(R * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(-3, 2, 1));

    // Four digits typed by hand: taken, and made a rotation to rounding.
    write_files(folder, replaced(stl, "[[0,0,-1],[0,1,0],[1,0,0]]", "[[0.8660,0.5,0],[-0.5,0.8660,0],[0,0,1]]"));
    const Result<Experiment> rounded = read_experiment(folder.path());
    ASSERT_TRUE(rounded) << rounded.error().text();
    const Eigen::Matrix3d Q = std::get<StlGeometry>(rounded->geometry).rotation;
    EXPECT_LT((Q.transpose() * Q - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((Q(0, 0) - std::sqrt(0.75)), 1e-6);
}

TEST(ReadExperiment, KnowsWhereKeysStand) {
    const Folder folder("locations");
    write_files(folder, good_toml);
    const Result<Experiment> read = read_experiment(folder.path(), {{"trial[0].load[0].mass_kg", "0.1"}});
    ASSERT_TRUE(read) << read.error().text();
    const std::string file = (folder.path() / "experiment.toml").string();
    const auto place = [&](const std::string& part) { return file + ":" + std::to_string(line_of(good_toml, part)); };
    EXPECT_EQ(location_of(*read, "clamp.box_m"), place("box_m = [[-5e-4"));
    EXPECT_EQ(location_of(*read, "markers.rest_m.side"), place("side = ["));
    EXPECT_EQ(location_of(*read, "trial[0].load[1].force_N"), place("force_N"));
    EXPECT_EQ(location_of(*read, "trial[1].load[0].box_m"), place("[[trial]]\nname = \"step\""))
        << "absent: the table around it";
    EXPECT_EQ(location_of(*read, "trial[0].load[0].mass_kg"), "--set");
    EXPECT_EQ(location_of(*read, "nowhere"), file + ":1");
}

TEST(ReadExperiment, TakesAFileInPlaceOfTheFolder) {
    const Folder folder("file");
    write_files(folder, good_toml);
    folder.write("experiment_augmented.toml", replaced(good_toml, "2.6e5", "3.1e5"));
    const Result<Experiment> read = read_experiment(folder.path() / "experiment_augmented.toml");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->material.youngs_modulus_Pa, 3.1e5);
    EXPECT_EQ(read->folder, folder.path());
}

TEST(ReadExperiment, MissingFilesAreOneSentence) {
    const Folder folder("missing");
    const Result<Experiment> empty_folder = read_experiment(folder.path());
    ASSERT_FALSE(empty_folder);
    EXPECT_EQ(empty_folder.error().where, (folder.path() / "experiment.toml").string());
    EXPECT_THAT(empty_folder.error().what, HasSubstr("not found"));
    const Result<Experiment> no_folder = read_experiment(folder.path() / "none");
    ASSERT_FALSE(no_folder);
    EXPECT_THAT(no_folder.error().what, HasSubstr("not found"));
    std::filesystem::create_directory(folder.path() / "experiment.toml");
    EXPECT_FALSE(read_experiment(folder.path()));
}

TEST(ReadExperiment, OverridesSpeakToml) {
    const Folder folder("overrides");
    write_files(folder, good_toml);
    const Result<Experiment> read = read_experiment(
        folder.path(), {{"material.youngs_modulus_Pa", "3e5"},
                        {"trial[0].start_s", "0.6"},
                        {"trial.check.start", "straight"},
                        {"muscle.right.follows.ratio", "-0.25"},
                        {"environment.gravity_m_s2[2]", "-1.62"},
                        {"name", "\"two words\""},
                        {"trial.step.trace", "release.csv"},
                        {"trial[1].load[0]", "{kind='force', box_m=[[0.09,0,0],[0.1,1,1]], force_N=[1,0,0]}"}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->material.youngs_modulus_Pa, 3e5);
    EXPECT_EQ(read->trials[0].start_s, 0.6);
    EXPECT_EQ(read->trials[2].start, StartState::straight);
    EXPECT_EQ(read->muscles[1].follows->ratio, -0.25);
    EXPECT_EQ(read->gravity_m_s2[2], -1.62);
    EXPECT_EQ(read->name, "two words");
    EXPECT_EQ(read->trials[1].trace.filename(), "release.csv");
    EXPECT_EQ(read->trials[1].loads.at(0).force_N[0], 1.0);
}

TEST(ReadExperiment, BadOverridesSaySo) {
    const Folder folder("bad_overrides");
    write_files(folder, good_toml);
    struct Case {
        const char* key;
        const char* value;
        const char* word;
    };
    for (const Case& c :
         {Case{"material.youngs_modulus", "3e5", "youngs_modulus_Pa"}, Case{"materials.density_kg_m3", "1", "material"},
          Case{"material.density_kg_m3", "heavy", "must be a number"}, Case{"material.density_kg_m3", "-1", "positive"},
          Case{"material.density_kg_m3", "", "TOML"}, Case{"material.density_kg_m3", "1\nname=2", "TOML"},
          Case{"material.density_kg_m3", "[1", "TOML"}, Case{"material.density_kg_m3.x", "1", "is a number"},
          Case{"trial[7].start_s", "1", "3 elements"}, Case{"trial[x].start_s", "1", "not a key"},
          Case{"trial[99999999999999999999999].start_s", "1", "not a key"},
          Case{"trial.relase.start_s", "1", "release"}, Case{"", "1", "not a key"},
          Case{"material..x", "1", "not a key"}, Case{"clamp[0]", "1", "no elements"},
          Case{"geometry.file", "body.stl", "stl"}}) {
        const Result<Experiment> read = read_experiment(folder.path(), {{c.key, c.value}});
        ASSERT_FALSE(read) << c.key;
        EXPECT_EQ(read.error().where, "--set") << c.key << ": " << read.error().text();
        EXPECT_THAT(read.error().what, HasSubstr(c.word)) << c.key;
        EXPECT_THAT(read.error().what, StartsWith(std::string(c.key).substr(0, 4)));
    }
}

TEST(ReadExperiment, SharedExamplesParse) {
    const std::vector<std::filesystem::path> folders = test::shared_experiments();
    if (folders.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& folder : folders) {
        const Result<Experiment> read = read_experiment(folder);
        EXPECT_TRUE(read) << read.error().text();
        EXPECT_TRUE(!read || read->warnings.empty());
    }
}

TEST(ReadExperiment, RealBeamHasItsDeclaredValues) {
    const std::filesystem::path folder = test::shared_data("experiments/real_beam");
    if (folder.empty()) GTEST_SKIP() << "skipped: no data";
    const Result<Experiment> read = read_experiment(folder);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->registration.method, RegistrationMethod::rest_pose);
    EXPECT_EQ(read->markers.on_body.size(), 3u);
    EXPECT_EQ(read->markers.fixed[2].label, "Base - 3");
    ASSERT_EQ(read->trials.size(), 4u);
    EXPECT_EQ(read->trials[3].loads.at(0).force_N[2], -0.991);
    EXPECT_EQ(read->trials[0].trace.filename(), "beam_gravity_V2_a.c3d");
}

/// A condition that only some of the fit trials state gives no curve to predict a free level from.
TEST(ReadExperiment, WarnsOfALevelThatIsPredictedAsAMean) {
    const Folder folder("mean_level");
    const auto warnings = [&](const std::string& condition) {
        const std::string other =
            "[[trial]]\nname = \"other\"\nrole = \"fit\"\ntrace = \"step.txt\"\n"
            "format = \"columns\"\ncolumns = { markers = [\"side\", \"base\", \"tip\"], "
            "unit = \"mm\", separator = \";\", rate_Hz = 50 }\nstart = \"equilibrium\"\n"
            "actuation_step = { left = \"free\" }\n" +
            condition;
        write_files(folder,
                    replaced(good_toml, "[[trial]]\nname = \"check\"", other + "\n[[trial]]\nname = \"check\""));
        const Result<Experiment> read = read_experiment(folder.path());
        EXPECT_TRUE(read) << read.error().text();
        return read ? read->warnings : std::vector<std::string>{};
    };
    EXPECT_THAT(warnings("condition = { pressure_mbar = 100 }\n"), testing::IsEmpty());
    EXPECT_THAT(warnings("condition = { temperature_K = 300 }\n"),
                ElementsAre(testing::AllOf(StartsWith("trial[3].actuation_step.left: no `condition`"),
                                           HasSubstr("all 2 fit trials"), HasSubstr("their mean"))));
}

}  // namespace
}  // namespace myo::experiment
