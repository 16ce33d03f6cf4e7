#include "diagnosis/fit/joint_fit.hpp"
#include "diagnosis/unmoved_fit.hpp"

#include "diagnosis/discretisation/numerical_error.hpp"
#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::VectorXd;

/// A beam that was recorded with an effect, and its declared model.
struct Recorded {
    test::Folder folder{"joint_fit"};
    setup::Setup setup = test::swung_beam(folder, 0.4);
    explicit Recorded(const std::vector<effect::EffectDeclaration>& effects, double modulus_factor = 1.0) {
        prediction::ParameterValues truth = prediction::declared_values(setup);
        truth.youngs_modulus_Pa *= modulus_factor;
        truth.effects = effects;
        test::record(setup, 0, truth, prediction::predict_trial(setup, 0, truth).trace);
    }
    FitData data() const { return fit_data(setup, {0}); }
};

/// Of all numbers that a joint fit moves, of the model and of what is seen, where two effects act: each column against
/// extrapolated differences of predictions.
TEST(JointFit, HasExactDerivativesByItsOwnAndTheEffectsNumbers) {
    Recorded recorded({});
    for (setup::PreparedTrial& trial : recorded.setup.trials) trial.options.solver.tolerance = 1e-10;
    const FitData data = recorded.data();
    prediction::ParameterValues values = prediction::declared_values(recorded.setup);
    values.effects = {
        {"viscoelastic_creep", {{"modulus_ratio", 0.3}, {"relaxation_time_s", 0.1}}, false},
        {"clock_offset", {{"offset_s", 0.004}}, false},
        {"gravity_tilt", {{"tilt_deg", 3.0}, {"axis", Eigen::VectorXd(Eigen::Vector3d(0.6, 0.0, 0.8))}}, false}};
    const JointFit fit = test::unmoved_fit(recorded.setup, data, values);
    ASSERT_EQ(fit.jacobian.cols(), 7);  // the axis is two angles
    for (Eigen::Index i = 0; i < fit.jacobian.cols(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[static_cast<std::size_t>(i)];
        const double value = prediction::value_of(p, values),
                     step = 0.01 * (p.parameter.over_decades ? value : p.parameter.scale);
        const auto residual = [&](double at) {
            prediction::ParameterValues changed = values;
            prediction::set_value(p, at, changed);
            return flat_residual(data, {prediction::predict_trial(recorded.setup, 0, changed)});
        };
        const auto difference = [&](double h) {
            return VectorXd((residual(value + h) - residual(value - h)) / (2.0 * h));
        };
        const VectorXd exact = (4.0 * difference(0.5 * step) - difference(step)) / 3.0;
        EXPECT_LT((fit.jacobian.col(i) - exact).norm(), 1e-4 * exact.norm())
            << p.parameter.name << ": " << exact.norm();
    }
}

TEST(JointFit, OverlooksNoMassThatIsFarHeavierThanTheBody) {
    const Recorded recorded({});
    const double body_kg = recorded.setup.experiment.material.density_kg_m3 *
                           mesh::cell_volumes(recorded.setup.body->mesh).sum();
    prediction::ParameterValues values = prediction::declared_values(recorded.setup);
    values.effects.push_back(
        {"point_mass", {{"mass_kg", 8.0 * body_kg}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(0.1, 0.0, 0.0))}}});
    FitStore store;
    const FitData data = recorded.data();
    const JointFit found = stored_fit({recorded.setup, data, values, DiagnosisPolicy{}, EffectFreedom::all, {1}}, store,
                                      {});
    EXPECT_LE(std::get<double>(found.values.effects[0].parameters.at("mass_kg")), 3.001 * body_kg);
}

TEST(StoredFit, IsTakenOverForTheSameShiftAndStepsOnly) {
    Recorded recorded({}, 1.05);
    FitData data = recorded.data();
    FitStore store(recorded.folder.path() / "fits.json", "beam");
    const auto fit = [&](FitStore& in) {
        const prediction::ParameterValues start = prediction::declared_values(recorded.setup);
        return stored_fit({recorded.setup, data, start, DiagnosisPolicy{}, EffectFreedom::all, {10}}, in, {});
    };
    const JointFit first = fit(store), again = fit(store);
    EXPECT_GT(first.report.evaluations, 2);
    EXPECT_LT(again.report.evaluations, 2);
    EXPECT_NEAR(again.values.youngs_modulus_Pa, first.values.youngs_modulus_Pa, 1e-9 * first.values.youngs_modulus_Pa);
    recorded.setup.trials[0].options.h_s *= 0.5;
    EXPECT_GT(fit(store).report.evaluations, 2);
    recorded.setup.trials[0].options.h_s *= 2.0;
    // Predictions lower by half a noise level all the time: a little softer is best.
    const dynamics::Trace& trace = first.predictions.front().trace;
    data.shift = {std::vector<Eigen::Matrix3Xd>(
                      recorded.setup.marker_names.size(),
                      Eigen::Matrix3Xd::Constant(3, recorded.setup.trials[0].measured.sample_count(), 5e-5)),
                  {}};
    ASSERT_FALSE(trace.times_s.empty());
    FitStore empty;
    const JointFit shifted = fit(store), fresh = fit(empty);
    EXPECT_NEAR(shifted.values.youngs_modulus_Pa, fresh.values.youngs_modulus_Pa,
                1e-9 * fresh.values.youngs_modulus_Pa);
    EXPECT_GT(std::abs(shifted.values.youngs_modulus_Pa / first.values.youngs_modulus_Pa - 1.0), 1e-5);
}

TEST(NumericalError, ThatAModulusTakesUpExcusesNothing) {
    Recorded recorded({});
    const FitData data = recorded.data();
    const JointFit fit = test::unmoved_fit(recorded.setup, data, prediction::declared_values(recorded.setup));
    const Eigen::MatrixXd& J = fit.jacobian;
    NumericalError error;
    const auto shift_of = [&](const auto& value) {  // of the fit trial, as long as the modulus' column would be by 1 %
        VectorXd flat = value(0.01 * prediction::declared_values(recorded.setup).youngs_modulus_Pa * J.col(0));
        error.shift.assign(2, {});
        error.shift[0].assign(recorded.setup.marker_names.size(),
                              Eigen::Matrix3Xd::Zero(3, recorded.setup.trials[0].measured.sample_count()));
        for (const statistics::ResidualSeries& series : data.layout.series)
            for (Eigen::Index k = series.begin; k < series.end; ++k)
                error.shift[0][static_cast<std::size_t>(series.marker)](
                    series.axis, data.layout.sample[static_cast<std::size_t>(k)]) = flat(k) * data.noise_m(k);
        return flat_rms_m(data, flat);
    };
    const double like_modulus = shift_of([](const VectorXd& column) { return column; });
    EXPECT_LT(extrapolation_left_m(data, error, fit, NumericsPolicy{}), 1e-6 * like_modulus);
    const double unlike = shift_of([&](const VectorXd& column) {
        const VectorXd other = VectorXd::Ones(column.size()) - J.col(0) * (J.col(0).sum() / J.col(0).squaredNorm());
        return VectorXd(other * (column.norm() / other.norm()));
    });
    EXPECT_NEAR(unlike, like_modulus, 1e-9 * like_modulus);
    EXPECT_GT(extrapolation_left_m(data, error, fit, NumericsPolicy{}), 0.3 * unlike);
    EXPECT_LT(extrapolation_left_m(data, error, fit, NumericsPolicy{}), 0.4 * unlike);
}

/// A score that predicts far too large an amount gives a useless start; the amount of the probe is a useful one.
TEST(CandidateFits, RestartFromTheProbeWhereThePredictedStartFails) {
    Recorded recorded({{"quadratic_drag", {{"coefficient_kg_m3", 60.0}}}});
    const FitData data = recorded.data();
    const JointFit base = test::unmoved_fit(recorded.setup, data, prediction::declared_values(recorded.setup));
    FitStore store;
    const DiagnoseSettings settings;
    CandidateStart start{{"quadratic_drag", {{"coefficient_kg_m3", 1e6}}, false}, {}, false, 0.9, {}};
    const auto left = [&] {
        PhaseLog log{Progress()};
        const std::vector<CandidateStart> starts{start};
        const std::vector<JudgedFit> found = fit_candidates(
            {recorded.setup, data, settings, base, starts, base.squares(), 4.0, "refit"}, store, log);
        return found[0].usable() ? found[0].fit.squares() : std::numeric_limits<double>::infinity();
    };
    EXPECT_GT(left(), base.squares());
    start.safe = {{"coefficient_kg_m3", 50.0}};
    EXPECT_LT(left(), 0.5 * base.squares());
}

/// The best fit is far better than another one, of which only the amount is then fitted.
TEST(CandidateFits, ArePrunedWhereTheBestIsFarBetter) {
    Recorded recorded({{"quadratic_drag", {{"coefficient_kg_m3", 60.0}}}});
    const FitData data = recorded.data();
    const JointFit base = test::unmoved_fit(recorded.setup, data, prediction::declared_values(recorded.setup));
    const DiagnoseSettings settings;
    const std::vector<CandidateStart> starts{
        {{"gravity_tilt", {{"tilt_deg", 0.5}, {"axis", Eigen::VectorXd(Eigen::Vector3d(0.0, 1.0, 0.0))}}, false},
         {},
         false,
         0.5,
         {}},
        {{"quadratic_drag", {{"coefficient_kg_m3", 50.0}}, false}, {}, false, 0.9, {}}};
    for (const double pruning_factor : {1.4, 1e12}) {  // the wrong one leaves two times the squares of noise
        FitStore store;
        PhaseLog log{Progress()};
        const std::vector<JudgedFit> found = fit_candidates(
            {recorded.setup, data, settings, base, starts, base.squares(), pruning_factor, "refit"}, store, log);
        ASSERT_TRUE(found[0].usable() && found[1].usable());
        EXPECT_LT(1.4 * found[1].fit.squares(), found[0].fit.squares());
        EXPECT_EQ(found[0].fit.parameters.size() > base.parameters.size() + 1, pruning_factor > 1e6);
    }
}

/// A material that softens far more than the data say, under a modulus that makes up for it: its probe alone is more
/// than is missing.
TEST(EffectScores, GiveStartsWhereAProbeGoesBeyondTheResidual) {
    const Recorded recorded({{"quadratic_drag", {{"coefficient_kg_m3", 60.0}}}});
    const FitData data = recorded.data();
    const JointFit fit = test::unmoved_fit(recorded.setup, data, prediction::declared_values(recorded.setup));
    const auto scores = score_effects(
        recorded.setup, data, fit, fit.predictions,
        [](const std::string& id) { return id == "quadratic_drag" || id == "stress_softening"; }, ProbeSize::small,
        ScreeningPolicy{}, {});
    int starts = 0;
    for (const EffectScore& score : scores) {
        ASSERT_TRUE(score.failure.empty()) << score.failure;
        if (score.id == "quadratic_drag") {
            EXPECT_NEAR(effect::number(score.best.effect, "coefficient_kg_m3"), 60.0, 6.0);
            continue;
        }
        for (const EffectScore::Start& start : score.nonlinear) {
            ++starts;
            ASSERT_EQ(start.step.size(), 1);
            EXPECT_GT(start.step(0), 0.0);
        }
    }
    EXPECT_GT(starts, 0);
}

/// A gradient across a body that bends makes one side as much stiffer as the other softer: what it does goes with its
/// square.
TEST(EffectScores, SeeALargeGradientAcrossTheBodyByLargeProbesOnly) {
    const Recorded recorded({{"stiffness_gradient", {{"relative_change", 1.2}, {"axis", 2.0}}}});
    const FitData data = recorded.data();
    const JointFit fit = test::unmoved_fit(recorded.setup, data, prediction::declared_values(recorded.setup));
    const auto best = [&](ProbeSize size) {
        EffectScore found;
        for (const EffectScore& score : score_effects(recorded.setup, data, fit, fit.predictions,
                                                      [](const std::string& id) { return id == "stiffness_gradient"; },
                                                      size, ScreeningPolicy{}, {}))
            if (score.share() > found.share()) found = score;
        return found;
    };
    const EffectScore small = best(ProbeSize::small), large = best(ProbeSize::large);
    EXPECT_EQ(effect::number(large.best.effect, "axis"), 2.0);
    const double of_noise = static_cast<double>(fit.residual.size());
    EXPECT_LT(large.left - of_noise, 0.8 * (small.left - of_noise));  // the modulus takes most of it back either way
    for (const EffectScore& score : score_effects(recorded.setup, data, fit, fit.predictions,
                                                  [](const std::string& id) { return id == "quadratic_drag"; },
                                                  ProbeSize::large, ScreeningPolicy{}, {}))
        ADD_FAILURE() << score.id << " has no large probe";
}

}  // namespace
}  // namespace myo::diagnosis
