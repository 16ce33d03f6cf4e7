#include "support/corpus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/calibrate.hpp"
#include "experiment/read_experiment.hpp"
#include "results/optimize_output.hpp"

namespace myo::calibration {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

setup::Setup setup_of(const std::filesystem::path& path, double resolution_m, const std::string& trial = {}) {
    Result<experiment::Experiment> experiment = experiment::read_experiment(path);
    EXPECT_TRUE(experiment) << experiment.error().text();
    // The command takes the named trial as the one to be fitted.
    if (!trial.empty()) {
        std::erase_if(experiment->trials, [&](const auto& t) { return t.name != trial; });
        experiment->trials.front().role = experiment::TrialRole::fit;
    }
    setup::SetupSettings settings;
    settings.mesh.resolution_m = resolution_m;
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings);
    EXPECT_TRUE(setup) << setup.error().text();
    return std::move(*setup);
}

std::filesystem::path example(const char* name) {
    return std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets/examples" / name;
}

TEST(Corpus, CalibrationIsResumedFromTheValuesOfItsFile) {
    const setup::Setup setup = setup_of(example("silicone_beam"), 0.03);
    const Result<EarlierCalibration> read = read_calibration(test::corpus("calibrate"), setup, {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->notes, IsEmpty());
    const nlohmann::json file = test::corpus_json("calibrate/calibrate.json");
    EXPECT_EQ(read->evaluations, file.at("evaluations_in_all").get<int>());
    ASSERT_EQ(read->values.size(), 2u);
    for (const auto& [name, value] : read->values) EXPECT_EQ(value, file.at("parameters").at(name).at("value")) << name;
}

/// The three components of a fitted axis were parameters; its two angles are now.
TEST(Corpus, FittedAxisIsReadAsAnglesWithANote) {
    const setup::Setup setup = setup_of(test::corpus("experiments/tilted.toml"), 0.03);
    const Result<EarlierCalibration> read = read_calibration(test::corpus("calibrate_tilted"), setup, {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->notes, ElementsAre(HasSubstr("effect.gravity_tilt.axis")));
    const nlohmann::json file = test::corpus_json("calibrate_tilted/calibrate.json").at("parameters");
    const auto held = [&](const std::string& name) { return file.at(name).at("value").get<double>(); };
    prediction::ParameterValues values = prediction::declared_values(setup);
    for (const prediction::ModelParameter& p : prediction::free_parameters(setup)) {
        const double value = read->values.at(p.parameter.name);
        if (!p.is_angle()) {
            EXPECT_EQ(value, held(p.parameter.name));
        }
        prediction::set_value(p, value, values);
    }
    const std::string stem = "effect.gravity_tilt.axis.";
    const Eigen::Vector3d axis(held(stem + "x"), held(stem + "y"), held(stem + "z"));
    const Eigen::VectorXd turned = effect::vector(values.effects.front().parameters, "axis");
    EXPECT_NEAR((turned - axis.normalized()).norm(), 0.0, 1e-12);
}

/// The level before the start was fixed; it is the first of the sought values now, for either form of a signal.
TEST(Corpus, SearchForSignalsIsResumedFromTheLevelAndTheValues) {
    for (const bool held : {false, true}) {
        const std::string folder = held ? "optimize_hold" : "optimize";
        const setup::Setup setup = setup_of(example("soft_arm"), 0.026, "reach");
        OptimizeSettings settings;
        settings.frequency_Hz = 4.0;
        settings.hold = held;
        const Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings);
        ASSERT_TRUE(problem) << problem.error().text();
        ASSERT_TRUE(problem->sought.seek_before);
        const auto read = results::read_optimization(test::corpus(folder), setup, *problem);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_THAT(read->notes, ElementsAre(HasSubstr("upper: the level before t = 0")));
        const nlohmann::json file = test::corpus_json(folder + "/optimize.json"), signal = file.at("signals").at(0);
        EXPECT_EQ(read->evaluations, file.at("evaluations_in_all").get<int>());
        ASSERT_EQ(read->values.cols(), static_cast<Eigen::Index>(signal.at("values").size() + 1));
        EXPECT_EQ(read->values(0, 0), signal.at("before").get<double>());
        for (Eigen::Index k = 1; k < read->values.cols(); ++k)
            EXPECT_EQ(read->values(0, k), signal.at("values").at(static_cast<std::size_t>(k - 1)).get<double>());
        // The knots are where they were.
        const std::vector<double> times = inverse::knot_times(problem->sought);
        const auto former = file.at("knot_times_s").get<std::vector<double>>();
        EXPECT_EQ(std::vector<double>(times.begin() + 1, times.end()), former);
    }
}

}  // namespace
}  // namespace myo::calibration
