#include <gtest/gtest.h>

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <vector>

#include "dynamics/statics.hpp"
#include "model/directional_mass.hpp"
#include "sensitivity/gradient_check.hpp"
#include "sensitivity/model_change.hpp"
#include "sensitivity/run_parts.hpp"
#include "sensitivity/tangent_columns.hpp"
#include "support/beam.hpp"
#include "support/meshes.hpp"

namespace myo::sensitivity::tangent_parts_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double endless = std::numeric_limits<double>::infinity();

TEST(TangentColumns, AreSingleFieldsSideBySide) {
    test::BeamSpec spec;
    model::Model model = test::make_beam(spec);
    const std::vector<model::GuidedNode> guided{{9, {true, false, true}}, {12, {false, true, false}}};
    model.body = model::make_body(model.body->mesh, spec.kind, {0, 5}, {}, guided);
    model.directional_masses = {model::line_mass(test::tip_share(model, spec), Vector3d(1.0, 2.0, 0.5), 0.3)};
    const model::BlockPattern& pattern = model.body->pattern;
    const Eigen::Index n = model.body->node_count();
    model::NodalColumns fields(12, n);
    for (Eigen::Index p = 0; p < 4; ++p)
        model::nodal_column(fields, p) = test::rough_field(n, 0.5 * static_cast<double>(p));
    const MatrixXd free = gather_columns(pattern, fields);
    const model::NodalColumns back = scatter_columns(pattern, free);
    const model::MassMatrix mass = model::mass_matrix(model);
    const model::NodalColumns momenta = mass_times(fields, mass);
    ASSERT_EQ(free.cols(), 4);
    for (Eigen::Index p = 0; p < 4; ++p) {
        const Matrix3Xd field = model::nodal_column(fields, p);
        EXPECT_EQ(VectorXd(free.col(p)), model::gather(pattern, field));
        EXPECT_EQ(Matrix3Xd(model::nodal_column(back, p)), model::free_part(*model.body, field));
        const Matrix3Xd momentum = model::times_mass(field, mass);
        EXPECT_LT((Matrix3Xd(model::nodal_column(momenta, p)) - momentum).norm(), 1e-14 * momentum.norm());
    }
    EXPECT_EQ(mass_times({}, mass).size(), 0);
}

TEST(TangentColumns, AddUpInAnyNumber) {
    const MatrixXd a = test::rough_field(1500, 0.1), b = test::rough_field(1500, 0.7), none;  // more than one block
    EXPECT_LT((sum_of({{2.0, &a}, {-3.0, &b}}) - (2.0 * a - 3.0 * b)).norm(), 1e-13);
    EXPECT_EQ(sum_of({{2.0, &none}, {1.0, &a}, {5.0, &none}}), a) << "empty fields count as zero";
    EXPECT_EQ(sum_of({{0.0, &b}, {1.0, &a}}), a);
    EXPECT_EQ(sum_of({}).size(), 0);
    EXPECT_EQ(sum_of({{1.0, &none}, {0.0, &a}}).size(), 0);
}

/// Two beams whose masses differ: their density, and bodies on threads of other times.
std::shared_ptr<ModelPair> beams(double density_step) {
    test::BeamSpec spec;
    auto pair = std::make_shared<ModelPair>();
    pair->under = pair->over = test::make_beam(spec);
    pair->over.density_kg_m3 += density_step;
    pair->width = 0.5;
    return pair;
}
model::DirectionalMass hung(const model::Model& model, double kg, double from_s, double until_s) {
    model::DirectionalMass mass = model::line_mass(test::tip_share(model, test::BeamSpec{}), Vector3d::UnitZ(), kg);
    mass.from_s = from_s;
    mass.until_s = until_s;
    return mass;
}

TEST(ModelChanges, OfTheMassAreDifferencesPerUnit) {
    EXPECT_FALSE(changes_mass(model_change(beams(0.0))));
    const ModelChange change = model_change(beams(20.0));
    EXPECT_TRUE(changes_mass(change));
    EXPECT_NEAR(mass_change(change, 3.0).isotropic.sum(), 20.0 / 0.5 * test::BeamSpec{}.size.prod(), 1e-15);
    EXPECT_FALSE(mass_change(change, 3.0).has_directional());
}

TEST(ModelChanges, OfPassingMassesAreTakenOnAllTheirTimes) {
    const auto pair = beams(0.0);
    pair->over.directional_masses = {hung(pair->over, 3.0, -endless, 0.4), hung(pair->over, 1.0, 0.1, endless)};
    pair->under.directional_masses = {hung(pair->under, 3.0, -endless, 0.6)};
    const ModelChange change = model_change(pair);
    EXPECT_TRUE(changes_mass(change));
    struct Instant {
        double time_s, kg_per_unit;
    };
    for (const Instant& at : {Instant{0.0, 0.0},
                              {0.0999, 0.0},
                              {0.1, 2.0},
                              {0.3999, 2.0},
                              {0.4, -4.0},
                              {0.5999, -4.0},
                              {0.6, 2.0},
                              {9.0, 2.0}}) {
        const model::MassMatrix& mass = mass_change(change, at.time_s);
        EXPECT_NEAR(mass.directional.size() > 0 ? mass.directional.sum() : 0.0, at.kg_per_unit, 1e-14) << at.time_s;
    }
    EXPECT_EQ(change.masses.size(), 4u);
    EXPECT_EQ(change.masses.back().until_s, endless);
    // Alike on both sides they change nothing.
    pair->under.directional_masses = pair->over.directional_masses;
    EXPECT_FALSE(changes_mass(model_change(pair)));
}

/// The residual of statics is that of the forces: its change by gravity is minus the weight per unit.
TEST(ModelChanges, OfTheResidualAreThoseOfTheLoads) {
    const auto pair = beams(0.0);
    pair->over.gravity_m_s2 = {0.0, 3.0, 0.0};
    pair->under.gravity_m_s2 = {0.0, 1.0, 0.0};
    const model::Body& body = *pair->over.body;
    const ModelChange change = model_change(pair);
    const Matrix3Xd x = body.mesh.nodes + 1e-4 * model::free_part(body, test::rough_field(body.node_count(), 0.2));
    const dynamics::Stage stage = dynamics::static_stage(body, 0.0);
    const VectorXd residual = held_residual_change(change, stage, x);
    const Matrix3Xd weight = Vector3d(0.0, 4.0, 0.0) * model::mass_matrix(pair->over).nodal_kg.transpose();
    const VectorXd expected = model::gather(body.pattern, weight);
    EXPECT_GT(expected.norm(), 0.0);
    EXPECT_LT((residual + expected).norm(), 1e-9 * expected.norm());
    EXPECT_EQ(held_strain_change(change, stage, x).norm(), 0.0) << "strains at x are those of one body";
}

TEST(GradientChecks, TellTheMiddleAndTheWorstError) {
    const auto check_of = [](const std::vector<double>& errors) {
        GradientCheck check;
        for (const double error : errors) {
            GradientCheckRow row;
            row.relative_error = error;
            check.rows.push_back(row);
        }
        return check;
    };
    EXPECT_EQ(check_of({}).median_error(), 0.0);
    EXPECT_EQ(check_of({}).worst_error(), 0.0);
    EXPECT_EQ(check_of({0.3}).median_error(), 0.3);
    EXPECT_EQ(check_of({0.5, 0.1, 0.3}).median_error(), 0.3);
    EXPECT_EQ(check_of({0.5, 0.1, 0.3, 0.2}).median_error(), 0.3) << "the upper one of two";
    EXPECT_EQ(check_of({0.5, 0.1, 0.3, 0.2}).worst_error(), 0.5);
    EXPECT_FALSE(GradientCheck{}.complete()) << "not run";
}

TEST(GradientChecks, CompareRelativeToTheLarger) {
    struct Case {
        double a, b, difference;
    };
    for (const Case& c : {Case{0.0, 0.0, 0.0},
                          {1.0, 1.0, 0.0},
                          {1.0, 0.0, 1.0},
                          {4.0, 5.0, 0.2},
                          {-4.0, -5.0, 0.2},
                          {1.0, -1.0, 2.0},
                          {1e-300, 2e-300, 0.5},
                          {endless, endless, endless},
                          {1.0, -endless, endless}}) {
        EXPECT_DOUBLE_EQ(relative_difference(c.a, c.b), c.difference) << c.a << " " << c.b;
        EXPECT_DOUBLE_EQ(relative_difference(c.b, c.a), c.difference) << c.a << " " << c.b;
    }
}

/// One part if the budget allows it, then two, and a sentence with the least that would do.
TEST(PlannedParts, MeetTheirBudgetExactlyOrSayWhatIsNeeded) {
    const TapeBytes cost{10.0, 1000.0, 200.0};
    // 16 steps at once: 16 stage solutions, 16 / 4 + 1 states and 4 records; 8 at a time: 3 states and 2 at the cuts.
    const double whole = 16 * 10.0 + 5 * 1000.0 + 4 * 200.0, half = 8 * 10.0 + 5 * 1000.0 + 3 * 200.0;
    const Result<RunParts> all = plan_parts(16, cost, whole), cut = plan_parts(16, cost, whole - 1.0);
    ASSERT_TRUE(all && cut);
    EXPECT_EQ(all->bytes, whole);
    EXPECT_TRUE(all->parts == 1 && all->steps_per_part == 16 && all->points_every == 4);
    EXPECT_EQ(cut->bytes, half);
    EXPECT_TRUE(cut->parts == 2 && cut->steps_per_part == 8 && cut->points_every == 3);
    EXPECT_TRUE(plan_parts(16, cost, half));
    EXPECT_FALSE(plan_parts(16, cost, half - 1.0)) << "states at the cuts cost more than further parts save";
    const Result<RunParts> none = plan_parts(0, cost, 1e9);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->parts, 1);
    const Result<RunParts> small = plan_parts(2, {2e6, 3e6, 5e6}, 1e6);
    ASSERT_FALSE(small);
    EXPECT_EQ(small.error().what, "the gradient of 2 steps needs at least 18 MB, more than its budget of 1 MB");
}

}  // namespace
}  // namespace myo::sensitivity::tangent_parts_tests
