#include "diagnosis/report/diagnosis_report.hpp"
#include "diagnosis/unmoved_fit.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <numeric>

#include "base/markup.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "support/markup_check.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

/// Whether a word stands alone in the text, whatever its case.
bool has_word(const std::string& text, const std::string& word) {
    const auto letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t i = 0; i + word.size() <= text.size(); ++i) {
        if ((i > 0 && letter(i - 1)) || letter(i + word.size())) continue;
        bool same = true;
        for (std::size_t k = 0; k < word.size() && same; ++k)
            same = std::tolower(static_cast<unsigned char>(text[i + k])) == word[k];
        if (same) return true;
    }
    return false;
}

/// A beam with drag in its data: the declared fit, a candidate that is the truth, one that failed, one never fitted, a
/// pair and a confusion.
Diagnosis diagnosed(const setup::Setup& setup) {
    Diagnosis d;
    d.data = fit_data(setup, prediction::trials_with_role(setup, experiment::TrialRole::fit));
    d.noise_m = 1e-4;
    d.numerics.step_rms_m = 2e-5;
    d.numerics.step_ratio = 0.5;
    d.numerics.left_rms_m = 1e-5;
    d.numerics.numerical_damping = 3e-4;
    d.numerics.message = "no finer mesh";
    const prediction::ParameterValues declared = prediction::declared_values(setup);
    prediction::ParameterValues dragged = declared;
    dragged.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", 900.0}}});
    d.declared = judged(d.data, test::unmoved_fit(setup, d.data, declared), d.settings);
    JudgedFit with_drag = judged(d.data, test::unmoved_fit(setup, d.data, dragged), d.settings);
    with_drag.fit.report.deviations = Eigen::Vector2d(1.2e3, 12.0);
    with_drag.weight = 0.987;
    Candidate drag, failed, idle;
    drag.score.id = "quadratic_drag";
    drag.score.test.explained = 0.93;
    drag.adjusted_p = 1e-30;
    drag.judged = with_drag;
    failed.score.id = "point_mass";
    failed.score.failure = "the run failed";
    failed.score.test.explained = std::nan("");
    idle.score.id = "clock_offset";
    idle.score.test.explained = std::nan("");
    d.candidates = {drag, failed, idle};
    d.sets = {with_drag};
    d.confusions = {{"quadratic_drag", "linear_drag", 0.998, "a release from twice the height"}};
    d.augmented = with_drag;
    d.before = prediction::run_trials(setup, declared);
    d.after = prediction::run_trials(setup, dragged);
    d.cost = {{"declared fit", 1.5, 12}, {"score", 3.5, 40}};
    d.seconds = 5.0;
    d.verdict = {VerdictKind::effects,
                 with_drag.fit.effects,
                 0.96,
                 "with quadratic_drag it falls.",
                 {"quadratic_drag", "unknown", "none"}};
    return d;
}

class DiagnosisReport : public ::testing::Test {
protected:
    void SetUp() override {
        const prediction::ParameterValues values = prediction::declared_values(setup_);
        prediction::ParameterValues dragged = values;
        dragged.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", 900.0}}});
        for (std::size_t t = 0; t < 2; ++t) {
            const effect::Affected trial = prediction::affected_trial(setup_, t, dragged);
            test::record(setup_, t, values, dynamics::simulate(trial.model, trial.options),
                         static_cast<unsigned>(t + 1));
        }
        diagnosis_ = diagnosed(setup_);
    }

    /// The page without the JSON that it carries, after what every page has to be.
    std::string page() const {
        const std::string whole = report::html(
            diagnosis_report(setup_, diagnosis_, {"1.0", {"myoloop", "diagnose", "<here>"}, 1.0, 0, {}}));
        EXPECT_EQ(test::markup_fault(whole), "");
        std::string seen = whole;
        const std::size_t begin = seen.find("<script type=\"application/json\""), end = seen.find("</script>", begin);
        EXPECT_NE(begin, std::string::npos);
        seen.erase(begin, end - begin);
        for (const char* word : {"nan", "inf"}) EXPECT_FALSE(has_word(seen, word)) << word;
        return seen;
    }

    test::Folder folder_{"diagnosis_report"};
    setup::Setup setup_ = test::swung_beam(folder_);
    Diagnosis diagnosis_;
};

TEST_F(DiagnosisReport, HasAllSectionsAndTheVerdictFirst) {
    const std::string text = page();
    std::size_t last = 0;
    for (const char* title :
         {"Missing from the model: quadratic drag", "Verdict", "Parameters", "Errors", "Motion", "Residual",
          "Is there anything to explain?", "Numerical errors", "Candidates", "Confounded effects", "Cost"}) {
        const std::size_t at = text.find(std::string(">") + title + "</h", last);
        EXPECT_NE(at, std::string::npos) << title;
        if (at != std::string::npos) last = at;
    }
    EXPECT_EQ(text.find("The missing force"), std::string::npos);
    EXPECT_NE(text.find("900 ± 12"), std::string::npos);
    EXPECT_NE(text.find("kg/m³"), std::string::npos);
    EXPECT_NE(text.find("a release from twice the height"), std::string::npos);
    EXPECT_NE(text.find("&lt;here&gt;"), std::string::npos);
}

TEST_F(DiagnosisReport, ShowsTheNumbersOfTheJson) {
    const std::string text = page();
    const report::Json json = diagnosis_json(setup_, diagnosis_, "swung beam");
    for (const char* key : {"before_rms_m", "after_rms_m"})
        EXPECT_NE(text.find(readable_number(1e3 * json["validation"][key].get<double>(), 3) + " mm"), std::string::npos)
            << key;
    EXPECT_EQ(json["details"]["candidates"][0]["fit"]["weight"], 0.987);
    EXPECT_NE(text.find("0.987"), std::string::npos);
    const prediction::TrialScore& score = diagnosis_.before.scores.front();
    EXPECT_EQ(json["details"]["markers"]["swing"]["tip_left"]["before_rms_m"], score.markers.front().rms_m);
}

TEST_F(DiagnosisReport, OfAnUnknownCauseShowsTheForce) {
    diagnosis_.verdict = {VerdictKind::unknown, {}, 0.9, "the residual is significant.", {"unknown"}};
    MissingForce force;
    force.trial = "swing";
    force.time_s = Eigen::VectorXd::LinSpaced(12, 0.0, 0.6);
    force.before_over_noise = 20.0;
    force.after_over_noise = 2.0;
    ForceMode mode;
    mode.pattern = Eigen::Matrix3Xd::Zero(3, setup_.body->node_count());
    mode.amplitude_N = force.time_s.array().sin();
    mode.share = 0.9;
    mode.centroid_m = {0.08, 0.015, 0.015};
    mode.direction = {0.0, 0.0, 1.0};
    mode.where = "at the free end, along +z";
    mode.correlates = {{"|v| v", -0.94, 12.0, 1e-6}, {"time", std::nan(""), 0.0, std::nan("")}};
    force.modes = {mode};
    diagnosis_.missing_force = force;
    const std::string text = page();
    for (const char* words : {"The missing force", "at the free end, along +z", "like a drag", "99.0 %"})
        EXPECT_NE(text.find(words), std::string::npos) << words;
    const report::Json json = diagnosis_json(setup_, diagnosis_, "swung beam");
    EXPECT_NEAR(json["details"]["missing_force"]["removed"].get<double>(), 0.99, 1e-12);
    EXPECT_EQ(json["details"]["missing_force"]["modes"][0]["amplitude_N"].size(), 12u);
    diagnosis_.missing_force->failure = "the trial cannot be run";
    EXPECT_NE(page().find("No force could be inferred"), std::string::npos);
}

TEST_F(DiagnosisReport, OfARightModelHasNoAfter) {
    diagnosis_.verdict = {VerdictKind::none, {}, 0.97, "what is left is noise.", {"none"}};
    diagnosis_.candidates.clear();
    diagnosis_.sets.clear();
    diagnosis_.confusions.clear();
    diagnosis_.augmented = diagnosis_.declared;
    diagnosis_.after = diagnosis_.before;
    const std::string text = page();
    EXPECT_NE(text.find("the declared model is sufficient"), std::string::npos);
    EXPECT_EQ(text.find(">After"), std::string::npos);
    EXPECT_EQ(text.find("Candidates"), std::string::npos);
}

TEST_F(DiagnosisReport, SaysWhichTrialFailed) {
    for (prediction::SetupRun* run : {&diagnosis_.before, &diagnosis_.after}) {
        std::vector<prediction::TrialPrediction> predictions = run->predictions;
        predictions[1] = {};
        predictions[1].status = dynamics::RunStatus::failed;
        predictions[1].message = "it became unstable";
        *run = prediction::scored_run(setup_, run->values, predictions, {0, 1});
    }
    EXPECT_NE(page().find("it became unstable"), std::string::npos);
}

}  // namespace
}  // namespace myo::diagnosis
