#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/statics.hpp"
#include "material/catalogue.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"
#include "support/meshes.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Gradient of the harmonic function exp(sqrt 2 a z) sin(a x) sin(a y): it has no divergence and no Laplacian, so it is
/// in equilibrium without volume forces for any small-strain moduli.
Vector3d harmonic_displacement(const Vector3d& X) {
    const double a = 2.0, e = std::exp(std::sqrt(2.0) * a * X(2));
    return a * e *
           Vector3d(std::cos(a * X(0)) * std::sin(a * X(1)), std::sin(a * X(0)) * std::cos(a * X(1)),
                    std::sqrt(2.0) * std::sin(a * X(0)) * std::sin(a * X(1)));
}

/// A grid under a smooth map, so that no cell is a box and refinement keeps the shape.
mesh::VolumeMesh curved_grid(fem::ElementKind kind, int n) {
    const mesh::CellType type = fem::cell_type(kind);
    mesh::VolumeMesh mesh = type == mesh::CellType::hex8
                                ? mesh::box_hex_mesh(test::unit_box(), {n, n, n})
                                : mesh::tet_box_mesh(test::unit_box(), {n, n, n}, mesh::CellType::tet4);
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) {
        const Vector3d X = mesh.nodes.col(i);
        mesh.nodes.col(i) += 0.05 * Vector3d(std::sin(3.0 * X(1)), std::sin(3.0 * X(2)), std::sin(3.0 * X(0)));
    }
    return type == mesh::CellType::tet10 ? mesh::to_tet10(mesh) : mesh;
}

/// Of unit modulus, all nodes of the surface clamped.
model::Model held_at_its_boundary(const mesh::VolumeMesh& mesh, fem::ElementKind kind, double nu) {
    const mesh::BoundaryFaces faces = mesh::boundary_faces(mesh);
    std::vector<int> boundary;
    for (Eigen::Index f = 0; f < faces.count(); ++f)
        for (const int node : faces.nodes.col(f)) boundary.push_back(node);
    model::Model model;
    model.body = model::make_body(mesh, kind, boundary);
    model.material = material::neo_hookean();
    model.moduli = model::uniform_moduli(model.body->cell_count(), 1.0, nu);
    model.density_kg_m3 = 1.0;
    return model;
}

/// Displacement error over the inner nodes, relative to the displacement, with the exact displacement on the boundary.
double relative_error(const std::string& element, int n, double nu) {
    const fem::ElementKind kind = test::element(element);
    const mesh::VolumeMesh mesh = curved_grid(kind, n);
    const model::Model model = held_at_its_boundary(mesh, kind, nu);
    const double amplitude = 1e-6;  // nonlinear terms are as small against it
    Matrix3Xd u(3, mesh.node_count());
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        u.col(i) = amplitude * harmonic_displacement(mesh.nodes.col(i));
    Matrix3Xd x = mesh.nodes;
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        if (model.body->clamped[static_cast<std::size_t>(i)]) x.col(i) += u.col(i);
    StageSolver solver(model);
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(report.ok()) << element << " " << n << " " << report.message;
    double error = 0.0, size = 0.0;
    for (const int node : model.body->pattern.free_nodes) {
        error += (x.col(node) - mesh.nodes.col(node) - u.col(node)).squaredNorm();
        size += u.col(node).squaredNorm();
    }
    return std::sqrt(error / size);
}

/// Second order in the displacement for linear cells, third for quadratic ones, also when nearly incompressible: no
/// locking.
TEST(MeshConvergence, DisplacementConvergesAtTheOrderOfTheElement) {
    struct Run {
        const char* element;
        double nu;
        std::vector<int> n;
        double order;
    };
    for (const Run& run : {Run{"hex8", 0.3, {2, 4, 8}, 2.0}, Run{"hex8", 0.499, {2, 4, 8}, 2.0},
                           Run{"hex8_mean_dilatation", 0.499, {2, 4, 8}, 2.0}, Run{"hex8_full", 0.3, {2, 4, 8}, 2.0},
                           Run{"tet4", 0.3, {2, 4, 8}, 2.0}, Run{"tet10", 0.3, {1, 2, 4}, 3.0},
                           Run{"tet10", 0.499, {1, 2, 4}, 3.0}, Run{"tet10_full", 0.3, {1, 2, 4}, 3.0}}) {
        std::vector<double> h, error;
        for (const int n : run.n) {
            h.push_back(1.0 / n);
            error.push_back(relative_error(run.element, n, run.nu));
        }
        const std::vector<double> orders = test::observed_orders(h, error);
        const std::string name = std::string(run.element) + (run.nu > 0.4 ? "_nu0499" : "_nu03");
        test::record(name + "_errors", error);
        test::record(name + "_orders", orders);
        EXPECT_GT(orders.back(), run.order - 0.25) << name;
    }
}

/// The patch test through the solver: from a wrong start inside, equilibrium is the homogeneous deformation, to the
/// tolerance.
TEST(MeshConvergence, HomogeneousDeformationIsFoundByTheSolver) {
    Eigen::Matrix3d A;
    A << 1.15, 0.2, -0.1, 0.05, 0.9, 0.15, -0.1, 0.1, 1.05;
    for (const std::string& element : fem::element_ids())
        for (const double nu : {0.3, 0.499}) {
            const fem::ElementKind kind = test::element(element);
            const mesh::VolumeMesh mesh = test::distorted_mesh(fem::cell_type(kind), {3, 3, 3}, 0.2, 5);
            const model::Model model = held_at_its_boundary(mesh, kind, nu);
            const Matrix3Xd exact = test::mapped(mesh, A);
            Matrix3Xd x = exact;
            for (const int node : model.body->pattern.free_nodes)
                x.col(node) += 0.005 * Vector3d(std::sin(node), std::cos(node), std::sin(2.0 * node));
            SolverOptions options;
            options.tolerance = 1e-6;  // without loads it refers to a millionth of the stiffness; rounding is at 1e-13
                                       // of it
            StageSolver solver(model, options);
            const StageReport report = solve_equilibrium(solver, 0.0, x);
            EXPECT_TRUE(report.ok()) << element << " " << report.message;
            EXPECT_LT((x - exact).cwiseAbs().maxCoeff(), 1e-10) << element << " nu " << nu;
        }
}

}  // namespace
}  // namespace myo::dynamics
