#include "trust/truth_model.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "project/read_experiment.hpp"
#include "support/folder.hpp"
#include "trust/synthetic_experiment.hpp"
#include "trust/synthetic_folder.hpp"

namespace myo::test {
namespace {

/// The first case of a plate that passes, in a folder with traces of two samples.
SyntheticCase written_plate(const Folder& folder, const std::string& effect) {
    const CaseChoice choice{.seed = 7, .families = {BodyFamily::plate}, .effects = {effect}};
    const SyntheticCase c = drawn_case(choice, 1);
    std::string header = "time_s", row;
    for (std::size_t m = 0; m < c.markers.size(); ++m)
        for (int axis = 0; axis < 3; ++axis) {
            header += ",m" + std::to_string(m + 1) + "_" + "xyz"[axis] + "_m";
            row += "," + std::to_string(c.markers[m](axis));
        }
    folder.write("experiment.toml", experiment_text(c));
    for (const SyntheticTrial& trial : c.trials) folder.write(trial.name + ".csv", header + "\n0" + row + "\n0.01" + row + "\n");
    return c;
}

Study truth_of(const SyntheticCase& c, const Folder& folder) {
    const Result<Experiment> declared = read_experiment(folder.path());
    EXPECT_TRUE(declared) << declared.error().text();
    Result<Study> truth = truth_study(c, *declared);
    EXPECT_TRUE(truth) << truth.error().text();
    return std::move(*truth);
}

TEST(TruthModel, ASlippedClampEndsWhereItStillHolds) {
    const Folder folder("slipped");
    const SyntheticCase c = written_plate(folder, "clamp_slip");
    const Study truth = truth_of(c, folder);
    const double held_m = c.body.held_m - number(c.effect->parameters, "free_length_m");
    ASSERT_GT(held_m, 0.0);
    double last_clamped = 0.0, first_free = std::numeric_limits<double>::infinity();
    for (int i = 0; i < truth.body->node_count(); ++i) {
        const double x = truth.body->mesh.nodes(0, i);
        if (truth.body->clamped[static_cast<std::size_t>(i)]) last_clamped = std::max(last_clamped, x);
        else first_free = std::min(first_free, x);
    }
    EXPECT_NEAR(last_clamped, held_m, 1e-9);
    EXPECT_GT(first_free, held_m);
    EXPECT_TRUE(true_values(c, truth).effects.empty());   // it is in the clamp already
}

TEST(TruthModel, AThinBodyHasSeveralLayersOfCells) {
    const Folder folder("layers");
    const SyntheticCase c = written_plate(folder, "quadratic_drag");
    const Study truth = truth_of(c, folder);
    EXPECT_EQ(truth.mesh.element, ElementKind::tet10);
    EXPECT_LE(truth.mesh.resolution_m, 0.5 * c.body.thickness_m);
    EXPECT_EQ(true_values(c, truth).effects.size(), 1u);
}

}  // namespace
}  // namespace myo::test
