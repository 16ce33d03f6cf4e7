#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "measurement/trace_csv.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A fit of a trial of 800 s instead of 0.8 s would take thousands of times as long.
TEST(CoreWrongUnit, AFitToTimesInMillisecondsIsRefused) {
    const test::Folder folder("workbench_unit");
    const fs::path beam = test::beam_in(folder);
    measurement::Recording recording = *measurement::read_trace_csv(beam / "gravity_release.csv");
    recording.time_s *= 1000.0;
    ASSERT_TRUE(measurement::write_trace_csv(beam / "gravity_release.csv", recording));
    test::Driver driver(backend::make_core_backend(), 1400, 900);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().body) << driver.state().log.back().text;
    driver.workbench->execute(ui::commands::Calibrate{});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::failure);
    EXPECT_THAT(driver.state().log.back().text, HasSubstr("state time_unit = \"ms\""));
}

/// A path that no file system takes is told when it is opened.
TEST(CoreUnit, IsNotAskedForWhereNoFileCanBe) {
    const auto backend = backend::make_core_backend();
    EXPECT_NO_THROW(EXPECT_FALSE(backend->needs_unit("/" + std::string(300, 'n') + ".stl")));
}

}  // namespace
}  // namespace myo
