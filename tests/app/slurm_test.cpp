#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/sweep_calls.hpp"

// What is handed to Slurm. tests/slurm.sh runs the same on a real cluster of one machine.

namespace myo::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// PATH for the lifetime of the object.
class PathOf {
public:
    explicit PathOf(const std::string& path) : before_(std::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
    ~PathOf() { ::setenv("PATH", before_.c_str(), 1); }
    PathOf(const PathOf&) = delete;
    PathOf& operator=(const PathOf&) = delete;

private:
    std::string before_;
};

/// Runs scripts at once, one task after the other, and says what it was called with.
const char* const obedient_sbatch = R"(#!/bin/bash
script=${@: -1}
echo "${@:1:$#-1}" >>"$(dirname -- "$0")/calls"
tasks=$(sed -n 's/^#SBATCH --array=1-//p' "$script")
for ((i = 1; i <= ${tasks:-1}; ++i)); do SLURM_ARRAY_TASK_ID=$i bash "$script" >/dev/null 2>&1 </dev/null; done
if [[ -n $tasks ]]; then echo "17;cluster"; else echo 18; fi
)";

const std::string of_two = sweep_head() + axis("material.youngs_modulus_Pa", "[2.0e4, 3.0e4]");

TEST(Slurm, WithoutSbatchTheJobsAreWrittenOnly) {
    const Folder folder("slurm_missing");
    write_sweep(folder, of_two, 0.05);
    const PathOf nowhere(folder.str("bin"));
    const ProgramRun run = run_sweep(folder, {"--slurm", "--partition=short", "--time", "10", "--jobs", "2"});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("--slurm: sbatch is not in PATH"));
    const std::string array = content_of(folder.path() / "out/slurm/array.sh"),
                      collect = content_of(folder.path() / "out/slurm/collect.sh");
    for (const char* line : {"#SBATCH --array=1-2\n", "#SBATCH --cpus-per-task=2\n", "#SBATCH --partition=short\n",
                             "#SBATCH --time=10\n", "--share \"$SLURM_ARRAY_TASK_ID/2\" --jobs 2\n"})
        EXPECT_THAT(array, HasSubstr(line));
    EXPECT_THAT(array, Not(HasSubstr("--slurm")));
    EXPECT_THAT(collect, HasSubstr(" --collect\n"));
    EXPECT_THAT(collect, Not(HasSubstr("--array")));
    EXPECT_FALSE(folder.has("out/cases"));
}

/// A share of all cases may stand in the call; each task has its own instead.
TEST(Slurm, TheShareOfTheCallIsNotThatOfATask) {
    const Folder folder("slurm_share");
    write_sweep(folder, of_two, 0.05);
    const PathOf nowhere(folder.str("bin"));
    const std::vector<std::vector<std::string>> spellings{{"--slurm", "--share", "1/1"}, {"--slurm", "--share=1/1"}};
    for (const std::vector<std::string>& words : spellings) {
        EXPECT_THAT(run_sweep(folder, words).err, HasSubstr("sbatch is not in PATH"));
        const std::string array = content_of(folder.path() / "out/slurm/array.sh");
        EXPECT_THAT(array, HasSubstr(" --share \"$SLURM_ARRAY_TASK_ID/2\""));
        EXPECT_EQ(array.find("--share"), array.rfind("--share")) << array;
        EXPECT_THAT(content_of(folder.path() / "out/slurm/collect.sh"), Not(HasSubstr("--share")));
    }
}

TEST(Slurm, TasksAndTheCollectingJobMakeTheTableOfALocalRun) {
    const Folder folder("slurm obeyed");  // the name needs quotes in a shell
    write_sweep(folder, of_two, 0.05);
    folder.write("bin/sbatch", obedient_sbatch);
    fs::permissions(folder.path() / "bin/sbatch", fs::perms::owner_all);
    {
        const PathOf path(folder.str("bin") + ":" + std::getenv("PATH"));
        const ProgramRun run = run_sweep(folder, {"--slurm", "--nodes", "2"});
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("2 cases in 2 tasks: job 17; job 18 collects"));
    }
    EXPECT_EQ(content_of(folder.path() / "bin/calls"), "--parsable\n--parsable --dependency=afterany:17\n");
    const nlohmann::json by_slurm = sweep_rows(folder);
    fs::remove_all(folder.path() / "out");
    ASSERT_EQ(run_sweep(folder).status, 0);
    const nlohmann::json local = sweep_rows(folder);
    ASSERT_EQ(by_slurm.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(by_slurm[i].at("numbers"), local[i].at("numbers"));
}

TEST(Slurm, WhatSbatchRefusesIsSaid) {
    const Folder folder("slurm_refused");
    write_sweep(folder, of_two, 0.05);
    folder.write("bin/sbatch", "#!/bin/bash\necho 'sbatch: error: invalid partition' >&2\nexit 1\n");
    fs::permissions(folder.path() / "bin/sbatch", fs::perms::owner_all);
    const PathOf path(folder.str("bin") + ":" + std::getenv("PATH"));
    const ProgramRun run = run_sweep(folder, {"--slurm"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("invalid partition"));
    EXPECT_EQ(count_lines(run.err), 1);
}

TEST(Slurm, OptionsThatWouldBeIgnoredAreRefused) {
    const Folder folder("slurm_options");
    write_sweep(folder, of_two, 0.05);
    EXPECT_THAT(run_sweep(folder, {"--partition", "x"}).err, HasSubstr("--partition: is an option of --slurm"));
    EXPECT_THAT(run_sweep(folder, {"--slurm", "--collect"}).err, HasSubstr("--collect: does not go with --slurm"));
    EXPECT_THAT(run_sweep(folder, {"--slurm", "--share", "1/2"}).err, HasSubstr("--share: is chosen by --slurm"));
    const ProgramRun validate = run_program({"validate", "--out", folder.str("v"), "--nodes", "2"});
    EXPECT_EQ(validate.status, 2);
    EXPECT_THAT(validate.err, HasSubstr("--nodes: is an option of --slurm"));
}

TEST(Slurm, ValidateIsHandedOverAsWell) {
    const Folder folder("slurm_validate");
    folder.write("v/choice.json", content_of(fs::path(MYOLOOP_SOURCE_DIR) / "assets/validation/seed_9/choice.json"));
    folder.write("v/cases.jsonl", content_of(fs::path(MYOLOOP_SOURCE_DIR) / "assets/validation/seed_9/cases.jsonl"));
    folder.write("bin/sbatch", obedient_sbatch);
    fs::permissions(folder.path() / "bin/sbatch", fs::perms::owner_all);
    const PathOf path(folder.str("bin") + ":" + std::getenv("PATH"));
    // All its cases are finished, so that the tasks have nothing to do.
    const ProgramRun run = run_program(
        {"validate", "--out", folder.str("v"), "--seed", "9", "--cases", "204", "--slurm", "--nodes", "2"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(content_of(folder.path() / "v/slurm/array.sh"),
                HasSubstr("--seed 9 --cases 204 --share \"$SLURM_ARRAY_TASK_ID/2\" --threads 1"));
    EXPECT_TRUE(folder.has("v/validation.html"));
}

}  // namespace
}  // namespace myo::test
