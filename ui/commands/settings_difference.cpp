#include "commands/settings_difference.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "effect/readable_quantity.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::commands {
namespace {

/// Shown for settings that do not have a value.
constexpr const char* none = "\xe2\x80\x93";

/// Label of a choice; the id itself if the list does not have it.
std::string label_of(const std::vector<Choice>& choices, const std::string& id) {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.id == id; });
    return found != choices.end() ? found->label : id;
}

/// Collects the rows of a table that has one column per settings object.
class Rows {
public:
    /// @param with_equal  whether settings that are equal everywhere get a row, too
    Rows(const std::vector<const Settings*>& of, bool with_equal) : of_(of), with_equal_(with_equal) {}

    /// Adds a row, unless it would not be of interest or no settings object has a value.
    ///
    /// @param words  the value of one settings object as text
    /// @param alike  whether two of them have equal values; texts may be equal although values differ
    void add(const std::string& name, const std::function<std::string(const Settings&)>& words,
             const std::function<bool(const Settings&, const Settings&)>& alike) {
        const auto same = [&](const Settings* s) { return alike(*of_.front(), *s); };
        if (!with_equal_ && std::all_of(of_.begin(), of_.end(), same)) return;
        SettingDifference row{name, {}};
        for (const Settings* s : of_) {
            std::string text = words(*s);
            // Values that differ must not look the same.
            for (std::size_t before = 0; before < row.values.size(); ++before)
                if (row.values[before] == text && !alike(*of_[before], *s)) text += " (other)";
            row.values.push_back(std::move(text));
        }
        // A setting that none of them has, such as a number of a law that none uses.
        if (std::all_of(row.values.begin(), row.values.end(), [](const std::string& v) { return v == none; })) return;
        rows_.push_back(std::move(row));
    }

    /// Adds a row for a number of the settings.
    ///
    /// @param unit  SI value of the shown unit, whose name is `unit_name`
    void add_number(const std::string& name, double Settings::*number, double unit, const std::string& unit_name) {
        const auto words = [=](const Settings& s) {
            return plot::plain_label(s.*number / unit, 6) + (unit_name.empty() ? "" : " " + unit_name);
        };
        add(name, words, [number](const Settings& a, const Settings& b) { return a.*number == b.*number; });
    }

    std::vector<SettingDifference> take() { return std::move(rows_); }

private:
    const std::vector<const Settings*>& of_;
    bool with_equal_;
    std::vector<SettingDifference> rows_;
};

/// All names in these lists, each once, in the order of their first appearance.
template <class Entry>
std::vector<std::string> names_of(const std::vector<const Settings*>& of, std::vector<Entry> Settings::*list,
                                  std::string Entry::*name) {
    std::vector<std::string> names;
    for (const Settings* s : of)
        for (const Entry& entry : s->*list)
            if (std::find(names.begin(), names.end(), entry.*name) == names.end()) names.push_back(entry.*name);
    return names;
}

/// The entry with a given name; null if the list does not have it.
template <class Entry>
const Entry* named(const std::vector<Entry>& list, std::string Entry::*name, const std::string& wanted) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const Entry& entry) { return entry.*name == wanted; });
    return found != list.end() ? &*found : nullptr;
}

/// Numbers of the laws; settings with another law show a dash.
void add_law_numbers(const std::vector<Choice>& materials, Rows& rows) {
    for (const Choice& law : materials)
        for (const ChoiceNumber& number : law.numbers) {
            const auto value = [&](const Settings& s) -> std::optional<double> {
                if (s.material != law.id) return std::nullopt;
                const auto set = s.law.find(number.key);
                return set != s.law.end() ? set->second : number.usual;
            };
            rows.add(
                number.label,
                [&](const Settings& s) {
                    const std::optional<double> v = value(s);
                    return v ? plot::plain_label(*v, 6) + (number.unit.empty() ? "" : " " + number.unit)
                             : std::string(none);
                },
                [&](const Settings& a, const Settings& b) { return value(a) == value(b); });
        }
}

/// Rows of the added effects, by name; settings without one show a dash.
void add_effects(const std::vector<const Settings*>& of, Rows& rows) {
    for (const std::string& name : names_of(of, &Settings::effects, &AddedEffect::name)) {
        const auto effect = [name](const Settings& s) { return named(s.effects, &AddedEffect::name, name); };
        rows.add(
            name,
            [=](const Settings& s) {
                return effect(s) ? effect(s)->value + (effect(s)->off ? " (off)" : "") : std::string(none);
            },
            // Equal if both have it with the same values, or neither has it.
            [=](const Settings& a, const Settings& b) {
                return (effect(a) && effect(b) && *effect(a) == *effect(b)) || (!effect(a) && !effect(b));
            });
    }
}

/// Declared effects that are switched off.
void add_switched_off(Rows& rows) {
    rows.add(
        "Effects switched off",
        [](const Settings& s) {
            std::string names;
            for (const SwitchedOff& each : s.off) names += (names.empty() ? "" : ", ") + effect::effect_name(each.id);
            return names.empty() ? std::string(none) : names;
        },
        [](const Settings& a, const Settings& b) { return a.off == b.off; });
}

/// A muscle's signal in short: its relation to a leader, or its range and number of knots.
std::string signal_text(const Muscle& muscle) {
    if (!muscle.follows.empty()) return plot::plain_label(muscle.ratio, 3) + " \xc3\x97 " + muscle.follows;
    if (!muscle.signal || muscle.signal->values.empty()) return "as recorded";
    const auto [least, most] = std::minmax_element(muscle.signal->values.begin(), muscle.signal->values.end());
    return "a " + plot::plain_label(*least, 3) + " to " + plot::plain_label(*most, 3) + ", " +
           std::to_string(muscle.signal->values.size()) + " knots";
}

/// Rows of the muscles, by name: place, stiffness and signal.
void add_muscles(const std::vector<const Settings*>& of, Rows& rows) {
    using Words = std::function<std::string(const Muscle&)>;
    using Alike = std::function<bool(const Muscle&, const Muscle&)>;
    // A muscle may exist in some settings only: those without it show a dash.
    for (const std::string& name : names_of(of, &Settings::muscles, &Muscle::name)) {
        const auto muscle = [name](const Settings& s) { return named(s.muscles, &Muscle::name, name); };
        const auto add = [&](const std::string& what, const Words& words, const Alike& alike) {
            rows.add(
                name + ", " + what,
                [=](const Settings& s) { return muscle(s) ? words(*muscle(s)) : std::string(none); },
                [=](const Settings& a, const Settings& b) {
                    return muscle(a) && muscle(b) ? alike(*muscle(a), *muscle(b)) : !muscle(a) && !muscle(b);
                });
        };
        add(
            "place",
            [](const Muscle& m) {
                return std::string(m.paint ? "painted" : m.declared.empty() ? "nowhere" : "as declared");
            },
            [](const Muscle& a, const Muscle& b) { return a.paint == b.paint && a.declared == b.declared; });
        add(
            "stiffness", [](const Muscle& m) { return plot::plain_label(1e-3 * m.stiffness_Pa, 6) + " kPa"; },
            [](const Muscle& a, const Muscle& b) { return a.stiffness_Pa == b.stiffness_Pa; });
        add(
            "sought",
            [](const Muscle& m) {
                // The declaration of a declared muscle says whether its signal is sought.
                return std::string(!m.declared.empty() ? "as declared" : m.sought ? "yes" : "no");
            },
            [](const Muscle& a, const Muscle& b) { return a.sought == b.sought; });
        add("signal", signal_text, [](const Muscle& a, const Muscle& b) {
            return a.follows == b.follows && (a.follows.empty() ? a.signal == b.signal : a.ratio == b.ratio);
        });
    }
}

/// Rows of all settings, in the order of the panels. `with_equal`: also those that are equal everywhere.
std::vector<SettingDifference> all_rows(const std::vector<const Settings*>& of, bool with_equal,
                                        const std::vector<Choice>& materials, const std::vector<Choice>& integrators) {
    Rows rows(of, with_equal);
    rows.add(
        "Elements", [](const Settings& s) { return to_string(s.element); },
        [](const Settings& a, const Settings& b) { return a.element == b.element; });
    rows.add_number("Edge length", &Settings::resolution_m, 1e-3, "mm");
    rows.add(
        "Material", [&](const Settings& s) { return label_of(materials, s.material); },
        [](const Settings& a, const Settings& b) { return a.material == b.material; });
    add_law_numbers(materials, rows);
    rows.add_number("Young's modulus E", &Settings::youngs_modulus_Pa, 1e3, "kPa");
    rows.add_number("Poisson's ratio \xce\xbd", &Settings::poissons_ratio, 1.0, "");
    rows.add_number("Density \xcf\x81", &Settings::density_kg_m3, 1.0, "kg/m\xc2\xb3");
    rows.add_number("Damping time \xcf\x84", &Settings::damping_s, 1e-3, "ms");
    rows.add(
        "Integrator", [&](const Settings& s) { return label_of(integrators, s.integrator); },
        [](const Settings& a, const Settings& b) { return a.integrator == b.integrator; });
    rows.add_number("Spectral radius \xcf\x81\xe2\x88\x9e", &Settings::spectral_radius, 1.0, "");
    rows.add_number("Time step h", &Settings::time_step_s, 1e-3, "ms");
    rows.add_number("Velocity force \xce\x9b", &Settings::velocity_force_1_s, 1.0, "1/s");
    add_effects(of, rows);
    add_switched_off(rows);
    add_muscles(of, rows);
    return rows.take();
}

}  // namespace

std::vector<SettingDifference> settings_differences(const std::vector<const Settings*>& of,
                                                    const std::vector<Choice>& materials,
                                                    const std::vector<Choice>& integrators) {
    if (of.size() < 2) return {};
    return all_rows(of, false, materials, integrators);
}

std::vector<SettingDifference> settings_rows(const Settings& settings, const std::vector<Choice>& materials,
                                             const std::vector<Choice>& integrators) {
    return all_rows({&settings}, true, materials, integrators);
}

}  // namespace myo::ui::commands
