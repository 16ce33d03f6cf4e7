#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "effect/catalogue.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/rigid_motion.hpp"
#include "measurement/trace_csv.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "support/folder.hpp"
#include "validation/synthetic_body.hpp"
#include "validation/synthetic_effects.hpp"
#include "validation/synthetic_folder.hpp"

// Bodies, markers, amounts of effects and recordings of synthetic experiments.

namespace myo::validation::drawn_body_test {
namespace {

using Eigen::Vector3d;

constexpr BodyFamily every_family[] = {BodyFamily::beam, BodyFamily::plate, BodyFamily::ell, BodyFamily::tail,
                                       BodyFamily::threaded};

SyntheticBody body_of(BodyFamily family, bool deep, std::uint64_t seed) {
    RandomStream random{seed, static_cast<std::uint64_t>(family)};
    return drawn_body(family, deep, random);
}

TEST(DrawnBody, NamesOfFamiliesAreReadBack) {
    for (const BodyFamily family : every_family) {
        BodyFamily read{};
        EXPECT_TRUE(parse_body_family(to_string(family), read));
        EXPECT_EQ(read, family);
    }
    EXPECT_EQ(body_family_ids().size(), std::size(every_family));
    BodyFamily untouched = BodyFamily::tail;
    EXPECT_FALSE(parse_body_family("Beam", untouched));
    EXPECT_EQ(untouched, BodyFamily::tail);
}

TEST(DrawnBody, TapersLinearlyAboutItsAxisAndNotBeyondItsEnds) {
    SyntheticBody body;
    body.bounds = {Vector3d(0.0, -0.02, -0.01), Vector3d(0.2, 0.02, 0.01)};
    body.taper_y = 0.5;
    body.taper_z = 0.8;
    EXPECT_LT((body.tapered({0.0, 0.02, -0.01}) - Vector3d(0.0, 0.02, -0.01)).norm(), 1e-15);
    EXPECT_LT((body.tapered({0.1, 0.02, -0.01}) - Vector3d(0.1, 0.015, -0.009)).norm(), 1e-15);
    EXPECT_LT((body.tapered({0.2, -0.02, 0.01}) - Vector3d(0.2, -0.01, 0.008)).norm(), 1e-15);
    EXPECT_LT((body.tapered({0.3, -0.02, 0.01}) - Vector3d(0.3, -0.01, 0.008)).norm(), 1e-15);
    EXPECT_LT((body.tapered({-0.1, 0.02, 0.01}) - Vector3d(-0.1, 0.02, 0.01)).norm(), 1e-15);
}

/// A frustum whose sides shrink to a and b holds (2 + a + b + 2 a b) / 6 of its box.
TEST(DrawnBody, VolumesAreThoseOfTheShapes) {
    for (const BodyFamily family : every_family) {
        const SyntheticBody body = body_of(family, false, 5);
        const Vector3d size = body.bounds.size();
        const double a = body.taper_y, b = body.taper_z;
        double share = 1.0;
        if (family == BodyFamily::tail) share = (2.0 + a + b + 2.0 * a * b) / 6.0;
        if (family == BodyFamily::ell)
            share = 1.0 - (size(0) - body.thickness_m) * (size(2) - body.thickness_m) / (size(0) * size(2));
        const double volume = mesh::enclosed_volume(body.surface);
        EXPECT_NEAR(volume / (share * size.prod()), 1.0, 1e-9) << to_string(family);
    }
}

TEST(DrawnBody, ClampAndLoadedFaceAreAtTheEnds) {
    for (const BodyFamily family : every_family)
        for (const bool deep : {false, true}) {
            const SyntheticBody body = body_of(family, deep, 2);
            const Vector3d middle = body.bounds.lowest + 0.5 * body.bounds.size();
            const double length = body.length_m();
            EXPECT_EQ(body.held_m > 0.0, deep);
            EXPECT_TRUE(body.clamp.contains({0.0, middle.y(), middle.z()})) << to_string(family);
            EXPECT_TRUE(body.clamp.contains({0.0, body.bounds.highest.y(), body.bounds.lowest.z()}));
            EXPECT_EQ(body.clamp.contains({0.1 * length, middle.y(), middle.z()}), deep);
            EXPECT_FALSE(body.clamp.contains({0.3 * length, middle.y(), middle.z()}));
            const Vector3d loaded = family == BodyFamily::ell
                                        ? Vector3d(length - 0.5 * body.thickness_m, middle.y(), body.bounds.highest.z())
                                        : Vector3d(length, middle.y(), middle.z());
            EXPECT_TRUE(body.end.contains(loaded)) << to_string(family);
            EXPECT_FALSE(body.end.contains({0.5 * length, middle.y(), middle.z()})) << to_string(family);
            // Lengths as a person writes them.
            EXPECT_NEAR(1e4 * length, std::round(1e4 * length), 1e-9);
            EXPECT_NEAR(1e4 * body.held_m, std::round(1e4 * body.held_m), 1e-9);
        }
}

TEST(DrawnBody, MarkersAreApartOnTheFreeSurface) {
    for (const BodyFamily family : {BodyFamily::beam, BodyFamily::plate, BodyFamily::ell}) {
        const SyntheticBody body = body_of(family, true, 9);
        RandomStream random{4};
        const std::vector<Vector3d> markers = drawn_markers(body, 5, random);
        ASSERT_EQ(markers.size(), 5u);
        const double length = body.length_m(), free = length - body.held_m;
        for (std::size_t i = 0; i < markers.size(); ++i) {
            const Vector3d low = markers[i] - body.bounds.lowest, high = body.bounds.highest - markers[i];
            EXPECT_GE(std::min(low.minCoeff(), high.minCoeff()), -1e-12);
            if (family != BodyFamily::ell) {
                EXPECT_LT(std::min(low.minCoeff(), high.minCoeff()), 1e-12) << "within the body";
            }
            EXPECT_GE(markers[i].x(), body.held_m + (i < 2 ? 0.8 : 0.12) * free - 1e-12) << i;
            for (std::size_t k = 0; k < i; ++k) EXPECT_GT((markers[i] - markers[k]).norm(), 0.05 * length);
        }
    }
}

TEST(DrawnBody, AStlHoldsItsTrianglesInItsUnit) {
    for (const double unit : {1.0, 1e-3}) {
        SyntheticBody body = body_of(BodyFamily::ell, false, 3);
        body.metres_per_unit = unit;
        const test::Folder folder("drawn_stl");
        folder.write("body.stl", stl_text(body));
        const Result<mesh::SurfaceMesh> read = mesh::read_surface(folder.path() / "body.stl", unit);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->triangles.cols(), body.surface.triangles.cols());
        EXPECT_NEAR(mesh::enclosed_volume(*read) / mesh::enclosed_volume(body.surface), 1.0, 1e-9);
        EXPECT_TRUE(mesh::check_surface(mesh::weld(*read)).outward);
    }
}

TEST(DrawnBody, AnAmountKeepsSignAndDirection) {
    for (const effect::Effect& entry : effect::effect_catalogue()) {
        if (entry.draw.amount.empty() || entry.draw.needs.far_guides) continue;
        const SyntheticCase c = drawn_case({.seed = 1, .families = {}, .effects = {entry.id}}, 1);
        const effect::EffectDeclaration before = with_amount(c.effects.front(), 0.25), after = with_amount(before, 0.5);
        EXPECT_NEAR(effect_amount(before), 0.25, 1e-15) << entry.id;
        EXPECT_NEAR(effect_amount(after), 0.5, 1e-15) << entry.id;
        EXPECT_EQ(std::signbit(effect::number(after.parameters, entry.draw.amount)),
                  std::signbit(effect::number(c.effects.front().parameters, entry.draw.amount)))
            << entry.id;
        EXPECT_EQ(after.parameters.size(), c.effects.front().parameters.size());
        EXPECT_LE(max_amount(c, entry.id), entry.draw.highest) << entry.id;
        EXPECT_GT(max_amount(c, entry.id), 0.0) << entry.id;
    }
}

/// A case of one marker whose recordings are easy to tell from their motion.
SyntheticCase recorded_case() {
    SyntheticCase c;
    c.markers = {Vector3d(0.1, 0.0, 0.0), Vector3d(0.0, 0.1, 0.0)};
    c.noise_m = 0.0;
    c.rate_Hz = 50.0;
    c.trials.resize(1);
    c.trials[0].name = "motion";
    c.trials[0].end_s = 4.0;
    return c;
}

/// The trace that the cameras write of a body at rest.
measurement::Recording seen_at_rest(const SyntheticCase& c) {
    const test::Folder folder("seen_at_rest");
    const std::vector<Eigen::Matrix3Xd> rest{c.markers[0].replicate(1, 201), c.markers[1].replicate(1, 201)};
    EXPECT_TRUE(write_traces(c, {rest}, folder.path()));
    Result<measurement::Recording> read = measurement::read_trace_csv(folder.path() / "motion.csv");
    EXPECT_TRUE(read);
    return read ? *read : measurement::Recording{};
}

TEST(DrawnRecording, IsInTheFrameAndTheClockOfTheCameras) {
    SyntheticCase c = recorded_case();
    c.translation_m = {1e-3, -2e-3, 3e-3};
    c.rotation_rad = {0.0, 0.0, 0.5 * 3.14159265358979324};
    c.trials[0].clock_s = 300.0;
    const measurement::Recording seen = seen_at_rest(c);
    ASSERT_EQ(seen.sample_count(), 201);
    EXPECT_NEAR(seen.time_s(0), 300.0, 1e-12);
    EXPECT_NEAR(seen.time_s(200) - seen.time_s(0), 4.0, 1e-9);
    // A quarter of a turn about z leads x to y and y to -x.
    EXPECT_LT((seen.tracks[0].col(7) - Vector3d(1e-3, 0.098, 3e-3)).norm(), 1e-12);
    EXPECT_LT((seen.tracks[1].col(7) - Vector3d(-0.099, -2e-3, 3e-3)).norm(), 1e-12);
}

TEST(DrawnRecording, HasItsNoiseAndOneMarkerHiddenForAWhile) {
    SyntheticCase c = recorded_case();
    c.noise_m = 1e-3;
    const measurement::Recording noisy = seen_at_rest(c), again = seen_at_rest(c);
    EXPECT_EQ(noisy.tracks[0], again.tracks[0]);
    const Eigen::Matrix3Xd error = noisy.tracks[0].colwise() - c.markers[0];
    // 603 samples: the mean and the deviation are known to 4 % and 3 % of the noise.
    EXPECT_NEAR(error.mean(), 0.0, 0.2e-3);
    EXPECT_NEAR(std::sqrt(error.squaredNorm() / 603.0), 1e-3, 0.15e-3);
    c.number = 1;
    EXPECT_NE(seen_at_rest(c).tracks[0], noisy.tracks[0]);
    c.occluded = 0.1;
    const measurement::Recording hidden = seen_at_rest(c);
    int markers = 0;
    for (const Eigen::Matrix3Xd& track : hidden.tracks) {
        const Eigen::Index gaps = track.row(0).array().isNaN().count();
        markers += gaps > 0 ? 1 : 0;
        if (gaps > 0) {
            EXPECT_EQ(gaps, 20);
        }
    }
    EXPECT_EQ(markers, 1);
}

}  // namespace
}  // namespace myo::validation::drawn_body_test
