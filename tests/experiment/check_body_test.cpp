#include "experiment/check_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"
#include "support/shared_data.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;

/// Two surfaces in one.
mesh::SurfaceMesh joined(const mesh::SurfaceMesh& a, const mesh::SurfaceMesh& b) {
    mesh::SurfaceMesh both{Eigen::Matrix3Xd(3, a.vertices.cols() + b.vertices.cols()),
                           Eigen::Matrix3Xi(3, a.triangles.cols() + b.triangles.cols())};
    both.vertices << a.vertices, b.vertices;
    both.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.vertices.cols())).matrix();
    return both;
}

// The good experiment with its box given as an STL in millimetres.
class CheckBody : public testing::Test {
protected:
    CheckBody() : folder_("check_body") { write(mesh::box_surface(Box{{0, 0, 0}, {0.1, 0.03, 0.03}})); }
    void write(const mesh::SurfaceMesh& surface) {
        toml_ = replaced(good_toml, "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]\norigin_m = [0.0, 0.0, 0.0]",
                         "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"mm\"");
        write_files(folder_, toml_);
        EXPECT_TRUE(mesh::write_stl(folder_.path() / "body.stl", surface, 1e-3));
    }
    Result<void> check(const std::vector<std::pair<std::string, std::string>>& overrides = {}) const {
        const Result<Experiment> e = read_experiment(folder_.path(), overrides);
        if (!e) return e.error();
        const Result<mesh::SurfaceMesh> body = read_body_surface(*e);
        if (!body) return body.error();
        return check_on_body(*e, *body);
    }

    Folder folder_;
    std::string toml_;
};

TEST_F(CheckBody, AGoodStlIsReadInMetres) {
    const Result<void> good = check();
    EXPECT_TRUE(good) << good.error().text();
    const Result<mesh::SurfaceMesh> body = read_body_surface(*read_experiment(folder_.path()));
    ASSERT_TRUE(body);
    EXPECT_NEAR(mesh::enclosed_volume(*body), 9e-5, 1e-11);
    // Boxes that lie in a face, or wholly inside the material, hold material too.
    EXPECT_TRUE(check({{"clamp.box_m", "[[0,0,0],[0,0.03,0.03]]"}}));
    EXPECT_TRUE(check({{"clamp.box_m", "[[0.02,0.01,0.01],[0.03,0.02,0.02]]"}}));
    EXPECT_TRUE(check({{"muscle[0].box_m", "[[0.02,0.01,0.01],[0.03,0.02,0.02]]"}}));
}

TEST_F(CheckBody, DeclarationsThatMissTheBodySaySo) {
    struct Case {
        const char* key;
        const char* value;
        const char* word;
    };
    for (const Case& c :
         {Case{"clamp.box_m", "[[-0.02,0,0],[-0.01,1,1]]", "no material"},
          Case{"clamp.box_m", "[[0,0,0],[0.1,0.03,0.03]]", "holds the whole body, nothing can move"},
          Case{"muscle[0].box_m", "[[0.2,0,0],[0.3,1,1]]", "no material"},
          Case{"muscle[0].box_m", "[[0.1,0,0],[0.2,0.03,0.03]]", "no material"},                // touches the tip face
          Case{"muscle[0].box_m", "[[0.05,0,0],[0.05,0.03,0.03]]", "no material"},              // flat
          Case{"trial[0].load[1].box_m", "[[0.05,0.01,0.01],[0.06,0.02,0.02]]", "no surface"},  // inside
          Case{"trial[0].load[1].box_m", "[[0.1,0.03,0.03],[0.2,0.2,0.2]]", "no surface"},      // a corner
          Case{"markers.rest_m.tip", "[0.108, 0, 0.024]", "8 mm off"},
          Case{"markers.rest_m.tip", "[0.05, 0.015, 0.015]", "15 mm off"}}) {
        const Result<void> checked = check({{c.key, c.value}});
        ASSERT_FALSE(checked) << c.key << " " << c.value;
        EXPECT_THAT(checked.error().what, StartsWith(std::string(c.key) + ": "));
        EXPECT_THAT(checked.error().what, HasSubstr(c.word));
        EXPECT_EQ(checked.error().where, "--set");
    }
    EXPECT_TRUE(check({{"markers.rest_m.tip", "[0.1065, 0, 0.024]"}})) << "within max_standoff_m";
    EXPECT_TRUE(check({{"markers.fixed_m.base", "[5, 5, 5]"}})) << "not on the body";
}

TEST_F(CheckBody, BrokenSurfacesNameTheirKey) {
    EXPECT_THAT(check({{"geometry.unit", "m"}}).error().what, StartsWith("geometry.unit: "));
    write(mesh::flipped(mesh::box_surface(Box{{0, 0, 0}, {0.1, 0.03, 0.03}})));
    const Result<void> inward = check();
    ASSERT_FALSE(inward);
    EXPECT_THAT(inward.error().what, HasSubstr("inside out"));
    EXPECT_THAT(inward.error().where, testing::EndsWith(":" + std::to_string(line_of(toml_, "file = "))));
    mesh::SurfaceMesh open = mesh::box_surface(Box{{0, 0, 0}, {0.1, 0.03, 0.03}});
    open.triangles.conservativeResize(3, open.triangles.cols() - 1);
    write(open);
    EXPECT_THAT(check().error().what, HasSubstr("not closed"));
    folder_.write("body.stl", "garbage");
    EXPECT_THAT(check().error().what, StartsWith("geometry.file: "));
}

TEST_F(CheckBody, CavitiesThatFaceOutwardAreTurnedAndOverlapIsRefused) {
    const mesh::SurfaceMesh bar = mesh::box_surface(Box{{0, 0, 0}, {0.1, 0.03, 0.03}});
    write(joined(bar, mesh::box_surface(Box{{0.04, 0.01, 0.01}, {0.06, 0.02, 0.02}})));
    std::vector<std::string> warnings;
    const Result<mesh::SurfaceMesh> hollow = read_body_surface(*read_experiment(folder_.path()), &warnings);
    ASSERT_TRUE(hollow) << hollow.error().text();
    EXPECT_NEAR(mesh::enclosed_volume(*hollow), 9e-5 - 2e-6, 1e-11);
    EXPECT_THAT(warnings, testing::ElementsAre(testing::AllOf(StartsWith("body.stl: part 2, from (40, 10, 10)"),
                                                              HasSubstr("is now a cavity of 2 ml"))));
    write(joined(bar, mesh::box_surface(Box{{0.09, 0.01, 0.01}, {0.16, 0.02, 0.02}})));
    const Result<void> overlap = check();
    ASSERT_FALSE(overlap);
    EXPECT_THAT(overlap.error().what, testing::AllOf(StartsWith("geometry.file: body.stl: two closed parts"),
                                                     HasSubstr("from (90, 10, 10) to (160, 20, 20) mm")));
}

TEST(CheckBodyOfSharedExamples, AllFit) {
    const std::vector<std::filesystem::path> folders = test::shared_experiments();
    if (folders.empty()) GTEST_SKIP() << "skipped: no data";
    for (const std::filesystem::path& folder : folders) {
        const Result<Experiment> e = read_experiment(folder);
        ASSERT_TRUE(e) << e.error().text();
        const Result<mesh::SurfaceMesh> body = read_body_surface(*e);
        ASSERT_TRUE(body) << body.error().text();
        const Result<void> fits = check_on_body(*e, *body);
        EXPECT_TRUE(fits) << fits.error().text();
    }
}

}  // namespace
}  // namespace myo::experiment
