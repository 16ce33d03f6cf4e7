#include "mesh/tet_mesh.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/surface_remesh.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "support/shared_data.hpp"

namespace myo::mesh {
namespace {

// The worker lies beside the test program, or MYOLOOP_TETGEN names it.
class Tetrahedralize : public ::testing::Test {
protected:
    void SetUp() override { ::setenv("TMPDIR", folder_.path().c_str(), 1); }
    void TearDown() override {
        EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "temporary files were left behind";
        EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child process was left behind";
        ::unsetenv("TMPDIR");
    }
    test::TemporaryFolder folder_;
};

TetOptions with_edge(double edge, CellType type = CellType::tet4) {
    TetOptions options;
    options.edge = edge;
    options.type = type;
    return options;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST_F(Tetrahedralize, FillsBodiesExactly) {
    for (const SurfaceMesh& surface :
         {box_surface(test::unequal_box()), test::cylinder(24, 0.015, 0.06), test::l_shape()}) {
        for (const CellType type : {CellType::tet4, CellType::tet10}) {
            const auto mesh = tetrahedralize(surface, with_edge(0.004, type));
            ASSERT_TRUE(mesh) << mesh.error().text();
            EXPECT_EQ(mesh->type, type);
            const QualityReport report = mesh_quality(*mesh, &surface);
            EXPECT_LT(std::abs(*report.volume_error), 1e-12);
            EXPECT_GT(cell_volumes(*mesh).minCoeff(), 0.0);
            EXPECT_EQ(report.components, 1);
            EXPECT_NEAR(report.mean_edge, 0.004, 0.0012);
        }
    }
}

/// The edges of the surface, and not the bounds on angles, set the number of cells of a slender body.
TEST_F(Tetrahedralize, SlenderBodiesOfShortEdgesAreNotCrowded) {
    SurfaceMesh fine = weld(test::sphere(5, 0.01));
    fine.vertices.row(2) *= 6.0;
    const SurfaceMesh slender = sized_surface(fine, 0.03, 1e-3).surface;
    const auto mesh = tetrahedralize(slender, with_edge(0.03));
    ASSERT_TRUE(mesh) << mesh.error().text();
    // With angles of 15 degrees everywhere there are six times as many cells as triangles.
    EXPECT_LT(mesh->cell_count(), 3 * slender.triangles.cols());
    const QualityReport report = mesh_quality(*mesh, &slender);
    EXPECT_LT(std::abs(*report.volume_error), 1e-12);
    EXPECT_GT(report.least, 0.1);
    EXPECT_GT(report.mean, 0.6);
    // A ratio that is asked for is kept, with the angles that belong to it.
    TetOptions strict = with_edge(0.03);
    strict.radius_edge_ratio = 1.414;
    const auto fine_cells = tetrahedralize(slender, strict);
    ASSERT_TRUE(fine_cells) << fine_cells.error().text();
    EXPECT_GT(fine_cells->cell_count(), 3 * slender.triangles.cols());
}

TEST_F(Tetrahedralize, IsRepeatable) {
    const auto a = tetrahedralize(test::l_shape(), with_edge(0.003)),
               b = tetrahedralize(test::l_shape(), with_edge(0.003));
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->cells, b->cells);
    EXPECT_EQ(a->nodes, b->nodes);
}

TEST_F(Tetrahedralize, VolumeLimitIsKept) {
    TetOptions options;
    options.max_volume = 1e-9;
    const auto mesh = tetrahedralize(test::unwelded(box_surface(test::unequal_box())), options);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_LE(cell_volumes(*mesh).maxCoeff(), 1e-9 * (1 + 1e-9));
}

TEST_F(Tetrahedralize, CavityStaysHollow) {
    const SurfaceMesh hollow = test::together(box_surface({{0, 0, 0}, {0.04, 0.04, 0.04}}),
                                              flipped(box_surface({{0.01, 0.01, 0.01}, {0.03, 0.03, 0.03}})));
    const auto mesh = tetrahedralize(hollow, with_edge(0.008));
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NEAR(cell_volumes(*mesh).sum(), 5.6e-5, 1e-14);
}

TEST_F(Tetrahedralize, BrokenSurfacesAreErrors) {
    const SurfaceMesh box = box_surface(test::unequal_box());
    SurfaceMesh open = box, nan = box, single = box;
    open.triangles = open.triangles.leftCols(11).eval();
    nan.vertices(1, 3) = std::nan("");
    single.triangles = single.triangles.leftCols(1).eval();
    const SurfaceMesh crossing = test::together(box, box_surface({{0.0, 0.025, 0.01}, {0.2, 0.035, 0.03}}));
    for (const SurfaceMesh& surface : {open, nan, single, SurfaceMesh{}, crossing}) {
        const auto mesh = tetrahedralize(surface, with_edge(0.005));
        ASSERT_FALSE(mesh);
        EXPECT_FALSE(mesh.error().what.empty());
    }
    EXPECT_NE(tetrahedralize(open, with_edge(0.005)).error().what.find("not closed"), std::string::npos);
    EXPECT_NE(tetrahedralize(crossing, with_edge(0.005)).error().what.find("intersects itself"), std::string::npos);
    EXPECT_FALSE(tetrahedralize(box, with_edge(-1.0)));
    EXPECT_FALSE(tetrahedralize(box, with_edge(0.005, CellType::hex8)));
}

TEST_F(Tetrahedralize, DuplicateFacetsAreDropped) {
    SurfaceMesh doubled = box_surface(test::unequal_box());
    doubled.triangles.conservativeResize(3, 24);
    doubled.triangles.rightCols(12) = doubled.triangles.leftCols(12).eval();
    EXPECT_TRUE(tetrahedralize(doubled, with_edge(0.01)));
}

TEST_F(Tetrahedralize, TimeLimitIsKept) {
    TetOptions options = with_edge(0.0006);
    options.time_limit_s = 0.2;
    const auto start = std::chrono::steady_clock::now();
    const auto mesh = tetrahedralize(box_surface(test::unequal_box()), options);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().what.find("did not finish"), std::string::npos) << mesh.error().text();
    EXPECT_LT(seconds_since(start), 1.0);
}

TEST_F(Tetrahedralize, CancelIsPrompt) {
    std::atomic<bool> cancel = false;
    std::thread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        cancel = true;
    });
    const auto start = std::chrono::steady_clock::now();
    const auto mesh = tetrahedralize(box_surface(test::unequal_box()), with_edge(0.0006), Progress({}, &cancel));
    const double seconds = seconds_since(start);
    later.join();
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().what.find("stopped"), std::string::npos) << mesh.error().text();
    EXPECT_LT(seconds, 0.7);
}

TEST_F(Tetrahedralize, SizeLimitsAreErrors) {
    const SurfaceMesh box = box_surface(test::unequal_box());
    EXPECT_FALSE(tetrahedralize(box, with_edge(1e-5)));
    TetOptions capped = with_edge(0.002);
    capped.steiner_cap = 50;
    EXPECT_FALSE(tetrahedralize(box, capped));
    TetOptions few = with_edge(0.002);
    few.max_cells = 1500;
    EXPECT_FALSE(tetrahedralize(box, few));
}

TEST_F(Tetrahedralize, HardQualityIsClampedToWhatEnds) {
    TetOptions options = with_edge(0.01);
    options.radius_edge_ratio = 1.0;
    options.min_dihedral_deg = 5.0;
    EXPECT_TRUE(tetrahedralize(box_surface(test::unequal_box()), options));
}

TEST_F(Tetrahedralize, RunsInSeveralThreadsAtOnce) {
    std::vector<std::thread> threads;
    std::array<Eigen::Index, 4> cells{};
    for (std::size_t i = 0; i < 4; ++i) {
        threads.emplace_back([&cells, i] {
            const double size = i % 2 == 0 ? 0.02 : 0.5;
            const auto mesh = tetrahedralize(box_surface({{0, 0, 0}, {size, size, size}}), with_edge(size / 5));
            cells[i] = mesh ? mesh->cell_count() : -1;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(cells[0], 0);
    EXPECT_EQ(cells[0], cells[2]);
    EXPECT_EQ(cells[1], cells[3]);
}

TEST_F(Tetrahedralize, RealGeometry) {
    const std::vector<std::filesystem::path> bodies = test::shared_bodies();
    if (bodies.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& path : bodies) {
        const SurfaceMesh surface = weld(*read_surface(path, 1e-3));
        const auto mesh = tetrahedralize(surface, with_edge(0.006, CellType::tet10));
        ASSERT_TRUE(mesh) << path << ": " << mesh.error().text();
        EXPECT_LT(std::abs(*mesh_quality(*mesh, &surface).volume_error), 1e-6) << path;
    }
}

}  // namespace
}  // namespace myo::mesh
