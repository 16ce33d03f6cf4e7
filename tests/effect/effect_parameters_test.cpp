#include <gtest/gtest.h>

#include <Eigen/Core>

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "effect/catalogue.hpp"
#include "effect/effect.hpp"
#include "effect/markers_by_name.hpp"

namespace myo::effect::effect_parameters_tests {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

const EffectParameters mixed{{"mass_kg", 0.25},
                             {"shift_m", VectorXd(Vector3d(2.0, -3.0, 6.0))},
                             {"list", VectorXd(VectorXd::LinSpaced(4, 1.0, 4.0))},
                             {"marker", std::string("tip")},
                             {"markers", std::vector<std::string>{"tip", "side"}}};

TEST(EffectParameterValues, AreReadByTheirType) {
    EXPECT_EQ(number(mixed, "mass_kg"), 0.25);
    EXPECT_EQ(number(mixed, "shift_m"), 7.0) << "the magnitude of a vector";
    EXPECT_EQ(vector(mixed, "shift_m"), Vector3d(2.0, -3.0, 6.0));
    EXPECT_EQ(text(mixed, "marker"), "tip");
    EXPECT_TRUE(has(mixed, "markers"));
    EXPECT_FALSE(has(mixed, "mass"));
    EXPECT_THROW(number(mixed, "mass"), std::out_of_range);
    EXPECT_THROW(number(mixed, "marker"), std::bad_variant_access);
    EXPECT_THROW(vector(mixed, "mass_kg"), std::bad_variant_access);
    EXPECT_THROW(text(mixed, "markers"), std::bad_variant_access);
}

TEST(EffectParameterValues, NameTheTrialOnWhichTheyAct) {
    TrialContext context;
    context.trial = "drop";
    EXPECT_TRUE(acts_on(context, {}));
    EXPECT_TRUE(acts_on(context, {{"trial", std::string("drop")}}));
    EXPECT_FALSE(acts_on(context, {{"trial", std::string("drop 2")}}));
    EXPECT_FALSE(acts_on(context, {{"trial", std::string()}}));
}

TEST(FittedNames, AreThoseOfTheNumbersThatMove) {
    const auto names = [](const std::string& parameter, EffectParameterKind kind, double scale) {
        EffectParameterEntry entry;
        entry.name = parameter;
        entry.kind = kind;
        entry.scale = scale;
        return fitted_names({"some_effect", mixed}, entry);
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names("mass_kg", EffectParameterKind::number, 1.0), Names{"effect.some_effect.mass_kg"});
    EXPECT_EQ(names("shift_m", EffectParameterKind::vector3, 1.0),
              (Names{"effect.some_effect.shift_m.x", "effect.some_effect.shift_m.y", "effect.some_effect.shift_m.z"}));
    EXPECT_EQ(names("shift_m", EffectParameterKind::direction, 1.0),
              (Names{"effect.some_effect.shift_m.turn_1_rad", "effect.some_effect.shift_m.turn_2_rad"}));
    EXPECT_EQ(names("list", EffectParameterKind::number_or_list, 1.0),
              (Names{"effect.some_effect.list.trial_1", "effect.some_effect.list.trial_2",
                     "effect.some_effect.list.trial_3", "effect.some_effect.list.trial_4"}));
    EXPECT_TRUE(names("mass_kg", EffectParameterKind::number, 0.0).empty()) << "without a scale nothing is fitted";
    EXPECT_TRUE(names("absent", EffectParameterKind::number, 1.0).empty());
}

TEST(EffectDeclarations, AreEqualIfAllTheirValuesAre) {
    const EffectDeclaration one{"point_mass", mixed, true};
    EXPECT_EQ(one, one);
    EffectDeclaration other = one;
    other.law = std::make_shared<const Effect>();
    EXPECT_EQ(one, other) << "whatever the law";
    other = one;
    other.id = "cable_tug";
    EXPECT_FALSE(one == other);
    other = one;
    other.calibrate = false;
    EXPECT_FALSE(one == other);
    const std::vector<std::pair<std::string, EffectParameter>> further{
        {"mass_kg", 0.25000000001},
        {"mass_kg", std::string("0.25")},
        {"mass_kg", VectorXd(VectorXd::Constant(1, 0.25))},
        {"further", 1.0}};
    for (const auto& [name, value] : further) {
        other = one;
        other.parameters[name] = value;
        EXPECT_FALSE(one == other) << name;
        EXPECT_FALSE(other == one) << name;
    }
    for (const EffectParameter& value :
         std::vector<EffectParameter>{VectorXd(Vector3d(2.0, -3.0, 6.5)), VectorXd(Eigen::Vector2d(2.0, -3.0)),
                                      VectorXd(), 7.0, std::string("x"), std::vector<std::string>{"x"}}) {
        other = one;
        other.parameters["shift_m"] = value;
        EXPECT_FALSE(one == other);
        EXPECT_FALSE(other == one);
    }
    other = one;
    other.parameters.erase("list");
    EXPECT_FALSE(one == other);
    EXPECT_FALSE(other == one);
}

/// A law of an experiment, told by its id.
LawPointer law_of(const std::string& id, bool varies, bool corner) {
    auto law = std::make_shared<Effect>();
    law->id = id;
    law->varies_within_cells = varies;
    law->has_corner = corner;
    return law;
}

TEST(EffectCatalogueWithLaws, PrefersTheLawsOfTheExperiment) {
    const Laws laws{law_of("my_drag", false, false), law_of("point_mass", true, false)};
    EXPECT_EQ(find_effect("my_drag", laws), laws[0].get());
    EXPECT_EQ(find_effect("point_mass", laws), laws[1].get()) << "a law of that name stands before the catalogue";
    EXPECT_EQ(find_effect("cable_tug", laws), find_effect("cable_tug"));
    EXPECT_EQ(find_effect("nothing", laws), nullptr);
    EXPECT_EQ(find_law("my_drag", laws), laws[0]);
    EXPECT_EQ(find_law("cable_tug", laws), nullptr);
    EXPECT_EQ(find_effect(EffectDeclaration{"my_drag", {}}), nullptr) << "a declaration carries its law";
    EXPECT_EQ(find_effect(EffectDeclaration{"my_drag", {}, false, laws[0]}), laws[0].get());
    const std::vector<const Effect*> all = all_effects(laws);
    ASSERT_EQ(all.size(), effect_catalogue().size() + 2);
    EXPECT_EQ(all.front(), &effect_catalogue().front());
    EXPECT_EQ(all.back(), laws[1].get());
    const std::vector<std::string> ids = effect_ids(laws);
    EXPECT_EQ(ids[ids.size() - 2], "my_drag");
    EXPECT_EQ(effect_ids().size(), effect_catalogue().size());
}

TEST(EffectTraits, AreThoseOfAnyOfTheEffects) {
    const EffectDeclaration mass{"point_mass", {}}, friction{"dry_friction", {}}, patch{"soft_patch", {}},
        unknown{"nothing", {}}, law{"my_law", {}, false, law_of("my_law", true, true)};
    EXPECT_FALSE(any_has_corner({}));
    EXPECT_FALSE(any_has_corner({mass, patch, unknown}));
    EXPECT_TRUE(any_has_corner({mass, friction}));
    EXPECT_TRUE(any_has_corner({law}));
    EXPECT_FALSE(any_varies_within_cells({mass, friction, unknown}));
    EXPECT_TRUE(any_varies_within_cells({unknown, patch}));
    EXPECT_TRUE(any_varies_within_cells({law, mass}));
    std::set<std::string> kinds;
    for (const EffectKind kind :
         {EffectKind::force, EffectKind::support, EffectKind::material, EffectKind::actuation, EffectKind::measurement})
        kinds.insert(to_string(kind));
    EXPECT_EQ(kinds, (std::set<std::string>{"actuation", "force", "material", "measurement", "support"}));
}

/// Entries of all effects: names once, ranges that hold, and scales within them where something is fitted.
TEST(EffectCatalogueEntries, HaveParametersThatCanBeFitted) {
    for (const Effect& effect : effect_catalogue()) {
        std::set<std::string> names;
        for (const EffectParameterEntry& entry : effect.parameters) {
            const std::string what = effect.id + " " + entry.name;
            EXPECT_TRUE(names.insert(entry.name).second) << what;
            EXPECT_EQ(effect.parameter(entry.name), &entry) << what;
            EXPECT_LT(entry.lowest, entry.highest) << what;
            EXPECT_GE(entry.scale, 0.0) << what;
            if (entry.over_decades) {
                EXPECT_GT(entry.scale, 0.0) << what;
                EXPECT_GE(entry.lowest, 0.0) << what << ": positive, of unknown order";
                EXPECT_LT(entry.scale, entry.highest) << what;
            }
        }
        EXPECT_EQ(effect.parameter("nothing"), nullptr);
        if (!effect.resolved_length.empty()) {
            EXPECT_NE(effect.parameter(effect.resolved_length), nullptr) << effect.id;
        }
        EXPECT_EQ(effect.marker_event != MarkerEvent::none, effect.probes == nullptr)
            << effect.id << ": events of markers are sought by a scan";
    }
}

TEST(Probes, HaveOneColumnUnlessTheyAreJoined) {
    const EffectProbe single = probe({{"mass_kg", 0.1}}, "mass_kg");
    ASSERT_EQ(single.columns.size(), 1u);
    EXPECT_EQ(number(single.columns[0], "mass_kg"), 0.1);
    EXPECT_EQ(single.amount, "mass_kg");
    EXPECT_TRUE(single.joined == nullptr && !single.reciprocal && !single.large);
    const EffectParameterEntry entry = fitted_number("mass_kg", 0.5, 10.0, 2.0, true);
    EXPECT_TRUE(entry.name == "mass_kg" && entry.kind == EffectParameterKind::number && !entry.optional);
    EXPECT_TRUE(entry.lowest == 0.5 && entry.highest == 10.0 && entry.scale == 2.0 && entry.over_decades);
    EXPECT_FALSE(fitted_number("mass_kg", 0.5, 10.0, 2.0).over_decades);
    TrialContext context;
    context.marker_names = {"tip", "side", "tip"};
    EXPECT_EQ(marker_number(context, "tip"), 0) << "the first of this name";
    EXPECT_EQ(marker_number(context, "side"), 1);
    EXPECT_EQ(marker_number(context, "base"), -1);
}

}  // namespace
}  // namespace myo::effect::effect_parameters_tests
