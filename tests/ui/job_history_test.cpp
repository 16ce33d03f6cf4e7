#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ui/bare_workbench.hpp"

// What jobs leave behind: records, messages and settings, also of those that fail.

namespace myo::ui::job_history {
namespace {

using commands::JobOutcome;
using test::BareWorkbench;

/// A beam whose jobs fail in ways that a test sets.
class FaultyBeam : public test::CoarseBeam {
public:
    std::string mesh_error, run_exception, run_problem;
    std::vector<std::string> run_warnings;
    bool nothing_to_calibrate = false;

    Result<commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                 const Progress& progress) override {
        Result<commands::Scene> scene = CoarseBeam::open(path, metres_per_unit, progress);
        if (scene && nothing_to_calibrate) scene->calibrated.clear();
        return scene;
    }
    Result<commands::MeshedBody> mesh(const commands::Scene& scene, const commands::Settings& settings,
                                      const Progress& progress) override {
        if (!mesh_error.empty()) return Error{mesh_error, ""};
        return CoarseBeam::mesh(scene, settings, progress);
    }
    Result<commands::RunResult> simulate(const commands::Scene& scene, const commands::MeshedBody& body,
                                         const commands::Settings& settings,
                                         const std::optional<commands::RunExtent>& only,
                                         const Progress& progress) override {
        if (!run_exception.empty()) throw std::runtime_error(run_exception);
        Result<commands::RunResult> run = CoarseBeam::simulate(scene, body, settings, only, progress);
        if (run) run->problem = run_problem, run->warnings = run_warnings;
        return run;
    }
};

struct FaultyBench : BareWorkbench {
    FaultyBench() : FaultyBench(std::make_shared<FaultyBeam>()) {}
    explicit FaultyBench(const std::shared_ptr<FaultyBeam>& made) : BareWorkbench(made), beam(made) {}

    bool logged(commands::LogLevel level, const std::string& text) const {
        return std::any_of(state().log.begin(), state().log.end(),
                           [&](const commands::LogLine& line) { return line.level == level && line.text == text; });
    }
    const commands::JobRecord& last() const { return state().history.back(); }

    std::shared_ptr<FaultyBeam> beam;
};

TEST(JobHistory, KeepsTheNewestSixty) {
    BareWorkbench bench;
    bench.open_beam();
    std::vector<int> ids;
    for (int k = 0; k < 62; ++k) {
        bench.execute_and_wait(commands::BuildMesh{});
        ids.push_back(bench.state().history.back().id);
    }
    ASSERT_EQ(bench.state().history.size(), 60u);
    for (std::size_t k = 0; k < 60; ++k) EXPECT_EQ(bench.state().history[k].id, ids[k + 2]);
    EXPECT_FALSE(bench.state().record(ids[1]));
    ASSERT_TRUE(bench.state().record(ids[2]));
    EXPECT_EQ(bench.state().record(ids[2])->name, "Mesh");
    EXPECT_EQ(bench.state().record(ids[2])->summary, "3 hex8") << "as many cells as edges fit";
}

TEST(JobHistory, ABodyThatCannotBeMeshedEndsWhatNeedsIt) {
    FaultyBench bench;
    bench.open_beam();
    const auto body = bench.state().body;
    bench.change([](commands::Settings& s) { s.resolution_m = 0.01; }, "resolution");
    bench.beam->mesh_error = "the surface is open";
    bench.execute_and_wait(commands::Run{});
    EXPECT_FALSE(bench.state().run);
    EXPECT_EQ(bench.state().body, body) << "the last one stays";
    EXPECT_EQ(bench.last_message(), "Cannot mesh: the surface is open");
    EXPECT_EQ(bench.last().name, "Simulate");
    EXPECT_EQ(bench.last().outcome, JobOutcome::failed);
    EXPECT_EQ(bench.last().summary, "the surface is open");
    EXPECT_FALSE(bench.last().can_be_restored());
    // Restoring it does nothing, and the next attempt may succeed.
    const commands::Settings before = bench.settings();
    bench.execute(commands::RestoreRecord{bench.last().id});
    EXPECT_EQ(bench.settings(), before);
    bench.beam->mesh_error.clear();
    bench.execute_and_wait(commands::Run{});
    EXPECT_TRUE(bench.state().run_is_current());
    EXPECT_EQ(bench.state().history.size(), 2u);
}

TEST(JobHistory, AnExceptionIsAMessageAndTheNextJobRuns) {
    FaultyBench bench;
    bench.open_beam();
    bench.beam->run_exception = "out of memory";
    bench.execute(commands::Run{});
    bench.execute(commands::BuildMesh{});
    bench.wait();
    EXPECT_TRUE(bench.logged(commands::LogLevel::failure, "Simulate stopped: out of memory"));
    ASSERT_EQ(bench.state().history.size(), 2u);
    EXPECT_EQ(bench.state().history[0].outcome, JobOutcome::failed);
    EXPECT_EQ(bench.state().history[0].summary, "out of memory");
    EXPECT_EQ(bench.state().history[1].outcome, JobOutcome::done);
    EXPECT_TRUE(bench.state().queue.empty());
    EXPECT_FALSE(bench.state().run);
}

TEST(JobHistory, ProblemsAndWarningsOfARunAreToldAndItsTimeDoesNotCount) {
    FaultyBench bench;
    bench.open_beam();
    bench.beam->run_problem = "the trial ends at 0.4 s";
    bench.beam->run_warnings = {"the step is long", "the mesh is coarse"};
    bench.execute_and_wait(commands::Run{});
    for (const char* text : {"the trial ends at 0.4 s", "the step is long", "the mesh is coarse"})
        EXPECT_TRUE(bench.logged(commands::LogLevel::warning, text)) << text;
    EXPECT_TRUE(bench.state().run);
    EXPECT_TRUE(bench.state().preferences.step_costs.empty()) << "it did not take all of its steps";
    bench.beam->run_problem.clear();
    bench.execute_and_wait(commands::Run{});
    ASSERT_EQ(bench.state().preferences.step_costs.size(), 1u);
    EXPECT_DOUBLE_EQ(bench.state().preferences.step_costs[0].seconds, 1.3 / 200.0);
    EXPECT_EQ(bench.state().preferences.step_costs[0].dofs, bench.state().body->dofs);
}

TEST(JobHistory, AStepThatTheProgramChoseIsNoEdit) {
    FaultyBench bench;
    bench.open_beam();
    bench.beam->chosen_step_s = 0.002;
    bench.execute_and_wait(commands::Run{});
    EXPECT_EQ(bench.settings().time_step_s, 0.002);
    EXPECT_FALSE(bench.settings().own_step);
    EXPECT_TRUE(bench.state().run_is_current());
    EXPECT_EQ(bench.last().settings.time_step_s, 0.002) << "the step that was used";
    EXPECT_FALSE(bench.state().unsaved());
    EXPECT_FALSE(bench.state().can_undo);
    // A step of the user is kept.
    bench.change([](commands::Settings& s) { s.time_step_s = 0.004; }, "step");
    EXPECT_TRUE(bench.settings().own_step);
    bench.execute_and_wait(commands::Run{});
    EXPECT_EQ(bench.settings().time_step_s, 0.004);
}

TEST(JobHistory, OnlyRunsAreComparedAndUnknownRecordsAreIgnored) {
    FaultyBench bench;
    bench.open_beam();
    bench.execute_and_wait(commands::BuildMesh{});
    bench.execute_and_wait(commands::Run{});
    const int mesh_id = bench.state().history[0].id, run_id = bench.state().history[1].id;
    for (const int id : {mesh_id, run_id, run_id + 100}) bench.execute(commands::CompareRecord{id, true});
    EXPECT_FALSE(bench.state().history[0].compared);
    EXPECT_TRUE(bench.state().history[1].compared);
    bench.execute(commands::CompareRecord{run_id, false});
    EXPECT_FALSE(bench.state().history[1].compared);
    const commands::Settings before = bench.settings();
    bench.execute(commands::ForgetRecord{run_id + 100});
    bench.execute(commands::RestoreRecord{run_id + 100});
    bench.execute(commands::Unqueue{run_id + 100});
    EXPECT_EQ(bench.state().history.size(), 2u);
    EXPECT_EQ(bench.settings(), before);
    bench.execute(commands::ForgetRecord{mesh_id});
    ASSERT_EQ(bench.state().history.size(), 1u);
    EXPECT_EQ(bench.state().history[0].id, run_id);
    EXPECT_TRUE(bench.state().run) << "what is shown stays";
}

TEST(JobHistory, SearchesWithoutAnythingToFindSayWhatIsMissing) {
    FaultyBench bench;
    bench.beam->nothing_to_calibrate = true;
    bench.open_beam();
    const auto refused = [&](const commands::Command& command) {
        bench.execute(command);
        EXPECT_FALSE(bench.state().busy());
        EXPECT_EQ(bench.state().log.back().level, commands::LogLevel::warning);
        return bench.last_message();
    };
    EXPECT_EQ(refused(commands::Calibrate{}),
              "Nothing to calibrate: the experiment has no measured trial or declares every value as known.");
    EXPECT_EQ(refused(commands::Optimize{}),
              "Nothing to optimise: add a muscle, a chamber or a tendon, or tick a modulus.");
    bench.change([](commands::Settings& s) { s.muscles.resize(1); }, "muscle");
    commands::OptimizeRequest request;
    request.signals = false;
    request.seek = {"of another experiment"};
    bench.execute(commands::ChangeOptimize{request});
    EXPECT_EQ(refused(commands::Optimize{}), "Nothing to optimise: tick what the search may change.");
    EXPECT_TRUE(bench.state().history.empty());
}

}  // namespace
}  // namespace myo::ui::job_history
