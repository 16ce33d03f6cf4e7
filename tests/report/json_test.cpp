#include "report/json.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "base/files.hpp"
#include "support/not_finite.hpp"

namespace myo::report {
namespace {

using test::nan;

TEST(Json, NonFiniteNumbersBecomeNull) {
    Json json;
    json["schema"] = "test/1";
    json["value"] = json_number(nan);
    json["raw"] = std::numeric_limits<double>::infinity();  // not through the helper
    json["list"] = json_array(std::vector<double>{1.5, nan, -0.25});
    EXPECT_EQ(json_line(json), R"({"schema":"test/1","value":null,"raw":null,"list":[1.5,null,-0.25]})");
}

TEST(Json, PointsAreOneArrayEach) {
    Eigen::Matrix3Xd points(3, 2);
    points << 1, 4, 2, 5, 3, 6;
    EXPECT_EQ(json_line(json_columns(points)), "[[1.0,2.0,3.0],[4.0,5.0,6.0]]");
    EXPECT_EQ(json_line(json_array(Eigen::VectorXd(points.row(0).transpose()))), "[1.0,4.0]");
    EXPECT_EQ(json_line(json_columns(Eigen::Matrix3Xd(3, 0))), "[]");
}

TEST(Json, NumbersSurviveARoundTripExactly) {
    for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, -5e-324, 1.7976931348623157e308})
        EXPECT_EQ(Json::parse(json_line(json_number(value))).get<double>(), value);
}

TEST(Json, BadBytesDoNotThrow) { EXPECT_EQ(json_line(Json("a\xFFz")), "\"a\xEF\xBF\xBDz\""); }

TEST(Json, FileRoundTripAndOneSentenceForABrokenOne) {
    const auto folder = std::filesystem::temp_directory_path() / ("myoloop_json_" + std::to_string(::getpid()));
    Json json;
    json["b"] = 1;
    json["a"] = {{"deep", true}};
    ASSERT_TRUE(write_json(folder / "x.json", json));
    EXPECT_EQ(read_file(folder / "x.json").value(), "{\n \"b\": 1,\n \"a\": {\n  \"deep\": true\n }\n}\n");
    EXPECT_EQ(read_json(folder / "x.json").value(), json);
    ASSERT_TRUE(write_file(folder / "broken.json", "{\n \"a\": 1,\n \"b\" 2\n}\n"));
    const Result<Json> broken = read_json(folder / "broken.json");
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().where.find("broken.json:3"), std::string::npos) << broken.error().where;
    for (const char* text : {"", "[1e999]", "{\"a\":", "nan"}) {
        ASSERT_TRUE(write_file(folder / "broken.json", text));
        EXPECT_FALSE(read_json(folder / "broken.json")) << text;
    }
    EXPECT_FALSE(read_json(folder / "none.json"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace myo::report
