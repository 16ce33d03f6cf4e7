#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "commands/typed_quantity.hpp"
#include "ui/driver.hpp"

// Thirty-two texts, each typed into fields of six dimensions: a text is the value that it says or is refused with a
// sentence, never another number.

namespace myo::ui {
namespace {

using commands::Dimension;
using test::Driver;

/// A dimension with the unit that its fields show, one to type and one of another dimension.
struct Units {
    Dimension dimension;
    const char* shown;
    const char* typed;
    double typed_si;  // of one typed unit
    double shown_si;
    const char* foreign;
};
const std::vector<Units> six{{Dimension::length, "mm", "cm", 1e-2, 1e-3, "Pa"},
                             {Dimension::pressure, "kPa", "MPa", 1e6, 1e3, "mm"},
                             {Dimension::density, "kg/m³", "g/cm³", 1e3, 1.0, "mm"},
                             {Dimension::time, "ms", "s", 1.0, 1e-3, "mm"},
                             {Dimension::force, "N", "mN", 1e-3, 1.0, "mm"},
                             {Dimension::angle, "°", "rad", 1.0, 0.017453292519943295, "mm"}};

/// `U` stands for the typed unit, `X` for a foreign one. NaN: refused.
struct Text {
    const char* text;
    double number;       // what it says
    bool in_typed_unit;  // otherwise in the shown unit
};
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
const std::vector<Text> texts{{"5", 5.0, false},
                              {"5 U", 5.0, true},
                              {"5U", 5.0, true},
                              {"  5  U ", 5.0, true},
                              {"0,5 U", 0.5, true},
                              {"0.5 U", 0.5, true},
                              {".5", 0.5, false},
                              {"1 200", 1200.0, false},
                              {"1 200,5 U", 1200.5, true},
                              {"1e2", 100.0, false},
                              {"2.5e-1 U", 0.25, true},
                              {"+5", 5.0, false},
                              {"\xe2\x88\x92"
                               "5 U",
                               -5.0, true},
                              {"-0,25", -0.25, false},
                              {"", no_value, false},
                              {"   ", no_value, false},
                              {"abc", no_value, false},
                              {"U", no_value, false},
                              {"5 X", no_value, false},
                              {"5 5 U", no_value, false},
                              {"2o U", no_value, false},
                              {"1,250 U", no_value, false},
                              {"1,000.5", no_value, false},
                              {"1.000.000", no_value, false},
                              {"--5", no_value, false},
                              {"5-3", no_value, false},
                              {"=5", no_value, false},
                              {"5;", no_value, false},
                              {"nan", no_value, false},
                              {"inf U", no_value, false},
                              {"1e400", no_value, false},
                              {"5 U U", no_value, false}};

std::string with_units(std::string text, const Units& units) {
    std::string filled;
    for (const char c : text) filled += c == 'U' ? units.typed : c == 'X' ? units.foreign : std::string(1, c);
    return filled;
}

TEST(TypedTable, ThirtyTextsInSixDimensionsAreTheirValueOrRefused) {
    ASSERT_GE(texts.size(), 30u);
    ASSERT_EQ(six.size(), 6u);
    for (const Units& units : six)
        for (const Text& each : texts) {
            const std::string text = with_units(each.text, units);
            const Result<double> read = commands::parse_quantity(text, units.dimension, units.shown);
            if (std::isnan(each.number)) {
                ASSERT_FALSE(read) << "'" << text << "' in " << units.shown << " became " << *read;
                EXPECT_GT(read.error().what.size(), 10u) << "a sentence is shown";
                continue;
            }
            ASSERT_TRUE(read) << "'" << text << "' in " << units.shown << ": " << read.error().what;
            const double value = each.number * (each.in_typed_unit ? units.typed_si : units.shown_si);
            EXPECT_NEAR(*read, value, 1e-14 * std::abs(value)) << "'" << text << "' in " << units.shown;
        }
}

/// Through the widgets: a field holds what the text says, or keeps its value and shows the sentence.
TEST(TypedTable, FieldsOfTheWindowHoldTheValueOrTheOldOne) {
    Driver driver(1280, 1400);
    driver.open_beam();
    struct Field {
        const char* item;
        const Units& units;
        double (*value)(const commands::Settings&);
    };
    const std::vector<Field> fields{
        {"body/edge_length", six[0], [](const commands::Settings& s) { return s.resolution_m; }},
        {"model/youngs_modulus", six[1], [](const commands::Settings& s) { return s.youngs_modulus_Pa; }},
        {"model/density", six[2], [](const commands::Settings& s) { return s.density_kg_m3; }},
        {"model/damping", six[3], [](const commands::Settings& s) { return s.damping_s; }}};
    for (const Field& field : fields)
        for (const Text& each : texts) {
            const std::string text = with_units(each.text, field.units);
            if (text.find_first_not_of(' ') == std::string::npos) continue;
            const double before = field.value(driver.state().settings);
            driver.double_click(field.item);
            driver.key(ImGuiKey_A, {.ctrl = true});
            driver.type(text);
            driver.key(ImGuiKey_Enter);
            const double after = field.value(driver.state().settings);
            bool told = false;
            for (const auto& [item, place] : driver.window->items().all())
                told = told || item.rfind(std::string(field.item) + ": ", 0) == 0;
            const Result<double> read = commands::parse_quantity(text, field.units.dimension, field.units.shown);
            if (told)
                EXPECT_EQ(after, before) << field.item << " '" << text << "'";
            else
                EXPECT_TRUE(read && std::abs(after - *read) <= 1e-12 * std::abs(*read))
                    << field.item << " '" << text << "' became " << after;
            driver.key(ImGuiKey_Escape);
        }
}

}  // namespace
}  // namespace myo::ui
