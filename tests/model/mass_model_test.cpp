#include <gtest/gtest.h>

#include "support/beam.hpp"

namespace myo::model {
namespace {

/// A box of n cells has more vertices than cells, and tetrahedra fewer: the body weighs too much or too little.
TEST(MassModel, EqualVertexMassesWeighByTheNumberOfVertices) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8_full, fem::ElementKind::tet4, fem::ElementKind::tet10}) {
        test::BeamSpec spec;
        spec.kind = kind;
        spec.cells = {5, 3, 2};
        spec.gravity_m_s2 = 9.81;
        Model model = test::make_beam(spec);
        model.mass_model = MassModel::equal_vertices;
        const double vertices_per_cell = static_cast<double>(model.body->node_count()) / model.body->cell_count();
        const double true_kg = 1070.0 * spec.size.prod();
        MassMatrix mass = mass_matrix(model);
        EXPECT_EQ(mass.isotropic.nonZeros(), model.body->node_count());
        EXPECT_LT((mass.isotropic.diagonal().array() / mass.isotropic.coeff(0, 0) - 1.0).abs().maxCoeff(), 1e-14);
        EXPECT_NEAR(mass.isotropic.sum() / true_kg, vertices_per_cell, 1e-12);
        EXPECT_NEAR(-external_forces(model, mass, 0.0).row(2).sum() / (9.81 * true_kg), vertices_per_cell, 1e-12)
            << "weight follows mass";
        model.masses.push_back({test::tip_share(model, spec), 0.05});
        mass = mass_matrix(model);
        EXPECT_NEAR(mass.isotropic.sum(), vertices_per_cell * true_kg + 0.05, 1e-14);
    }
}

/// The paper's meshes of the beam: 136 and 127 % of the body's mass.
TEST(MassModel, PublishedBeamsAreTooHeavy) {
    for (const auto& [cells, part] :
         {std::pair{Eigen::Vector3i(23, 7, 7), 1.363}, {Eigen::Vector3i(32, 9, 9), 1.273}}) {
        test::BeamSpec spec;
        spec.cells = cells;
        Model model = test::make_beam(spec);
        const double true_kg = mass_matrix(model).isotropic.sum();
        model.mass_model = MassModel::equal_vertices;
        EXPECT_NEAR(mass_matrix(model).isotropic.sum() / true_kg, part, 5e-4);
    }
}

TEST(MassModel, NamesGoThereAndBack) {
    for (const std::string& id : mass_model_ids()) {
        MassModel model{};
        ASSERT_TRUE(parse_mass_model(id, model));
        EXPECT_EQ(to_string(model), id);
    }
    MassModel model{};
    EXPECT_FALSE(parse_mass_model("lumped", model));
    EXPECT_EQ(Model{}.mass_model, MassModel::consistent);
}

}  // namespace
}  // namespace myo::model
