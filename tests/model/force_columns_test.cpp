#include "model/force_columns.hpp"

#include <gtest/gtest.h>

#include "material/catalogue.hpp"
#include "support/beam.hpp"
#include "support/meshes.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// More columns than are looked at once, on every element and law: what single columns give.
TEST(ForceColumns, EqualTheFunctionsForSingleOnes) {
    constexpr Index columns = 11;
    for (const std::string& element : fem::element_ids())
        for (const material::MaterialPointer& law : material::material_catalogue()) {
            test::BeamSpec spec;
            spec.kind = test::element(element);
            spec.damping_s = 0.01;
            if (fem::cell_type(spec.kind) == mesh::CellType::tet10) spec.cells = {2, 1, 1};
            Model model = test::make_beam(spec);
            model.material = law;
            const Body& body = *model.body;
            const auto wavy = [&](double shift) {
                return VectorXd(1.0 + 0.3 * VectorXd::LinSpaced(body.point_count(), shift, 7.0 + shift).array().sin());
            };
            model.point_factors = wavy(0.0);
            const VectorXd softening = wavy(1.0);
            MatrixXd d_softening(body.point_count(), columns);
            const Matrix3Xd x = body.mesh.nodes + 1e-3 * test::rough_field(body.node_count(), 0.3);
            const VectorXd rate = strain_tangent(model, x, test::rough_field(body.node_count(), 0.7));

            std::vector<Stiffness> stiffness(static_cast<std::size_t>(columns));
            NodalColumns motions(3 * columns, body.node_count());
            for (Index p = 0; p < columns; ++p) {
                nodal_column(motions, p) = test::rough_field(body.node_count(), 0.1 * static_cast<double>(p));
                d_softening.col(p) = wavy(2.0 + 0.3 * static_cast<double>(p)).array() - 1.0;
                Stiffness& own = stiffness[static_cast<std::size_t>(p)];
                own.fibres = false;
                for (int c = 0; c < body.cell_count(); ++c) {
                    const double share = (c + p) % 3 == 0 ? 1.0 + 0.1 * c : 0.0;
                    if (p % 4 != 1) own.elastic.push_back({1e4 * share, 3e5 * share * static_cast<double>(p)});
                    if (p % 4 != 2) own.viscous.push_back({20.0 * share, 0.0});
                }
            }
            const MatrixXd tangents = strain_tangents(model, x, motions);
            const NodalColumns gradients = gradient_columns(model, x, unit_forces(model, x, softening, rate),
                                                            {stiffness, tangents, d_softening});
            for (Index p = 0; p < columns; ++p) {
                const std::string what = element + " " + law->id() + " column " + std::to_string(p);
                const VectorXd tangent = strain_tangent(model, x, nodal_column(motions, p));
                EXPECT_LT((tangents.col(p) - tangent).norm(), 1e-13 * tangent.norm()) << what;
                InternalInput input;
                Stiffness own = stiffness[static_cast<std::size_t>(p)];
                own.elastic_factors = times_factors(model.point_factors, softening);
                own.viscous_factors = model.point_factors;
                input.stiffness = &own;
                input.rate = {0.0, &rate};
                const Matrix3Xd of_stiffness = internal_energy(model, x, input, HessianKind::none).gradient;
                Stiffness softened;  // the moduli times the changes of their factors
                softened.elastic = model.moduli;
                softened.elastic_factors = times_factors(model.point_factors, d_softening.col(p));
                softened.fibres = false;
                input.stiffness = &softened;
                const Matrix3Xd of_softening = internal_energy(model, x, input, HessianKind::none).gradient;
                ASSERT_GT(of_softening.norm(), 0.0) << what;
                const Matrix3Xd of_rate = viscous_gradient(model, x, tangent);
                ASSERT_GT(of_stiffness.norm(), 0.0) << what;
                ASSERT_GT(of_rate.norm(), 0.0) << what;
                EXPECT_LT((nodal_column(gradients, p) - of_stiffness - of_rate - of_softening).norm(),
                          1e-11 * (of_stiffness.norm() + of_rate.norm() + of_softening.norm()))
                    << what;
            }
        }
}

}  // namespace
}  // namespace myo::model
