#include "reproduce/reproduction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>

#include "reproduce/real_beam.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"
#include "support/shared_data.hpp"

namespace myo::reproduce {
namespace {

using ::testing::HasSubstr;

/// The measured data, where they are.
std::filesystem::path data_or_nowhere() {
    const std::filesystem::path data = test::shared_data("data/mocap/beam");
    return data.empty() ? std::filesystem::path("nowhere") : data / "../../..";
}
bool has_beam() { return !test::shared_data("data/mocap/beam").empty(); }

ReproduceSettings coarse(const std::filesystem::path& data) {
    ReproduceSettings settings;
    settings.data = data;
    settings.coarse = true;
    settings.threads = 2;
    return settings;
}

Reproduction reproduced(const std::string& id) {
    const ReproductionCase* const one = find_reproduction(id);
    EXPECT_NE(one, nullptr) << id;
    const Result<Reproduction> result = one->run(coarse(data_or_nowhere()), {});
    EXPECT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->warnings.empty(), has_beam());
    return *result;
}

double number_of(const report::Json& json, const char* key) { return json.at(key).get<double>(); }

TEST(Reproduce, ImplicitEulerFollowsThePapersFormula) {
    const report::Json values = reproduced("numerical-damping").values;
    for (const char* key : {"largest_error_our_beam", "largest_error_as_published"}) {
        test::record(key, number_of(values, key));
        EXPECT_LT(number_of(values, key), 0.005) << key;
    }
    EXPECT_LT(std::abs(number_of(values, "tr_bdf2_ratio_at_10_ms")), 0.001);
    if (has_beam()) {
        EXPECT_NEAR(number_of(values, "measured_damping_ratio"), 0.055, 0.006);
    }
}

TEST(Reproduce, LambdaIsTheLinearOneAndOneDampingHoldsAtEveryStep) {
    const report::Json values = reproduced("lambda").values;
    for (const auto& [key, most] : {std::pair{"largest_error_power_iteration", 0.002},
                                    {"largest_error_constant_amplitude", 0.01},
                                    {"largest_decay_error_tr_bdf2", 0.05}}) {
        test::record(key, number_of(values, key));
        EXPECT_LT(number_of(values, key), most) << key;
    }
    // Rate = damping omega^2 / 2 if all of the stiffness damped; only its shear part does, which is most of it.
    const double omega = 2.0 * 3.14159265 * 7.385;
    EXPECT_NEAR(0.5 * number_of(values, "damping_s") * omega * omega, number_of(values, "wanted_decay_1_s"),
                0.05 * number_of(values, "wanted_decay_1_s"));
}

TEST(Reproduce, StaticsGoFromThePublishedModelToTheCommercialSolvers) {
    const report::Json values = reproduced("beam-static").values;
    for (const report::Json& row : values.at("cases")) {
        const std::string label = row.at("case").get<std::string>() + " " + row.at("mesh").get<std::string>();
        const double share = number_of(row, "published_mass_share"),
                     ours = number_of(row, "our_model_dz_m") / number_of(row, "commercial_dz_m");
        test::record(label, ours - 1.0);
        EXPECT_NEAR(ours, 1.0, 0.04) << label;
        // Weight goes with the mass: what is too heavy sinks more.
        EXPECT_EQ(share > 1.0, number_of(row, "published_dz_m") < number_of(row, "true_mass_dz_m")) << label;
        EXPECT_GT(number_of(row, "true_size_dz_m"), 0.75 * number_of(row, "no_locking_dz_m")) << label << ": locks";
        if (row.at("force_N") == 0.0 && has_beam()) {
            EXPECT_NEAR(number_of(row, "measured_dz_m"), -6.5e-3, 0.3e-3);
        }
    }
    // 10 x 3 x 3 cubes of a 10.9th of the length: each vertex weighs as much as a cube.
    EXPECT_NEAR(number_of(values.at("cases").at(0), "published_mass_share"),
                11 * 4 * 4 * std::pow(100.0 / 10.9, 3) / 9e4, 1e-9);
}

TEST(Reproduce, ModulusIsTheSameFromEveryStart) {
    const report::Json values = reproduced("beam-modulus").values;
    EXPECT_EQ(values.at("fits").size(), has_beam() ? 6u : 1u);
    for (const report::Json& fit : values.at("fits")) {
        EXPECT_LT(number_of(fit, "ends_apart"), 1e-3) << fit.at("name");
        EXPECT_LE(number_of(fit, "most_simulations"), 8) << fit.at("name");
        EXPECT_LT(number_of(fit, "rms_m"), 1.2e-3) << fit.at("name");
    }
    test::record("to_the_commercial_Pa", number_of(values.at("fits").at(0), "youngs_modulus_Pa"));
    EXPECT_NEAR(number_of(values.at("fits").at(0), "youngs_modulus_Pa"), 263824.0, 0.015 * 263824.0);
}

TEST(Reproduce, WithoutDataSaysWhatToFetchAndWritesTheRest) {
    const test::Folder folder("reproduce");
    const ReproductionCase* const one = find_reproduction("beam-static");
    const Result<Reproduction> result = one->run(coarse(folder.path()), {});
    ASSERT_TRUE(result) << result.error().text();
    ASSERT_EQ(result->warnings.size(), 1u);
    for (const char* word : {"srl-ethz/diffPD_sim2real", "MYOLOOP_DATA", "data/mocap/beam"})
        EXPECT_THAT(result->warnings[0], HasSubstr(word));
    ASSERT_TRUE(write_reproduction(folder.path() / "out", *one, *result));
    const Result<report::Json> json = report::read_json(folder.path() / "out/beam-static.json");
    ASSERT_TRUE(json) << json.error().text();
    EXPECT_EQ(json->at("schema"), "reproduce/1");
    EXPECT_EQ(json->at("cases").size(), 11u);
    EXPECT_TRUE(json->at("cases").at(0).at("measured_dz_m").is_null());
    EXPECT_EQ(json->at("tables").at(0).at("rows").size(), 11u);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/beam-static.svg"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/report.html"));
}

TEST(Reproduce, CancelledOrWithDamagedDataItStops) {
    const test::Folder folder("reproduce_damaged");
    folder.write("data/mocap/beam/beam_gravity_V2_a.c3d", "not one");
    std::atomic<bool> cancel{true};
    std::set<std::string> ids;
    for (const ReproductionCase& one : reproduction_catalogue()) {
        EXPECT_TRUE(ids.insert(one.id).second) << one.id;
        EXPECT_FALSE(one.summary.empty());
        EXPECT_FALSE(one.run(coarse("nowhere"), Progress({}, &cancel))) << one.id;
    }
    const Result<std::vector<BeamTrial>> damaged = read_beam_trials(coarse(folder.path()));
    ASSERT_FALSE(damaged);
    EXPECT_THAT(damaged.error().text(), HasSubstr("beam_gravity_V2_a.c3d"));
}

TEST(RealBeam, SwingsAndRestsAsThePublishedEnvelopesSay) {
    if (!has_beam()) GTEST_SKIP() << "skipped: no data";
    const Result<std::vector<BeamTrial>> trials = read_beam_trials(coarse(data_or_nowhere()));
    ASSERT_TRUE(trials) << trials.error().text();
    ASSERT_EQ(trials->size(), 4u);
    for (const BeamTrial& trial : *trials) {
        EXPECT_LT(trial.frame_rms_m, 1.4e-3);
        const inverse::DampedCosine vibration = measured_vibration(trial);
        ASSERT_TRUE(vibration.ok);
        test::record(trial.name, vibration.rate_1_s);
        if (trial.tip_force_N == 0.0) {
            EXPECT_NEAR(vibration.rate_1_s, 2.7, 0.25);
            EXPECT_NEAR(vibration.omega_rad_s, 48.6, 0.3);
        }
    }
}

}  // namespace
}  // namespace myo::reproduce
