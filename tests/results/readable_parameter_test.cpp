#include "results/readable_parameter.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "effect/catalogue.hpp"
#include "results/calibration_report.hpp"
#include "support/swung_beam.hpp"

namespace myo::results {
namespace {

TEST(ReadableQuantity, TakesTheUnitFromTheName) {
    struct Expected {
        const char *name, *shown, *unit;
        double factor;
    };
    for (const Expected& e : {Expected{"coefficient_kg_m3", "coefficient", "kg/m³", 1.0},
                              {"linear_Pa_s_m", "linear", "Pa s/m", 1.0},
                              {"stiffness_Pa_per_m", "stiffness", "MPa/m", 1e-6},
                              {"peak_energy_J_m3", "peak energy", "J/m³", 1.0},
                              {"stiffness_N_m", "stiffness", "N/m", 1.0},
                              {"force_N", "force", "mN", 1e3},
                              {"curvature_1_m", "curvature", "1/m", 1.0},
                              {"drift_1_s", "drift", "1/s", 1.0},
                              {"mass_kg", "mass", "g", 1e3},
                              {"tilt_deg", "tilt", "°", 1.0},
                              {"youngs_modulus_Pa", "youngs modulus", "kPa", 1e-3},
                              {"position_m", "position", "mm", 1e3},
                              {"delay_s", "delay", "ms", 1e3},
                              {"relative_change", "relative change", "%", 100.0},
                              {"relative_error", "relative error", "%", 100.0},
                              {"bed_stiffness_N_per_m", "bed stiffness", "N/m", 1.0},
                              {"wind_speed_m_s", "wind speed", "m/s", 1.0},
                              {"k_1_m2", "k", "1/m2", 1.0},
                              {"gain", "gain", "", 1.0}}) {
        const ReadableParameter shown = readable_quantity(e.name);
        EXPECT_EQ(shown.name, e.shown);
        EXPECT_EQ(shown.unit, e.unit) << e.name;
        EXPECT_EQ(shown.factor, e.factor) << e.name;
    }
}

/// What a name promises must be true of the SI prefix: "kPa" is a thousand Pa.
TEST(ReadableQuantity, HasTheFactorOfItsPrefix) {
    for (const effect::Effect& effect : effect::effect_catalogue())
        for (const effect::EffectParameterEntry& p : effect.parameters) {
            const ReadableParameter shown = readable_quantity(p.name);
            const double expected = shown.unit == "kPa" || shown.unit == "km"           ? 1e-3
                                    : shown.unit.starts_with("M")                       ? 1e-6
                                    : shown.unit == "mm" || shown.unit == "ms"          ? 1e3
                                    : shown.unit == "g" || shown.unit.starts_with("mN") ? 1e3
                                    : shown.unit == "%"                                 ? 100.0
                                                                                        : 1.0;
            EXPECT_EQ(shown.factor, expected) << effect.id << " " << p.name;
        }
}

TEST(EffectName, IsTheIdInWords) {
    EXPECT_EQ(effect_name("quadratic_drag"), "Quadratic drag");
    EXPECT_EQ(effect_name("x"), "X");
    EXPECT_EQ(effect_name(""), "");
}

TEST(ReadableParameters, OfEachKind) {
    using Kind = prediction::ModelParameter::Kind;
    const test::Folder folder("readable_parameter");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    const auto shown = [&](Kind kind, std::size_t index = 0) {
        prediction::ModelParameter p;
        p.kind = kind;
        p.index = index;
        p.trial = 1;
        return readable_parameter(p, setup);
    };
    EXPECT_EQ(shown(Kind::youngs_modulus).name, "Young's modulus E");
    EXPECT_EQ(shown(Kind::youngs_modulus).factor, 1e-3);
    EXPECT_EQ(shown(Kind::damping).unit, "ms");
    EXPECT_EQ(shown(Kind::translation, 2).name, "Camera shift z");
    EXPECT_EQ(shown(Kind::translation, 2).factor, 1e3);
    EXPECT_EQ(shown(Kind::rotation, 1).name, "Camera turn about y");
    EXPECT_NEAR(shown(Kind::rotation).factor, 57.29577951308232, 1e-13);
    EXPECT_EQ(shown(Kind::start_shift).name, "Later start of swing again");
    prediction::ModelParameter p;
    p.kind = Kind::effect;
    p.parameter.name = "effect.point_mass.position_m.x";
    p.of_effect = "position_m";
    p.component = 1;
    EXPECT_EQ(readable_parameter(p, setup).name, "Point mass, position y");
    EXPECT_EQ(readable_parameter(p, setup).unit, "mm");
    p.base = Eigen::Vector3d::UnitX();
    EXPECT_EQ(readable_parameter(p, setup).unit, "°");
    EXPECT_EQ(readable_parameter(p, setup).name, "Point mass, position turned 2");
}

TEST(ReadableEstimate, HasTheDecimalsOfItsDeviation) {
    const auto words = [](double value, double deviation) {
        const ReadableEstimate estimate = readable_estimate(value, deviation);
        return estimate.value + " ± " + estimate.deviation;
    };
    EXPECT_EQ(words(283.1234, 0.4321), "283.12 ± 0.43");
    EXPECT_EQ(words(283.1234, 4.321), "283.1 ± 4.3");
    EXPECT_EQ(words(283.1234, 43.21), "283 ± 43");
    EXPECT_EQ(words(-2.0, 0.25), "−2.00 ± 0.25");
    EXPECT_EQ(words(0.0, 0.012), "0.000 ± 0.012");
    // Five digits of the value are enough; the deviation then keeps one digit.
    EXPECT_EQ(words(283.1234, 0.0004321), "283.12 ± 0.0004");
}

TEST(ReadableEstimate, WithoutADeviationHasFourDigits) {
    for (const double deviation :
         {std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(readable_estimate(283.1234, deviation).value, "283.1");
        EXPECT_EQ(readable_estimate(283.1234, deviation).deviation, "");
    }
}

}  // namespace
}  // namespace myo::results
