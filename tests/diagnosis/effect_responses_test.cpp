#include "diagnosis/screening/effect_responses.hpp"

#include <gtest/gtest.h>

#include "diagnosis/screening/effect_scores.hpp"
#include "prediction/predict_trials.hpp"
#include "support/figures.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis::effect_responses_test {
namespace {

const std::vector<effect::EffectDeclaration> drag{{"quadratic_drag", {{"coefficient_kg_m3", 40.0}}, false}};

/// Responses of the swung beam to the drag.
class Responses {
public:
    Responses() {
        values_ = prediction::declared_values(setup_);
        predictions_ = prediction::predict_trials_with(setup_, values_, data_.trials);
        search_ = effect_search(setup_, data_, values_);
    }

    Eigen::VectorXd with(const std::optional<FirstOrderPolicy>& first_order) const {
        const std::vector<EffectResponse> found = effect_responses({setup_, data_, values_, search_, predictions_},
                                                                   drag, first_order, "score", {});
        EXPECT_EQ(found.size(), 1u);
        EXPECT_EQ(found.front().failure, "");
        return found.front().change;
    }

private:
    test::Folder folder_{"effect_responses"};
    setup::Setup setup_ = test::swung_beam(folder_, 0.3);
    FitData data_ = fit_data(setup_, {0});
    prediction::ParameterValues values_;
    std::vector<prediction::TrialPrediction> predictions_;
    effect::EffectSearch search_;
};

/// Responses below the limit are of first order, near those of runs; above it they are those of runs.
TEST(EffectResponses, AreOfFirstOrderWhereTheyAreSmall) {
    const Responses responses;
    const Eigen::VectorXd by_runs = responses.with(std::nullopt);
    FirstOrderPolicy all, none;
    all.max_response = 1.0;
    none.max_response = 1e-9;
    const double error = (responses.with(all) - by_runs).norm() / by_runs.norm();
    test::record("first order against runs", error);
    EXPECT_GT(error, 1e-4);
    EXPECT_LT(error, 0.2);
    EXPECT_EQ(responses.with(none), by_runs);
}

}  // namespace
}  // namespace myo::diagnosis::effect_responses_test
