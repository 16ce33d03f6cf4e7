#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "check/step_level.hpp"
#include "mesh/quality.hpp"
#include "prediction/time_step.hpp"
#include "support/made_calibration.hpp"
#include "support/not_finite.hpp"
#include "support/swung_beam.hpp"

namespace myo::check::judgement_limits_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The swung beam, with a noise of 0.1 mm, and a calibration of modulus and damping that was not run.
class JudgementLimits : public testing::Test {
protected:
    JudgementLimits()
        : folder_("judgement_limits"), setup_(test::swung_beam(folder_, 0.1)), made_(test::made_calibration(setup_)) {}

    /// The finding on units of one key.
    Finding unit(const std::string& key) const {
        for (const Finding& finding : check_units({setup_}))
            if (finding.subject == key) return finding;
        return passed_finding("none", "");
    }
    /// The only finding of a check after the fit.
    Finding only(std::vector<Finding> (*find)(const CheckedJob&), const std::vector<Finding>& earlier = {}) const {
        const std::vector<Finding> found = find({setup_, &made_.after, &made_, &earlier});
        EXPECT_EQ(found.size(), 1u);
        return found.empty() ? Finding{} : found.front();
    }

    test::Folder folder_;
    setup::Setup setup_;
    calibration::Calibration made_;
};

TEST_F(JudgementLimits, OfUnitsBelongToTheRange) {
    experiment::Experiment& e = setup_.experiment;
    const auto expect_range = [&](const std::string& key, const std::function<void(double)>& set, double low,
                                  double high) {
        for (const double inside : {low, high}) {
            set(inside);
            EXPECT_EQ(unit(key).level, CheckLevel::passed) << key << " " << inside;
            EXPECT_EQ(unit(key).way_out, "");
        }
        for (const double outside : {0.99 * low, 1.01 * high}) {
            if (outside == low) continue;  // from zero on
            set(outside);
            const Finding finding = unit(key);
            EXPECT_EQ(finding.level, CheckLevel::doubtful) << key << " " << outside;
            EXPECT_EQ(finding.threshold, outside < low ? low : high) << key;
            EXPECT_THAT(finding.sentence, HasSubstr(outside < low ? "below what" : "above what"));
            EXPECT_THAT(finding.way_out, HasSubstr("in place of"));
        }
    };
    expect_range(
        "material.youngs_modulus_Pa", [&](double v) { e.material.youngs_modulus_Pa = v; }, 500.0, 5e9);
    expect_range(
        "material.density_kg_m3", [&](double v) { e.material.density_kg_m3 = v; }, 20.0, 25e3);
    expect_range(
        "material.damping_s", [&](double v) { e.material.damping_s = v; }, 0.0, 0.5);
    expect_range(
        "gravity_m_s2",
        [&](double v) {
            e.gravity_m_s2 = {0.0, -v, 0.0};
        },
        0.0, 30.0);
    expect_range(
        "markers.noise_m", [&](double v) { e.markers.noise_m = v; }, 0.0, 0.02);
    // Gravity counts by its length.
    e.gravity_m_s2 = {20.0, 20.0, 20.0};
    EXPECT_EQ(unit("gravity_m_s2").level, CheckLevel::doubtful);
    // Units that are not declared are not judged.
    e.material.damping_s.reset();
    e.markers.noise_m.reset();
    EXPECT_EQ(unit("material.damping_s").subject, "none");
    EXPECT_EQ(unit("markers.noise_m").subject, "none");
}

/// The body is 100 mm long.
TEST_F(JudgementLimits, OfTheBodyAreThoseOfItsLargestSide) {
    const Eigen::Matrix3Xd rest = setup_.surface.vertices;
    for (const double length_m : {0.0019, 0.0021, 4.9, 5.1}) {
        setup_.surface.vertices = 10.0 * length_m * rest;
        EXPECT_NEAR(unit("body").figure, length_m, 1e-12);
        EXPECT_EQ(unit("body").level, length_m < 0.002 || length_m > 5.0 ? CheckLevel::doubtful : CheckLevel::passed)
            << length_m;
    }
}

TEST_F(JudgementLimits, OfMarkersAreAQuarterOfAnEdge) {
    const double edge = mesh::mean_edge_length(setup_.mesh.mesh);
    std::vector<experiment::MarkerDeclaration>& markers = setup_.experiment.markers.on_body;
    ASSERT_EQ(markers.size(), 4u);
    for (const double share : {0.249, 0.251}) {
        markers[3].rest_m = markers[0].rest_m + Eigen::Vector3d(0.0, share * edge, 0.0);
        const Finding finding = check_markers({setup_}).front();
        EXPECT_EQ(finding.level, share < 0.25 ? CheckLevel::doubtful : CheckLevel::passed) << share;
        EXPECT_NEAR(finding.figure, share * edge, 1e-12);
        EXPECT_NEAR(finding.threshold, 0.25 * edge, 1e-12);
    }
    // A probe is compared with nothing.
    markers[3].rest_m = markers[0].rest_m;
    EXPECT_EQ(check_markers({setup_}).front().level, CheckLevel::doubtful);
    markers[3].probe = true;
    EXPECT_EQ(check_markers({setup_}).front().level, CheckLevel::passed);
    markers.resize(1);
    ASSERT_EQ(check_markers({setup_}).size(), 1u);
    EXPECT_EQ(check_markers({setup_}).front().sentence, "one marker, which any mesh holds");
}

TEST_F(JudgementLimits, OfMarkersOffTheMeshAreThoseOffTheSurface) {
    Eigen::Vector3d& low = setup_.experiment.markers.on_body[2].rest_m;
    ASSERT_EQ(low.z(), 0.0);
    for (const double off_m : {0.99e-3, 1.01e-3}) {
        low.z() = -off_m;
        const std::vector<Finding> found = check_markers({setup_});
        ASSERT_EQ(found.size(), off_m < 1e-3 ? 1u : 2u) << off_m;
        if (found.size() < 2) continue;
        EXPECT_EQ(found[1].subject, "tip_low");
        EXPECT_EQ(found[1].level, CheckLevel::doubtful);
        EXPECT_NEAR(found[1].figure, off_m, 1e-9);
        EXPECT_EQ(found[1].threshold, 1e-3);
    }
}

TEST_F(JudgementLimits, OfResidualsGrowWithTheNumericalError) {
    for (const double numerical : {0.0, 2.4}) {
        made_.numerical.motion_noise_levels = numerical;
        // Noise and error add up as the sides of a right angle: 1 and 2.4 to 2.6.
        const double expected = numerical > 0.0 ? 2.6 : 1.0;
        for (const double ratio : {1.49, 1.51, 9.9, 10.1}) {
            made_.after.fit_rms_m = ratio * expected * 1e-4;
            const Finding finding = only(check_residual);
            EXPECT_EQ(finding.level, ratio < 1.5    ? CheckLevel::passed
                                     : ratio < 10.0 ? CheckLevel::doubtful
                                                    : CheckLevel::wrong)
                << ratio << " " << numerical;
            EXPECT_NEAR(finding.figure, ratio * expected, 1e-9);
            EXPECT_NEAR(finding.threshold, 1.5 * expected, 1e-9);
            EXPECT_EQ(finding.way_out.empty(), ratio < 1.5);
        }
    }
    // Errors that raise the expected residual by less than a tenth are not mentioned: 0.458 does.
    made_.numerical.motion_noise_levels = 0.45;
    EXPECT_THAT(only(check_residual).sentence, Not(HasSubstr("mesh and step")));
    made_.numerical.motion_noise_levels = 0.47;
    EXPECT_THAT(only(check_residual).sentence, HasSubstr("of which mesh and step make about 0.47"));
    made_.after.fit_rms_m = test::nan;
    EXPECT_TRUE(check_residual({setup_, &made_.after, &made_}).empty()) << "no trial to fit completed";
    made_.after.fit_rms_m = 1.0;
    EXPECT_TRUE(check_residual({setup_, &made_.after}).empty()) << "neither a fit nor the declared values";
}

TEST_F(JudgementLimits, OfPlacesAreThreeDeviationsOfACoordinate) {
    setup_.experiment.markers.placement_m = 1e-3;
    EXPECT_TRUE(check_places({setup_, &made_.after, &made_}).empty()) << "exact places";
    made_.places.resize(4);
    made_.after.values.places_m.assign(4, Eigen::Vector3d(2e-3, 2e-3, 2e-3));  // 3.5 mm, but 2 along each axis
    EXPECT_EQ(only(check_places).level, CheckLevel::passed);
    made_.after.values.places_m[1] = {0.0, -3.01e-3, 0.0};
    const Finding finding = only(check_places);
    EXPECT_EQ(finding.level, CheckLevel::doubtful);
    EXPECT_EQ(finding.subject, "tip_right");
    EXPECT_NEAR(finding.figure, 3.01e-3, 1e-15);
    EXPECT_NEAR(finding.threshold, 3e-3, 1e-15);
    made_.after.values.places_m[1] = {0.0, -2.99e-3, 0.0};
    EXPECT_EQ(only(check_places).level, CheckLevel::passed);
    EXPECT_TRUE(check_places({setup_}).empty());
}

TEST_F(JudgementLimits, OfFittedValuesAreTheirBounds) {
    EXPECT_EQ(only(check_bounds).level, CheckLevel::passed);
    EXPECT_EQ(only(check_influence).level, CheckLevel::passed);
    const inverse::Parameter& modulus = made_.parameters[0].parameter;
    made_.fit.values(0) = modulus.upper - 0.5e-6 * modulus.scale;
    const Finding bound = only(check_bounds);
    EXPECT_EQ(bound.level, CheckLevel::doubtful);
    EXPECT_EQ(bound.subject, "youngs_modulus_Pa");
    EXPECT_EQ(bound.threshold, modulus.upper);
    EXPECT_EQ(bound.unit, "Pa");
    EXPECT_TRUE(bound.warned) << "a warning of the calibration says the same";
    made_.fit.values(0) = modulus.upper - 2e-6 * modulus.scale;
    EXPECT_EQ(only(check_bounds).level, CheckLevel::passed);
    made_.fit.undetermined = {{{1}, 0, {}}};
    const Finding loose = only(check_influence);
    EXPECT_EQ(loose.level, CheckLevel::doubtful);
    EXPECT_EQ(loose.sentence, "damping_s: it has no influence on the data");
    EXPECT_TRUE(loose.warned);
    // Its value is the start, which may well be a bound.
    made_.fit.values(1) = made_.parameters[1].parameter.upper;
    EXPECT_EQ(only(check_bounds).level, CheckLevel::passed);
    EXPECT_TRUE(check_bounds({setup_}).empty());
    EXPECT_TRUE(check_influence({setup_}).empty());
}

TEST(StepLevels, AreThoseOfTheModulusOnTheVibration) {
    const double chosen = prediction::step_policy.max_frequency_error;
    EXPECT_EQ(step_level(0.0), CheckLevel::passed);
    EXPECT_EQ(step_level(chosen), CheckLevel::passed) << "what the program itself chooses";
    EXPECT_EQ(step_level(1.49 * chosen), CheckLevel::passed);
    EXPECT_EQ(step_level(1.51 * chosen), CheckLevel::doubtful);
    // An error of the frequency of 1 % is one of the modulus of 2 %.
    EXPECT_EQ(step_level(0.0099), CheckLevel::doubtful);
    EXPECT_EQ(step_level(0.0101), CheckLevel::wrong);
}

TEST_F(JudgementLimits, CarryTheNameAndTheSourceOfTheirCheck) {
    const Check& check = *find_check("units");
    const std::vector<Finding> found = run_check(check, {setup_});
    ASSERT_FALSE(found.empty());
    for (const Finding& finding : found) {
        EXPECT_EQ(finding.check, "units");
        EXPECT_EQ(finding.source, check.source);
    }
}

}  // namespace
}  // namespace myo::check::judgement_limits_test
