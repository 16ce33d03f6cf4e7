#include "base/markup.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo {
namespace {

using test::infinity;
using test::nan;

TEST(MarkupFault, FindsWhatIsBroken) {
    EXPECT_EQ(test::markup_fault("<a b=\"1\"><c/>x &amp; y</a>"), "");
    for (const char* broken : {"<a>", "<a></b>", "<a><b></a></b>", "<a>&</a>", "<a b=1/>", "<a b=\"<\"/>",
                               "<a>1 < 2</a>", "<a/><b/>x", "<a b=\"1\" b=\"2\"/>", "<a>\x01</a>"})
        EXPECT_NE(test::markup_fault(broken), "") << broken;
}

TEST(EscapeMarkup, EscapesAndKeepsUtf8) {
    EXPECT_EQ(escape_markup("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    EXPECT_EQ(escape_markup("Λ = 2 µm, 10⁻³ 🙂\n\t"), "Λ = 2 µm, 10⁻³ 🙂\n\t");
}

TEST(EscapeMarkup, ReplacesWhatXmlForbids) {
    const std::string mark = "\xEF\xBF\xBD";
    EXPECT_EQ(escape_markup(std::string_view("a\0b\x01", 4)), "a" + mark + "b" + mark);
    EXPECT_EQ(escape_markup("\xFFz"), mark + "z");
    EXPECT_EQ(escape_markup("\xC3"), mark);                                   // cut off
    EXPECT_EQ(escape_markup("\xC0\xAF"), mark + mark);                        // overlong
    EXPECT_EQ(escape_markup("\xED\xA0\x80"), mark + mark + mark);             // surrogate
    EXPECT_EQ(escape_markup("\xF4\x90\x80\x80"), mark + mark + mark + mark);  // beyond Unicode
}

TEST(Pixel, IsAlwaysAFiniteNumber) {
    EXPECT_EQ(svg_number(12.0), "12");
    EXPECT_EQ(svg_number(12.345), "12.35");
    EXPECT_EQ(svg_number(-0.001), "0");
    EXPECT_EQ(svg_number(100.0), "100");
    EXPECT_EQ(svg_number(nan), "-100000");
    EXPECT_EQ(svg_number(infinity), "100000");
    EXPECT_EQ(svg_number(-1e300), "-100000");
}

TEST(ReadableNumber, RoundsAndScales) {
    EXPECT_EQ(readable_number(0.0, 4), "0");
    EXPECT_EQ(readable_number(1.23456, 4), "1.235");
    EXPECT_EQ(readable_number(-0.00012345, 3), "−0.000123");
    EXPECT_EQ(readable_number(9.9996, 4), "10.00");
    EXPECT_EQ(readable_number(260000.0, 3), "260000");
    EXPECT_EQ(readable_number(2.6e8, 3), "2.60 × 10⁸");
    EXPECT_EQ(readable_number(-3.2e-12, 2), "−3.2 × 10⁻¹²");
    EXPECT_EQ(readable_number(nan, 3), "–");
    EXPECT_EQ(readable_number(-infinity, 3), "–");
}

TEST(FixedDecimals, HasNoNegativeZero) {
    EXPECT_EQ(fixed_decimals(-0.0, 2), "0.00");
    EXPECT_EQ(fixed_decimals(-0.004, 2), "0.00");
    EXPECT_EQ(fixed_decimals(-1.5, 1), "−1.5");
}

}  // namespace
}  // namespace myo
