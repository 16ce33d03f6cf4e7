#include <gtest/gtest.h>

#include "measurement/observe.hpp"
#include "plain_body.hpp"
#include "support/figures.hpp"

namespace myo::effect {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What cameras report of two markers on a body that falls freely from rest: X - g t^2 / 2, on two meshes.
class MeasurementForms : public testing::TestWithParam<fem::ElementKind> {
protected:
    MeasurementForms() {
        test::BeamSpec spec;
        spec.kind = GetParam();
        spec.cells = {3, 1, 1};
        spec.gravity_m_s2 = 9.81;
        spec.clamped = false;
        beam = test::plain_body(spec);
        beam.context.marker_names = {"tip", "side"};
        beam.context.marker_rest_m = {{0.1, 0.015, 0.012}, {0.061, 0.0, 0.02}};
        stamped_s = VectorXd::LinSpaced(21, 0.0, 0.2);
    }

    std::vector<Matrix3Xd> seen(const std::string& id, const EffectParameters& parameters) const {
        const Affected affected = test::with_effect(beam, id, parameters);
        const dynamics::Trace trace = test::fine_run(affected, 0.005, 0.3);
        const measurement::MarkerTracks tracks = measurement::observe(
            trace, measurement::marker_set(affected.model.body->mesh, beam.context.marker_rest_m),
            measurement::true_times(affected.observation_error, stamped_s));
        return measurement::observed_tracks(affected.observation_error, tracks.positions, stamped_s);
    }

    Vector3d fallen(std::size_t marker, double t) const {
        const double since = std::max(t, 0.0);
        return beam.context.marker_rest_m[marker] - Vector3d(0.0, 0.0, 0.5 * 9.81 * since * since);
    }

    template <class Expected>
    void expect(const std::vector<Matrix3Xd>& tracks, const Expected& expected) const {
        double worst = 0.0;
        for (std::size_t m = 0; m < 2; ++m)
            for (Eigen::Index k = 0; k < stamped_s.size(); ++k)
                worst = std::max(worst, (tracks[m].col(k) - expected(m, stamped_s(k))).norm());
        test::record("worst_m", worst);
        EXPECT_LT(worst, 1e-7);
    }

    test::HeldBeam beam;
    VectorXd stamped_s;
};

TEST_P(MeasurementForms, AClockIsOffset) {
    for (const double d : {0.013, -0.013})
        expect(seen("clock_offset", {{"offset_s", d}}), [&](std::size_t m, double t) { return fallen(m, t + d); });
}

TEST_P(MeasurementForms, ARateIsOther) {
    expect(seen("frame_rate_error", {{"relative_error", 0.04}}),
           [&](std::size_t m, double t) { return fallen(m, t / 1.04); });
}

TEST_P(MeasurementForms, AScaleIsOther) {
    expect(seen("scale_error", {{"relative_error", -0.03}}),
           [&](std::size_t m, double t) { return Vector3d(0.97 * fallen(m, t)); });
}

TEST_P(MeasurementForms, MarkersExchangeTheirNames) {
    expect(seen("marker_swap", {{"markers", std::vector<std::string>{"side", "tip"}}, {"time_s", 0.095}}),
           [&](std::size_t m, double t) { return fallen(t < 0.095 ? m : 1 - m, t); });
}

TEST_P(MeasurementForms, AMarkerSlips) {
    const Vector3d shift(0.002, -0.001, 0.003);
    expect(seen("marker_slip", {{"marker", std::string("side")}, {"shift_m", VectorXd(shift)}, {"time_s", 0.095}}),
           [&](std::size_t m, double t) {
               return Vector3d(fallen(m, t) + (m == 1 && t >= 0.095 ? shift : Vector3d::Zero()));
           });
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, MeasurementForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo::effect
