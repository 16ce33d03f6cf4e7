#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"
#include "support/folder.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;

TEST(ReproduceCommand, ListsItsCases) {
    const ProgramRun run = run_program({"reproduce"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    for (const char* id :
         {"beam-static", "beam-modulus", "numerical-damping", "lambda", "arm-static", "arm-dynamic", "fish"})
        EXPECT_THAT(run.out, HasSubstr(id));
}

TEST(ReproduceCommand, TurnsDownWhatItDoesNotKnow) {
    for (const auto& [arguments, word] :
         {std::pair{std::vector<std::string>{"reproduce", "beam-statics", "--out", "x"}, "beam-static"},
          {std::vector<std::string>{"reproduce", "lambda"}, "--out"}}) {
        const ProgramRun run = run_program(arguments);
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.err, HasSubstr(word));
    }
}

TEST(ReproduceCommand, WritesTablesFigureAndPage) {
    const Folder folder("reproduce_command");
    const ProgramRun run = run_program({"reproduce", "beam-static", "--coarse", "--out", folder.str("out")});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("true mass"));
    for (const char* file : {"out/beam-static.json", "out/beam-static.svg", "out/report.html"})
        EXPECT_TRUE(folder.has(file)) << file;
}

}  // namespace
}  // namespace myo::test
