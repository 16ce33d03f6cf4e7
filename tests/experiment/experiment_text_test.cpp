#include "experiment/experiment_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/folder.hpp"
#include "toml/toml_value.hpp"

namespace myo::experiment {
namespace {

namespace fs = std::filesystem;

/// Names may hold what TOML escapes; from the other folder they lead to the files that they named.
TEST(ExperimentText, KeepsNamesWithBackslashesAndQuotes) {
    const test::Folder folder("experiment_text");
    const fs::path home = fs::canonical(folder.path()), out = home / "out";
    const std::string text = R"(laws = ["law\\a.toml", "say \"b\".toml"]
# trace = "C:\data.csv" is no TOML string and stays
[[trial]]
trace = "a\\b.csv"
actuation = "say \"up\".csv"  # a comment
sensors = 'c\d.csv'
)";
    const std::string moved = experiment_text_for(out, text, home);
    EXPECT_NE(moved.find("# trace = \"C:\\data.csv\" is no"), std::string::npos) << moved;
    EXPECT_NE(moved.find("  # a comment\n"), std::string::npos) << moved;
    const Result<toml::TomlValue> read = toml::parse_toml(moved, "");
    ASSERT_TRUE(read) << read.error().text() << "\n" << moved;
    const auto file = [&](const toml::TomlValue& name) { return (out / name.text).lexically_normal(); };
    EXPECT_EQ(file(read->find("laws")->items[0]), home / "law\\a.toml");
    EXPECT_EQ(file(read->find("laws")->items[1]), home / "say \"b\".toml");
    const toml::TomlValue& trial = read->find("trial")->items[0];
    EXPECT_EQ(file(*trial.find("trace")), home / "a\\b.csv");
    EXPECT_EQ(file(*trial.find("actuation")), home / "say \"up\".csv");
    EXPECT_EQ(file(*trial.find("sensors")), home / "c\\d.csv");
}

}  // namespace
}  // namespace myo::experiment
