#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fit/declared_fit.hpp"
#include "diagnosis/made_fits.hpp"
#include "diagnosis/recorded_beam.hpp"
#include "diagnosis/search/search_effects.hpp"
#include "diagnosis/verdict/verdict.hpp"

// A search that ends at a limit of time, and what is kept of it.

namespace myo::diagnosis::search_limit_test {
namespace {

using std::chrono::hours;
using std::chrono::seconds;
using std::chrono::steady_clock;
using testing::HasSubstr;

const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false};

/// A limit holds while it lives, ends no later than one around it, and says whether it was the reason.
TEST(SearchLimit, HoldsForAScope) {
    PhaseLog log{Progress()};
    {
        const PhaseLimit outer(log, steady_clock::now() + hours(1));
        EXPECT_FALSE(log.cancelled());
        {
            const PhaseLimit inner(log, steady_clock::now() - seconds(1));
            EXPECT_TRUE(log.cancelled());
            EXPECT_TRUE(inner.passed());
        }
        EXPECT_FALSE(log.cancelled());
        EXPECT_FALSE(outer.passed());
    }
    const PhaseLimit past(log, steady_clock::now() - seconds(1));
    const PhaseLimit wider(log, steady_clock::now() + hours(1));
    EXPECT_TRUE(log.cancelled());
    EXPECT_FALSE(wider.passed()) << "the limit around it passed";
}

TEST(SearchLimit, SharesTheTimeThatIsLeft) {
    EXPECT_EQ(share_of_rest(Progress(), 0.5), Progress::Moment::max()) << "no limit";
    const auto before = steady_clock::now();
    const auto half = share_of_rest(Progress().until(before + hours(2)), 0.5);
    const auto after = steady_clock::now();
    EXPECT_GE(half, before + hours(1));
    EXPECT_LE(half, after + hours(1));
}

/// Without any time for the search there is a verdict all the same, which says so.
TEST(SearchLimit, LeavesAVerdictThatStatesIt) {
    const test::Folder folder("search_limit");
    DiagnoseSettings settings = test::among({drag.id, "linear_drag"});
    settings.search_limit_s = 1e-6;
    const Diagnosis d = diagnose(test::recorded_with(folder, {drag}), settings);
    ASSERT_TRUE(d.complete()) << d.failure;
    EXPECT_FALSE(d.search_complete);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);
    EXPECT_THAT(d.verdict.reason, HasSubstr("was found in the time for the search"));
    EXPECT_THAT(d.verdict.reason, HasSubstr("ended at its limit of 1e-06 s"));
    EXPECT_TRUE(d.before.ok() && d.after.ok());
}

/// A limit that is not reached changes nothing.
TEST(SearchLimit, OfAnHourChangesNothing) {
    const test::Folder folder("search_no_limit");
    DiagnoseSettings settings = test::among({drag.id});
    settings.search_limit_s = 3600.0;
    const Diagnosis d = diagnose(test::recorded_with(folder, {drag}), settings);
    ASSERT_TRUE(d.complete()) << d.failure;
    EXPECT_TRUE(d.search_complete);
    EXPECT_THAT(test::ids_of(d.verdict.effects), testing::ElementsAre(drag.id));
    EXPECT_NEAR(d.verdict.confidence, d.settings.policy.verdict.undoubted, 0.05);
}

/// The verdict of an unfinished search is trusted less, also in the words that the last fit repeats.
TEST(SearchLimit, LowersTheConfidence) {
    Diagnosis whole = test::with_candidate(0.3), part = whole;
    test::decided(whole);
    part.search_complete = false;
    part.settings.search_limit_s = 60.0;
    test::decided(part);
    const double factor = part.settings.policy.verdict.unfinished_search;
    EXPECT_LT(factor, 1.0);
    EXPECT_DOUBLE_EQ(part.verdict.confidence, factor * whole.verdict.confidence);
    EXPECT_DOUBLE_EQ(part.verdict.trust, factor * whole.verdict.trust);
    EXPECT_THAT(part.verdict.cautions, HasSubstr("limit of 60 s"));
    EXPECT_EQ(whole.verdict.cautions, "");
}

/// Fits that were finished before the search was ended are among its results.
TEST(SearchLimit, KeepsFinishedFits) {
    const test::Folder folder("search_keeps");
    const setup::Setup setup = test::recorded_with(folder, {drag});
    const DiagnoseSettings settings = test::among({drag.id, "linear_drag", "soft_patch"});
    std::atomic<bool> cancel{false};
    // Ends the search with the first fit of a candidate, which the event names.
    const Progress progress(
        [&](const ProgressEvent& event) { cancel = cancel || (event.task == "refit" && !event.message.empty()); },
        &cancel);
    FitStore store;
    PhaseLog log{progress};
    DeclaredFit declared = fit_declared(prepared_setup(setup, settings), settings, store, log);
    DiagnosisContext context{declared.setup, settings, declared.data, declared.fit, {}, {}};
    const Screening screening = screen_effects(context, store, log);
    const RankedFits found = search_likely_effects({context, screening, {}},
                                                   {{}, listed_candidates(screening.scores), {}}, store, log);
    ASSERT_TRUE(log.cancelled());
    EXPECT_EQ(std::count_if(found.candidates.begin(), found.candidates.end(),
                            [](const Candidate& candidate) { return candidate.judged.has_value(); }),
              1);
}

}  // namespace
}  // namespace myo::diagnosis::search_limit_test
