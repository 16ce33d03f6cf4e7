#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "dynamics/statics.hpp"
#include "reproduce/chambered_arm.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Mean displacement of the lower face's points under a pressure, from where they rest without.
Vector3d tip_under(const ChamberedArm& arm, double pressure_Pa) {
    Vector3d tip = Vector3d::Zero();
    Matrix3Xd x = arm.model.body->mesh.nodes;
    for (const double p : {0.0, pressure_Pa}) {
        model::Model model = arm.model;
        model.force_elements = {model::cavity_pressure(*model.body, arm.walls, fibre::Signal::constant(p))};
        dynamics::StageSolver solver(model);
        const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, x);
        EXPECT_TRUE(report.ok()) << report.message;
        for (const measurement::MarkerBinding& binding : arm.points.bindings)
            tip += (p > 0.0 ? 0.25 : -0.25) * measurement::marker_position(binding, x(Eigen::all, binding.nodes));
    }
    return tip;
}

/// The body's surface as an ASCII STL in mm, the quadrilaterals cut along the diagonal.
void write_surface(const std::filesystem::path& file, const model::Body& body) {
    std::ofstream out(file);
    out << "solid arm\n";
    for (Eigen::Index f = 0; f < body.boundary.count(); ++f)
        for (const int second : {1, 2}) {
            out << "facet normal 0 0 0\nouter loop\n";
            for (const int corner : {0, second, second + 1}) {
                const Vector3d X = 1e3 * body.mesh.nodes.col(body.boundary.nodes(corner, f));
                out << "vertex " << X(0) << ' ' << X(1) << ' ' << X(2) << '\n';
            }
            out << "endloop\nendfacet\n";
        }
    out << "endsolid arm\n";
}

TEST(ChamberedArm, BendsAwayFromItsPressureInProportionToSmallOnes) {
    const test::Folder nowhere("chamber_nowhere");
    ReproduceSettings settings;
    settings.data = nowhere.path();
    const Result<ChamberedArm> arm = make_chambered_arm(settings, 9e-3);
    ASSERT_TRUE(arm) << arm.error().text();
    EXPECT_EQ(arm->chambers, 4);
    EXPECT_EQ(model::open_edges(*arm->model.body, arm->walls), 0);
    // Two chambers of 13.2 x 13.2 x 90 mm.
    EXPECT_NEAR(model::cavity_volume(*arm->model.body, arm->walls, arm->model.body->mesh.nodes),
                2.0 * 13.2e-3 * 13.2e-3 * 90e-3, 1e-9);
    const Vector3d once = tip_under(*arm, 200.0), twice = tip_under(*arm, 400.0), far = tip_under(*arm, 7500.0);
    EXPECT_LT(once(0), 0.0);
    EXPECT_NEAR(twice(0) / once(0), 2.0, 0.05);
    EXPECT_LT(std::abs(far(1)), 1e-6);  // symmetric
    EXPECT_LT(far(0), 20.0 * once(0));
}

/// The same arm from a surface of its own, meshed with tetrahedra round its chambers.
TEST(ChamberedArm, FromAFileIsTheSameArm) {
    const test::Folder folder("chamber_file");
    ReproduceSettings settings;
    settings.data = folder.path();
    const Result<ChamberedArm> plain = make_chambered_arm(settings, 5e-3), fine = make_chambered_arm(settings, 3e-3);
    ASSERT_TRUE(plain) << plain.error().text();
    ASSERT_TRUE(fine) << fine.error().text();
    std::filesystem::create_directories(chamber_geometry_file(settings).parent_path());
    write_surface(chamber_geometry_file(settings), *plain->model.body);
    const Result<ChamberedArm> read = make_chambered_arm(settings, 9e-3);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->chambers, 4);
    EXPECT_EQ(read->model.body->kind, fem::ElementKind::tet10);
    const Vector3d a = tip_under(*fine, 2000.0), b = tip_under(*read, 2000.0);
    test::record("tip_x_from_tetrahedra_over_hexahedra", b(0) / a(0));
    EXPECT_NEAR(b(0) / a(0), 1.0, 0.08);
    EXPECT_NEAR(b(2) / a(2), 1.0, 0.15);
}

TEST(ReproduceArmChamber, ComparesChambersWithMusclesWithoutAnyData) {
    const test::Folder nowhere("chamber_case");
    ReproduceSettings settings;
    settings.data = nowhere.path();
    settings.coarse = true;
    const Result<Reproduction> result = find_reproduction("arm-chamber")->run(settings, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->warnings.size(), 2u);
    const report::Json rows = table_json(result->tables.front());
    ASSERT_EQ(rows.size(), 7u) << "the walls ballooned";
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (const char* grows : {"chambers grown by [ml]", "AC1 level"})
            EXPECT_GT(rows[i].at(grows).get<double>(), rows[i - 1].at(grows).get<double>()) << grows;
}

}  // namespace
}  // namespace myo::reproduce
