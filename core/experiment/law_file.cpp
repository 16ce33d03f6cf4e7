#include "experiment/law_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/files.hpp"
#include "effect/catalogue.hpp"
#include "effect/law_effect.hpp"
#include "experiment/law_places.hpp"
#include "toml/toml_path.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {
namespace {

using effect::EffectParameterEntry;
using effect::EffectParameterKind;
using law::LawError;

const std::string law_file_schema = "law/1";

// Words of the key `acts_on`.
const std::vector<std::pair<std::string, law::Place>> law_place_words = {
    {"surface", law::Place::surface}, {"point", law::Place::point},   {"volume", law::Place::volume},
    {"clamp", law::Place::clamp},     {"signal", law::Place::signal}, {"camera", law::Place::camera}};

// Keys of a law wherever it acts; the keys of its result depend on the place.
const std::vector<std::string> head_keys = {"schema",     "id",  "sentence", "acts_on",  "amount",
                                            "conditions", "let", "state",    "parameter"};

/// The keys that every law may have, and those by which laws of this place state what they do.
std::vector<std::string> keys_of(law::Place place) {
    std::vector<std::string> keys = head_keys;
    for (const law::ResultKey& key : law::result_keys(place)) keys.push_back(key.key);
    return keys;
}

/// What the tables [[parameter]] say besides names and units.
struct DeclaredParameters {
    std::vector<law::LawText::Parameter> texts;                // name, shape and unit
    std::vector<EffectParameterEntry> entries;                 // kind, range and scale, in the same order
    std::vector<std::vector<effect::EffectParameter>> starts;  // one or more per parameter
    std::vector<bool> absent_at_infinity;                      // per parameter
};

/// Start values of a number: one, or several of which each is tried.
std::vector<effect::EffectParameter> read_starts(const toml::TomlReader& table, const EffectParameterEntry& entry,
                                                 std::size_t count) {
    std::vector<effect::EffectParameter> starts;
    if (table.is_array("start"))
        for (const double value : table.vector("start", static_cast<Eigen::Index>(count))) starts.emplace_back(value);
    else
        starts.emplace_back(table.number("start"));
    for (const effect::EffectParameter& start : starts)
        if (const double value = std::get<double>(start); !(value >= entry.lowest && value <= entry.highest))
            table.fail("start", "lies outside the range");
    return starts;
}

/// Bounds of a number, both finite; without the key a number is unbounded and a direction lies within -pi ... pi.
void read_range(const toml::TomlReader& table, EffectParameterEntry& entry) {
    if (!table.has("range")) return;
    const Eigen::VectorXd range = table.vector("range", 2);
    if (!(range(0) < range(1))) table.fail("range", "must be [lowest, highest]");
    entry.lowest = range(0);
    entry.highest = range(1);
}

/// Number of start values that a table [[parameter]] gives: that of an array, or one.
std::size_t starts_in(const toml::TomlValue& table) {
    const toml::TomlValue* const start = table.find("start");
    return start != nullptr && start->kind == toml::TomlValue::Kind::array ? start->items.size() : 1;
}

/// Reads one table [[parameter]] and appends its name, entry, start values and absent value to `declared`.
void read_law_parameter(const toml::TomlReader& table, const toml::TomlValue& value, law::Place place,
                        DeclaredParameters& declared) {
    using Kind = EffectParameterKind;
    law::LawText::Parameter text{table.name("name"), law::Shape::number, {}};
    EffectParameterEntry entry;
    entry.name = text.name;
    // In an [[effect]] the parameters of a law stand among the keys that every effect may have.
    for (const char* const taken : {"id", "calibrate", "position_m", "signal"})
        if (entry.name == taken) table.fail("name", "\"" + entry.name + "\" is a key that every effect may have");
    if (table.has("unit")) text.unit = table.text("unit");
    if (text.unit == "signal" && place != law::Place::signal)
        table.fail("unit", "only parameters of a law that acts on a signal have the unit of the signal");
    entry.of_signal = text.unit == "signal";
    if (table.has("kind"))
        entry.kind = table.choice<Kind>(
            "kind", {{"number", Kind::number}, {"vector", Kind::vector3}, {"direction", Kind::direction}});
    // Only numbers have several starts, an absent value and decades; vectors and directions are one start of 3
    // components.
    const bool is_number = entry.kind == Kind::number;
    if (!is_number) text.shape = law::Shape::vector;
    // A fit moves the two angles of a direction, so its range is that of an angle [rad].
    if (entry.kind == Kind::direction) entry.lowest = -std::numbers::pi, entry.highest = std::numbers::pi;
    read_range(table, entry);
    entry.scale = table.number_or("scale", 0.0, toml::not_negative());
    entry.over_decades = table.boolean_or("over_decades", false);
    // ln(1 + value / scale) is fitted over decades, which needs value >= 0 and scale > 0.
    if (entry.over_decades && (!is_number || !(entry.scale > 0.0) || entry.lowest < 0.0))
        table.fail("over_decades", "needs a number that is never negative, with a scale above 0");
    // Most laws do nothing at an amount of zero; the stiffness of a support that is otherwise rigid does nothing at
    // infinity.
    const double absent = table.number_or("absent", 0.0, toml::any_or_infinite());
    if (absent != 0.0 && !(std::isinf(absent) && absent > 0.0)) table.fail("absent", "must be 0 or inf");
    if (!is_number && table.has("absent")) table.fail("absent", "only numbers have it");
    if (is_number) {
        declared.starts.push_back(read_starts(table, entry, starts_in(value)));
    } else {
        Eigen::Vector3d start = table.vector3("start");
        if (entry.kind == Kind::direction) {
            if (!(start.norm() > 0.0)) table.fail("start", "has no direction: it is zero");
            start.normalize();
        }
        declared.starts.push_back({effect::EffectParameter(Eigen::VectorXd(start))});
    }
    if (declared.starts.back().empty()) table.fail("start", "holds no value");
    declared.absent_at_infinity.push_back(absent > 0.0);
    declared.entries.push_back(std::move(entry));
    declared.texts.push_back(std::move(text));
}

/// Every start of every parameter, with the first of the others.
std::vector<effect::EffectParameters> all_starts(const DeclaredParameters& declared) {
    effect::EffectParameters first;
    for (std::size_t p = 0; p < declared.entries.size(); ++p)
        first[declared.entries[p].name] = declared.starts[p].front();
    std::vector<effect::EffectParameters> starts{first};
    for (std::size_t p = 0; p < declared.entries.size(); ++p)
        for (std::size_t s = 1; s < declared.starts[p].size(); ++s) {
            starts.push_back(first);
            starts.back()[declared.entries[p].name] = declared.starts[p][s];
        }
    return starts;
}

/// The number that a search multiplies: the named one, or the first that fits move.
std::string amount_of(const toml::TomlReader& document, const DeclaredParameters& declared) {
    std::vector<std::string> numbers;
    for (const EffectParameterEntry& entry : declared.entries)
        if (entry.kind == EffectParameterKind::number && entry.scale > 0.0) numbers.push_back(entry.name);
    // Without the key the amount is the first number that fits move.
    if (!document.has("amount")) return numbers.empty() ? "" : numbers.front();
    const std::string name = document.text("amount");
    if (std::find(numbers.begin(), numbers.end(), name) == numbers.end())
        document.fail("amount", "names no number of this law with a scale; " + toml::suggest(name, numbers));
    return name;
}

/// Reads the document of a law file. Its members throw toml::TomlFailure at the first error.
class LawReader {
public:
    LawReader(const toml::TomlValue& root, const std::string& source) : root_(root), source_(source) {}

    effect::LawPointer read() const {
        // The known keys depend on the place where the law acts, so `acts_on` is read before keys are checked.
        const toml::TomlReader open(root_, "", root_.keys);
        if (!open.has_entry("schema") || open.text("schema") != law_file_schema)
            open.fail("schema", "must be \"" + law_file_schema + "\"");
        if (!open.has_entry("acts_on")) open.fail("acts_on", "required key is missing");
        const law::Place place = open.choice<law::Place>("acts_on", law_place_words);
        const toml::TomlReader document(root_, "", keys_of(place));
        effect::LawStatement statement;
        statement.id = read_id(document);
        statement.sentence = document.name("sentence");
        const std::vector<std::string> keys = {"name",  "unit",         "kind",  "range",
                                               "scale", "over_decades", "start", "absent"};
        DeclaredParameters declared;
        const std::vector<toml::TomlReader> tables = document.tables("parameter", keys);
        for (std::size_t p = 0; p < tables.size(); ++p)
            read_law_parameter(tables[p], root_.find("parameter")->items[p], place, declared);
        statement.starts = all_starts(declared);
        statement.amount = amount_of(document, declared);
        // A search multiplies the amount, and a multiple of zero remains zero.
        if (!statement.amount.empty() && std::get<double>(statement.starts.front().at(statement.amount)) == 0.0)
            document.fail("parameter", "\"" + statement.amount + "\" starts at 0, where the law does nothing");
        for (std::size_t p = 0; p < declared.entries.size(); ++p)
            if (declared.entries[p].name == statement.amount && declared.absent_at_infinity[p]) {
                statement.absent_at_infinity = true;
                if (!(declared.entries[p].lowest > 0.0))
                    tables[p].fail("range", "a number whose law is absent at infinity needs a lowest value above 0");
            }
        // Last: errors in expressions are easier to understand once names, units and ranges are known to be right.
        statement.law = made(law_text(document, place, declared.texts), document);
        statement.parameters = std::move(declared.entries);
        return std::make_shared<const effect::Effect>(effect::law_effect(std::move(statement)));
    }

private:
    /// Results name effects by id, so a law must not take that of an effect of the catalogue or of a verdict.
    static std::string read_id(const toml::TomlReader& document) {
        const std::string id = document.name("id");
        if (id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
            document.fail("id", "must be of small letters, digits and underscores, not \"" + id + "\"");
        if (effect::find_effect(id) != nullptr || id == "none" || id == "unknown")
            document.fail("id", "\"" + id + "\" is an effect of the catalogue, or a verdict; choose another name");
        return id;
    }

    /// Optional list of texts; empty if the key is absent.
    static std::vector<std::string> texts_or_none(const toml::TomlReader& document, const char* key) {
        return document.has(key) ? document.texts(key) : std::vector<std::string>();
    }

    /// The expressions as they are written, not yet parsed.
    static law::LawText law_text(const toml::TomlReader& document, law::Place place,
                                 const std::vector<law::LawText::Parameter>& parameters) {
        law::LawText text;
        text.place = place;
        text.parameters = parameters;
        text.conditions = texts_or_none(document, "conditions");
        text.definitions = texts_or_none(document, "let");
        for (const toml::TomlReader& table : document.tables("state", {"name", "unit", "initial", "rate"})) {
            if (place != law::Place::signal)
                document.fail("state", "only laws that act on a signal have states so far");
            text.states.push_back({table.name("name"), table.text_or("initial", "0"), table.text("rate"), {}});
            if (table.has("unit")) text.states.back().unit = table.text("unit");
        }
        std::vector<std::string> names;
        // A place has one or several keys by which a law may state its result; exactly one of them must be given.
        for (const law::ResultKey& key : law::result_keys(place)) {
            names.push_back(key.key);
            if (!document.has(key.key)) continue;
            if (!text.result.empty()) document.fail(key.key, "a law has one such expression, and this is the second");
            text.key = key;
            text.result = document.text(key.key);
            if (text.result.empty()) document.fail(key.key, "must not be empty");
        }
        if (text.result.empty())
            document.fail(names.front(), names.size() > 1 ? "is missing; so is " + names.back() +
                                                                ", one of which says "
                                                                "what the law does"
                                                          : "required key is missing");
        return text;
    }

    /// Parses the expressions; an error is thrown with file, line and column.
    law::Law made(const law::LawText& text, const toml::TomlReader& document) const {
        std::variant<law::Law, LawError> result = law::make_law(text);
        if (const auto* const error = std::get_if<LawError>(&result)) throw toml::TomlFailure{located(*error, text)};
        (void)document;
        return std::get<law::Law>(std::move(result));
    }

    /// The error with the place of the text in which it is.
    Error located(const LawError& error, const law::LawText& text) const {
        using Part = LawError::Part;
        // The parser knows the column within an expression; the TOML value knows the line of the file.
        const auto in_list = [&](const char* key) {
            return error_in_expression(root_.find(key)->items[error.index], toml::element_text(key, error.index),
                                       source_, error.error);
        };
        const auto in_table = [&](const char* table, const char* key) {
            const toml::TomlValue& of = root_.find(table)->items[error.index];
            const toml::TomlValue* const value = of.find(key);
            return error_in_expression(value != nullptr ? *value : of,
                                       toml::element_text(table, error.index) + "." + key, source_, error.error);
        };
        switch (error.part) {
            case Part::parameter: {
                // The parser reports both for a parameter: a name that is no identifier, or a unit that it cannot read.
                const bool of_unit = text.parameters[error.index].unit &&
                                     error.error.sentence.find("unit") != std::string::npos;
                return in_table("parameter", of_unit ? "unit" : "name");
            }
            case Part::condition: return in_list("conditions");
            case Part::definition: return in_list("let");
            case Part::state: return in_table("state", "name");
            case Part::state_initial: return in_table("state", "initial");
            case Part::state_rate: return in_table("state", "rate");
            case Part::result: break;
        }
        return error_in_expression(*root_.find(text.key.key), text.key.key, source_, error.error);
    }

    const toml::TomlValue& root_;
    const std::string& source_;
};

}  // namespace

Result<effect::LawPointer> read_law_text(const std::string& text, const std::string& name) {
    const Result<toml::TomlValue> root = toml::parse_toml(text, name);
    if (!root) return root.error();
    try {
        return LawReader(*root, text).read();
    } catch (const toml::TomlFailure& failure) {
        return failure.error;
    }
}

Result<effect::LawPointer> read_law_file(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return read_law_text(*text, path.string());
}

}  // namespace myo::experiment
