#include "validation/truth_model.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"
#include "validation/synthetic_experiment.hpp"
#include "validation/synthetic_folder.hpp"

namespace myo::test {
namespace {

/// The first case of a plate that passes, in a folder with traces of two samples.
validation::SyntheticCase written_plate(const Folder& folder, const std::string& effect) {
    const validation::CaseChoice choice{.seed = 7, .families = {validation::BodyFamily::plate}, .effects = {effect}};
    const validation::SyntheticCase c = validation::drawn_case(choice, 1);
    std::string header = "time_s", row;
    for (std::size_t m = 0; m < c.markers.size(); ++m)
        for (int axis = 0; axis < 3; ++axis) {
            header += ",m" + std::to_string(m + 1) + "_" + "xyz"[axis] + "_m";
            row += "," + std::to_string(c.markers[m](axis));
        }
    folder.write("experiment.toml", validation::experiment_text(c));
    for (const validation::SyntheticTrial& trial : c.trials)
        folder.write(trial.name + ".csv", header + "\n0" + row + "\n0.01" + row + "\n");
    return c;
}

setup::Setup truth_of(const validation::SyntheticCase& c, const Folder& folder) {
    const Result<experiment::Experiment> declared = experiment::read_experiment(folder.path());
    EXPECT_TRUE(declared) << declared.error().text();
    Result<setup::Setup> truth = validation::truth_setup(c, *declared);
    EXPECT_TRUE(truth) << truth.error().text();
    return std::move(*truth);
}

TEST(TruthModel, ASlippedClampEndsWhereItStillHolds) {
    const Folder folder("slipped");
    const validation::SyntheticCase c = written_plate(folder, "clamp_slip");
    const setup::Setup truth = truth_of(c, folder);
    const double held_m = c.body.held_m - effect::number(c.effects.front().parameters, "free_length_m");
    ASSERT_GT(held_m, 0.0);
    double last_clamped = 0.0, first_free = std::numeric_limits<double>::infinity();
    for (int i = 0; i < truth.body->node_count(); ++i) {
        const double x = truth.body->mesh.nodes(0, i);
        if (truth.body->clamped[static_cast<std::size_t>(i)])
            last_clamped = std::max(last_clamped, x);
        else
            first_free = std::min(first_free, x);
    }
    EXPECT_NEAR(last_clamped, held_m, 1e-9);
    EXPECT_GT(first_free, held_m);
    EXPECT_TRUE(validation::true_values(c, truth).effects.empty());  // it is in the clamp already
}

TEST(TruthModel, AThinBodyHasSeveralLayersOfCells) {
    const Folder folder("layers");
    const validation::SyntheticCase c = written_plate(folder, "quadratic_drag");
    const setup::Setup truth = truth_of(c, folder);
    EXPECT_EQ(truth.mesh.element, fem::ElementKind::tet10);
    EXPECT_LE(truth.mesh.resolution_m, 0.5 * c.body.thickness_m);
    EXPECT_EQ(validation::true_values(c, truth).effects.size(), 1u);
}

}  // namespace
}  // namespace myo::test
