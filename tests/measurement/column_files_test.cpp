#include "measurement/column_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

TEST(Columns, HeaderlessTableInMillimetres) {
    const TemporaryFile file("1;2;3;4;5;6\r\n1;2;3;;;\r\n0;0;0;NULL;nan;6\r\n", "fish.csv");
    ColumnLayout layout{{"spine", "base"}, 1e-3, ';', 50.0};
    Result<Recording> read = read_columns(file.path(), layout);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->tracks[1].col(0).isApprox(Eigen::Vector3d(4e-3, 5e-3, 6e-3), 1e-15));
    EXPECT_TRUE(read->tracks[1].col(1).array().isNaN().all());
    EXPECT_TRUE(read->tracks[1].col(2).array().isNaN().all());
    EXPECT_EQ(read->tracks[0].col(2), Eigen::Vector3d(0, 0, 0));
    EXPECT_NEAR(read->time_s(2), 0.04, 1e-15);
    layout.zero_is_occluded = true;
    EXPECT_TRUE(read_columns(file.path(), layout)->tracks[0].col(2).array().isNaN().all());
}

TEST(Columns, ErrorsNameTheField) {
    const TemporaryFile file("1 2 3\n  1   2  x\n", "plain.txt");
    EXPECT_THAT(read_columns(file.path(), {{"p"}, 1.0, ' ', 100.0}).error().text(),
                HasSubstr("plain.txt:2: column 3 (p z) is 'x'"));
    EXPECT_THAT(read_columns(file.path(), {{"p", "q"}, 1.0, ' ', 100.0}).error().text(),
                HasSubstr("plain.txt:1: has 3 fields, expected 6"));
    EXPECT_THAT(read_columns(file.path(), {{"p"}, 0.0, ' ', 100.0}).error().text(), HasSubstr("no length unit"));
    EXPECT_THAT(read_columns(file.path(), {{"p"}, 1.0, ' ', 0.0}).error().text(), HasSubstr("no rate"));
    EXPECT_THAT(read_columns(file.path(), {{}, 1.0, ' ', 100.0}).error().text(), HasSubstr("no marker"));
    const TemporaryFile empty("\n\n", "plain.txt");
    EXPECT_THAT(read_columns(empty.path(), {{"p"}, 1.0, ' ', 100.0}).error().text(), HasSubstr("no rows"));
}

HeaderMapping motive_like() {
    HeaderMapping mapping;
    mapping.markers = {{"tip", {"X", "Y", "Z"}}};
    mapping.time_column = "Time (ms)";
    mapping.seconds_per_unit = 1e-3;
    mapping.metres_per_unit = 1e-2;
    return mapping;
}

TEST(MappedCsv, ReadsTheNamedColumnsOnly) {
    const TemporaryFile file(
        "exported by a program, version 2\n\"Time (ms)\",comment,Z,X,Y\n0,\"a, b\",3,1,2\n8,c,3,1,2\n", "other.csv");
    HeaderMapping mapping = motive_like();
    mapping.header_line = 2;
    const Result<Recording> read = read_mapped_csv(file.path(), mapping);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->tracks[0].col(1).isApprox(Eigen::Vector3d(0.01, 0.02, 0.03), 1e-15));
    EXPECT_NEAR(read->rate_Hz, 125.0, 1e-9);
}

TEST(MappedCsv, DecimalCommaAndRateInsteadOfTime) {
    const TemporaryFile file("X;Y;Z\n1,5;2;3\n;2;3\n", "comma.csv");
    HeaderMapping mapping = motive_like();
    mapping.time_column.reset();
    mapping.rate_Hz = 10.0;
    mapping.separator = ';';
    mapping.decimal_comma = true;
    const Result<Recording> read = read_mapped_csv(file.path(), mapping);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_DOUBLE_EQ(read->tracks[0](0, 0), 0.015);
    EXPECT_TRUE(read->tracks[0].col(1).array().isNaN().all());
    EXPECT_DOUBLE_EQ(read->time_s(1), 0.1);
}

TEST(MappedCsv, ErrorsOfMappingAndContent) {
    const TemporaryFile file("Time (ms),X,Y,Zed\n0,1,2,3\n", "other.csv");
    EXPECT_THAT(read_mapped_csv(file.path(), motive_like()).error().text(),
                HasSubstr("other.csv:1: column 'Z' is not in the header"));
    HeaderMapping mapping = motive_like();
    mapping.time_column = "Time (s)";
    EXPECT_THAT(read_mapped_csv(file.path(), mapping).error().text(), HasSubstr("the closest name is 'Time (ms)'"));
    mapping.time_column.reset();
    EXPECT_THAT(read_mapped_csv(file.path(), mapping).error().text(), HasSubstr("neither a time column nor a rate"));
    mapping = motive_like();
    mapping.decimal_comma = true;
    EXPECT_THAT(read_mapped_csv(file.path(), mapping).error().text(), HasSubstr("both decimal mark and separator"));
    mapping = motive_like();
    mapping.header_line = 9;
    EXPECT_THAT(read_mapped_csv(file.path(), mapping).error().text(), HasSubstr("no header in line 9"));
    const TemporaryFile twice("Time (ms),X,Y,Z,X\n0,1,2,3,4\n", "other.csv");
    EXPECT_THAT(read_mapped_csv(twice.path(), motive_like()).error().text(), HasSubstr("'X' appears twice"));
    const TemporaryFile bad("Time (ms),X,Y,Z\n0,1,2,3\n5,1,2,three\n", "other.csv");
    EXPECT_THAT(read_mapped_csv(bad.path(), motive_like()).error().text(),
                HasSubstr("other.csv:3: column 4 (Z) is 'three'"));
}

}  // namespace
}  // namespace myo::measurement
