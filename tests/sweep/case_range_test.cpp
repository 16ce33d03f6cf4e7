#include "cases/case_range.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

// Shares of numbered cases for several processes on one folder.

namespace myo::cases::case_range_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CaseRange, SharesAreDisjointAndTogetherAll) {
    for (const int first : {0, 1, 7})
        for (const int count : {0, 1, 5, 24})
            for (const int parts : {1, 2, 3, 30}) {
                std::vector<int> all;
                std::size_t least = 1000, most = 0;
                for (int part = 0; part < parts; ++part) {
                    const std::vector<int> own = numbers_of({.first = first, .cases = count, .share = {part, parts}});
                    EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
                    least = std::min(least, own.size()), most = std::max(most, own.size());
                    all.insert(all.end(), own.begin(), own.end());
                }
                std::sort(all.begin(), all.end());
                ASSERT_EQ(all.size(), static_cast<std::size_t>(count));
                for (int k = 0; k < count; ++k) EXPECT_EQ(all[static_cast<std::size_t>(k)], first + k);
                // No process has more than one case above another.
                EXPECT_LE(most - least, 1u);
            }
}

TEST(CaseRange, SharesInterleave) {
    EXPECT_THAT(numbers_of({.first = 1, .cases = 6, .share = {1, 3}}), ElementsAre(1, 4));
    EXPECT_THAT(numbers_of({.first = 1, .cases = 6, .share = {0, 3}}), ElementsAre(3, 6));
    EXPECT_THAT(numbers_of({.first = 4, .cases = 0}), IsEmpty());
    EXPECT_EQ(numbers_of({}).size(), 24u);
}

/// More cases of a range leave those that a process has as they are.
TEST(CaseRange, ALongerRangeKeepsTheCasesOfAShare) {
    const std::vector<int> some = numbers_of({.first = 0, .cases = 20, .share = {2, 4}}),
                           more = numbers_of({.first = 0, .cases = 40, .share = {2, 4}});
    ASSERT_LT(some.size(), more.size());
    EXPECT_TRUE(std::equal(some.begin(), some.end(), more.begin()));
}

TEST(CaseRange, SharesAreTypedFromOneOn) {
    for (const auto& [text, part, parts] :
         {std::tuple{"1/1", 0, 1}, std::tuple{"1/4", 0, 4}, std::tuple{"4/4", 3, 4}, std::tuple{"32/2000", 31, 2000}}) {
        const std::optional<Share> share = parse_share(text);
        ASSERT_TRUE(share) << text;
        EXPECT_EQ(share->part, part) << text;
        EXPECT_EQ(share->parts, parts) << text;
    }
    for (const char* text : {"", "/", "1", "1/", "/4", "0/4", "5/4", "-1/4", "1/-4", "1.0/4", "+1/4", " 1/4", "1/4 ",
                             "1//4", "1/4/4", "a/b", "1/99999999999"})
        EXPECT_FALSE(parse_share(text)) << text;
}

}  // namespace
}  // namespace myo::cases::case_range_test
