#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "commands/backend.hpp"
#include "commands/units.hpp"

namespace myo {
namespace {

using ui::commands::dimension_of_unit;
using ui::commands::find_unit;

/// A number field can show only units of its table.
TEST(NumberUnits, EveryParameterOfALawHasAKnownUnit) {
    const auto backend = backend::make_core_backend();
    int numbers = 0;
    for (const ui::commands::Choice& law : backend->materials())
        for (const ui::commands::ChoiceNumber& number : law.numbers) {
            ++numbers;
            EXPECT_NE(find_unit(dimension_of_unit(number.unit), number.unit), nullptr) << number.key;
        }
    EXPECT_GT(numbers, 1);
}

/// The ends of the colours' range are typed in the unit of the field.
TEST(NumberUnits, EveryFieldOfTheBodyHasAKnownUnitOfItsSize) {
    const auto backend = backend::make_core_backend();
    for (const ui::commands::FieldKind& kind : backend->fields()) {
        const ui::commands::Unit* unit = find_unit(dimension_of_unit(kind.unit), kind.unit);
        ASSERT_NE(unit, nullptr) << kind.id;
        EXPECT_DOUBLE_EQ(unit->si(), kind.per_unit) << kind.id;
    }
}

}  // namespace
}  // namespace myo
