#include "diagnosis/fit/fit_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "diagnosis/fit/store_words.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis::fit_store_test {
namespace {

using Eigen::Vector2d;

TEST(FitStore, FindsWhatWasKept) {
    const test::Folder folder("fit_store");
    FitStore store(folder.path() / "fits.json", "beam");
    EXPECT_FALSE(store.find("a fit"));
    ASSERT_TRUE(store.keep("a fit", Vector2d(0.1, 1.0 / 3.0)));
    ASSERT_TRUE(store.find("a fit"));
    EXPECT_EQ(*store.find("a fit"), Vector2d(0.1, 1.0 / 3.0));
    EXPECT_FALSE(store.find("another fit"));
    ASSERT_TRUE(store.keep("a fit", Vector2d(2.0, 3.0)));
    EXPECT_EQ(*store.find("a fit"), Vector2d(2.0, 3.0));
}

/// A resumed diagnosis reads the same values to the last bit; one of another setup starts afresh.
TEST(FitStore, IsReadAgainByTheSameSetupOnly) {
    const test::Folder folder("fit_store");
    const std::filesystem::path file = folder.path() / "fits.json";
    const Vector2d values(1.0 / 3.0, 2.6e5 + 1e-9);
    {
        FitStore store(file, "beam");
        ASSERT_TRUE(store.keep("first", values));
        ASSERT_TRUE(store.keep("second", 2.0 * values));
    }
    FitStore same(file, "beam");
    ASSERT_TRUE(same.find("first") && same.find("second"));
    EXPECT_EQ(*same.find("first"), values);
    EXPECT_EQ(*same.find("second"), 2.0 * values);
    FitStore other(file, "another beam");
    EXPECT_FALSE(other.find("first"));
    ASSERT_TRUE(other.keep("third", values));
    EXPECT_FALSE(FitStore(file, "beam").find("first")) << "the file belongs to the other setup now";
}

TEST(FitStore, IgnoresFilesThatItDidNotWrite) {
    const test::Folder folder("fit_store");
    const std::filesystem::path file = folder.path() / "fits.json";
    for (const char* text : {"no json", "[]", R"({"schema": "fits/0", "study": "beam", "fits": {"a": [1]}})",
                             R"({"schema": "fits/1", "study": "beam", "fits": {"a": ["x"], "b": 1}})"}) {
        folder.write("fits.json", text);
        const FitStore store(file, "beam");
        EXPECT_FALSE(store.find("a")) << text;
        EXPECT_FALSE(store.find("b")) << text;
    }
}

TEST(FitStore, KeepsNothingWithoutAFile) {
    FitStore store;
    EXPECT_TRUE(store.keep("a fit", Vector2d::Ones()));
    EXPECT_FALSE(store.find("a fit"));
}

TEST(FitStore, ReportsAFileThatCannotBeWritten) {
    const test::Folder folder("fit_store");
    folder.write("file", "no folder");
    FitStore store(folder.path() / "file" / "fits.json", "beam");
    EXPECT_FALSE(store.keep("a fit", Vector2d::Ones()));
}

/// Whatever changes the result of a fit changes its key; a warm start does not.
TEST(FitKey, DependsOnAllThatTheFitDependsOn) {
    const test::Folder folder("fit_key");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    const FitData data = fit_data(setup, {0});
    const prediction::ParameterValues start = prediction::declared_values(setup);
    const auto key = [&](const auto& change) {
        setup::Setup s = setup;
        FitData d = data;
        prediction::ParameterValues v = start;
        Effort effort{10};
        change(s, d, v, effort);
        return fit_key({s, d, v, DiagnosisPolicy{}, EffectFreedom::all, effort});
    };
    using S = setup::Setup;
    using V = prediction::ParameterValues;
    const std::string plain = key([](S&, FitData&, V&, Effort&) {});
    EXPECT_EQ(key([](S&, FitData&, V&, Effort&) {}), plain);
    WarmStart warm;
    warm.names = {"youngs_modulus_Pa"};
    EXPECT_EQ(fit_key({setup, data, start, DiagnosisPolicy{}, EffectFreedom::all, {10}, warm}), plain);
    const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 60.0}}};
    const std::set<std::string> keys{plain,
                                     key([](S& s, FitData&, V&, Effort&) { s.trials[0].options.h_s *= 0.5; }),
                                     key([](S& s, FitData&, V&, Effort&) { s.modulus_factor = 1.0 + 1e-12; }),
                                     key([](S&, FitData& d, V&, Effort&) {
                                         d.shift = {{Eigen::Matrix3Xd::Constant(3, 2, 1e-9)}, {}};
                                     }),
                                     key([](S&, FitData& d, V&, Effort&) {
                                         d.trials = {0, 1};
                                     }),
                                     key([](S&, FitData&, V& v, Effort&) { v.youngs_modulus_Pa *= 1.0 + 1e-12; }),
                                     key([](S&, FitData&, V&, Effort& effort) { effort.evaluations = 11; }),
                                     key([&](S&, FitData&, V& v, Effort&) { v.effects.push_back(drag); }),
                                     key([](S&, FitData&, V&, Effort& effort) { effort.relative_decrease *= 2.0; }),
                                     key([](S&, FitData&, V&, Effort& effort) { effort.max_jacobians = 1; }),
                                     fit_key({setup, data, start, DiagnosisPolicy{}, EffectFreedom::all, {12}})};
    EXPECT_EQ(keys.size(), 11u);
}

/// The body scaled, or held at one node more.
model::BodyPointer with_other_body(const setup::Setup& setup, double scale, bool more_held) {
    model::Body body = *setup.body;
    body.mesh.nodes *= scale;
    if (more_held) *std::find(body.clamped.begin(), body.clamped.end(), false) = true;
    return std::make_shared<const model::Body>(std::move(body));
}

TEST(StoreWords, DistinguishSetupsByWhatFitsDependOn) {
    const test::Folder folder("store_words");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    const std::string plain = store_words(setup);
    EXPECT_NE(plain.find("swung beam, hex8"), std::string::npos) << plain;
    const auto words = [&](const auto& change) {
        setup::Setup changed = setup;
        change(changed);
        return store_words(changed);
    };
    using S = setup::Setup;
    EXPECT_EQ(words([](S& s) { s.trials[0].options.h_s *= 0.5; }), plain) << "steps stand in the key of each fit";
    const std::set<std::string> all{
        plain,
        words([](S& s) { s.trials[0].measured.tracks[0](0, 0) += 1e-12; }),
        words([](S& s) { s.experiment.material.poissons_ratio += 1e-12; }),
        words([](S& s) { s.noise_m(0) *= 2.0; }),
        words([](S& s) { s.experiment.gravity_m_s2.z() = 0.0; }),
        words([](S& s) { s.experiment.name = "other"; }),
        words([](S& s) { s.trials[1].model.masses.emplace_back(); }),
        words([](S& s) { s.markers.bindings[0].offset.x() += 1e-12; }),
        words([](S& s) { s.body = with_other_body(s, 1.0 + 1e-12, false); }),
        words([](S& s) { s.body = with_other_body(s, 1.0, true); }),
        words([](S& s) { s.trials[0].role = experiment::TrialRole::validate; }),
        words([](S& s) { s.trials[0].sensors.emplace_back(); }),
        words([](S& s) { s.trials[0].recorded_commands = {fibre::Signal::constant(1.0)}; }),
        words([](S& s) { s.trials[0].recorded_commands = {fibre::Signal::constant(2.0)}; })};
    EXPECT_EQ(all.size(), 14u);
}

TEST(PhaseLog, AddsCostsByPhaseInTheirOrder) {
    PhaseLog log{Progress()};
    EXPECT_EQ(log.timed("fit", 2, [] { return 7; }), 7);
    log.timed("score", 5, [] { return 0; });
    log.timed("fit", 3, [] { return 0; });
    log.add("score", 1.5, 1);
    ASSERT_EQ(log.costs().size(), 2u);
    EXPECT_EQ(log.costs()[0].phase, "fit");
    EXPECT_EQ(log.costs()[0].runs, 5);
    EXPECT_EQ(log.costs()[1].phase, "score");
    EXPECT_EQ(log.costs()[1].runs, 6);
    EXPECT_GE(log.costs()[1].seconds, 1.5);
}

TEST(PhaseLog, ReportsPhasesAndIsCancelledByTheUser) {
    std::vector<std::string> reported;
    std::atomic<bool> cancel{false};
    PhaseLog log{Progress([&](const ProgressEvent& event) { reported.push_back(event.task); }, &cancel)};
    log.timed("fit", 0, [] { return 0; });
    EXPECT_EQ(reported, std::vector<std::string>{"fit"});
    EXPECT_FALSE(log.cancelled());
    cancel = true;
    EXPECT_TRUE(log.cancelled());
}

}  // namespace
}  // namespace myo::diagnosis::fit_store_test
