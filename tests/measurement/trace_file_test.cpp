#include <gtest/gtest.h>

#include <set>

#include "measurement/c3d_writer.hpp"
#include "measurement/test_files.hpp"
#include "measurement/trace_file.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;

TEST(TraceFile, IsToldByItsFirstLines) {
    EXPECT_EQ(guess_trace_source(TemporaryFile("time_s,a_x_m,a_y_m,a_z_m\n0,1,2,3\n").path())->format, "csv");
    EXPECT_EQ(guess_trace_source(TemporaryFile("NO_OF_FRAMES\t1\nNO_OF_MARKERS\t1\n").path())->format, "qtm_tsv");
    const auto table = guess_trace_source(TemporaryFile("\n1.5;2;nan;;NULL;3e-2\n", "stream.txt").path());
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_EQ(table->format, "columns");
    EXPECT_EQ(table->columns->separator, ';');
    EXPECT_EQ(table->columns->labels, (std::vector<std::string>{"marker 1", "marker 2"}));
    EXPECT_EQ(table->columns->rate_Hz, 0.0) << "nobody can know it";
    EXPECT_EQ(guess_trace_source(TemporaryFile("1 2 3\n4 5 6\n").path())->columns->separator, ' ');
}

TEST(TraceFile, ReadersHaveIdsOfTheirOwn) {
    std::set<std::string> ids;
    for (const TraceReader& reader : trace_readers()) {
        EXPECT_TRUE(ids.insert(reader.id).second) << reader.id;
        EXPECT_EQ(find_trace_reader(reader.id), &reader);
        EXPECT_FALSE(reader.recognise("no recording at all")) << reader.id;
    }
    EXPECT_EQ(find_trace_reader("xyz"), nullptr);
}

TEST(TraceFile, SaysWhatItDoesNotKnow) {
    EXPECT_FALSE(guess_trace_source(TemporaryFile("").path()));
    EXPECT_FALSE(guess_trace_source(TemporaryFile("solid beam\n facet normal 0 0 1\n").path()));
    EXPECT_FALSE(guess_trace_source(TemporaryFile("1,2,3,4\n").path())) << "not x y z of whole markers";
    EXPECT_FALSE(guess_trace_source("/no/such/file"));
}

}  // namespace
}  // namespace myo::measurement
