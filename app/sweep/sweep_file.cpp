#include "sweep/sweep_file.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/text.hpp"
#include "toml/toml_reader.hpp"

namespace myo::sweep {
namespace {

using toml::TomlReader;
using toml::TomlValue;

const char* const current_schema = "sweep/1";

/// Commands by their words in the file.
const std::vector<std::pair<std::string, CaseCommand>>& command_words() {
    static const std::vector<std::pair<std::string, CaseCommand>> words{{"simulate", CaseCommand::simulate},
                                                                        {"calibrate", CaseCommand::calibrate},
                                                                        {"diagnose", CaseCommand::diagnose},
                                                                        {"optimize", CaseCommand::optimize}};
    return words;
}

/// Options that every case is given, or that make no sense in one.
bool set_by_the_sweep(const std::string& word) {
    static const std::vector<std::string> own{"--out",           "--threads", "--quiet", "--resume",
                                              "--json-progress", "--help",    "-h",      "--version"};
    return std::find(own.begin(), own.end(), word.substr(0, word.find('='))) != own.end();
}

/// A number that the file does not hold itself, at the place of the table that makes it.
TomlValue number_value(double number, const std::string& where) {
    TomlValue value;
    value.kind = TomlValue::Kind::number;
    value.number = number;
    value.where = where;
    return value;
}

/// Whether a file of an experiment, or a command line, can hold the value.
bool is_usable(const TomlValue& value, bool of_option) {
    switch (value.kind) {
        case TomlValue::Kind::number: return !std::isnan(value.number);
        case TomlValue::Kind::text:
        case TomlValue::Kind::boolean: return true;
        case TomlValue::Kind::array:
        case TomlValue::Kind::table:
            return !of_option && std::all_of(value.items.begin(), value.items.end(),
                                             [](const TomlValue& item) { return is_usable(item, false); });
        default: return false;
    }
}

// In this and the following functions a mistake throws toml::TomlFailure, which read_sweep() catches.
std::vector<TomlValue> listed_values(const TomlReader& reader, const TomlValue& table, bool of_option) {
    for (const char* other : {"from", "to", "count", "spacing"}) reader.reject(other, "does not go with values");
    const TomlValue& list = *table.find("values");
    if (list.kind != TomlValue::Kind::array)
        reader.fail("values", "must be an array, not " + toml::kind_name(list.kind));
    if (list.items.empty()) reader.fail("values", "holds no value");
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (!is_usable(list.items[i], of_option))
            reader.fail("values", "value " + std::to_string(i) +
                                      (of_option ? " is no number, text or boolean" : " cannot be a value of a key"));
    return list.items;
}

/// Values from `from` to `to`, equally spaced or by a constant factor, rounded to readable numbers.
std::vector<TomlValue> ranged_values(const TomlReader& reader, bool logarithmic, const SweepPolicy& policy) {
    const toml::NumberRange range = logarithmic ? toml::positive() : toml::any_number();
    const double from = reader.number("from", range), to = reader.number("to", range);
    const double count = reader.number("count", toml::between(1.0, static_cast<double>(policy.most_cases)));
    if (count != std::floor(count)) reader.fail("count", "must be a whole number");
    std::vector<TomlValue> values;
    for (double i = 0.0; i < count; ++i) {
        const double share = count > 1.0 ? i / (count - 1.0) : 0.0;
        const double between = logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
        double rounded = between;
        // Rounding errors of the spacing, as in 0.30000000000000004, would stand in files and names.
        parse_number(format_number(between, policy.value_digits), rounded);
        // The ends stay as they are written.
        values.push_back(number_value(i == 0.0 ? from : i == count - 1.0 ? to : rounded, reader.where()));
    }
    return values;
}

/// One table [[vary]].
///
/// @param before  what was read so far, with which this quantity may move together
Varied read_varied(const TomlReader& reader, const TomlValue& table, const Sweep& before, const SweepPolicy& policy) {
    if (reader.has("key") == reader.has("option"))
        reader.fail("key", "name either a key of the experiment or an option of the command");
    Varied varied;
    varied.where = reader.where();
    varied.name = reader.name(reader.has("key") ? "key" : "option");
    if (reader.has("option") && !varied.is_option()) reader.fail("option", "must begin with --");
    if (reader.has("key") && varied.is_option()) reader.fail("key", "must not begin with --; name it as option");
    // A quantity that is varied twice, or set by the sweep, would silently replace the other value.
    if (set_by_the_sweep(varied.name)) reader.fail("option", varied.name + " is set by the sweep itself");
    for (const Varied& other : before.varied)
        if (other.name == varied.name)
            reader.fail(varied.is_option() ? "option" : "key", varied.name + " is varied twice");
    if (reader.has("spacing")) varied.logarithmic = reader.choice<bool>("spacing", {{"linear", false}, {"log", true}});
    varied.values = reader.has("values") ? listed_values(reader, table, varied.is_option())
                                         : ranged_values(reader, varied.logarithmic, policy);
    varied.together = reader.boolean_or("together", false);
    if (!varied.together) return varied;
    if (before.varied.empty()) reader.fail("together", "there is no [[vary]] before it to move with");
    const std::size_t others = before.varied.back().values.size();
    if (others != varied.values.size())
        reader.fail("together", std::to_string(varied.values.size()) + " values cannot move with the " +
                                    std::to_string(others) + " of " + before.varied.back().name);
    return varied;
}

/// `seeds = 5` is 1 to 5, `seeds = [3, 7]` these.
Varied read_seeds(const TomlReader& reader, const TomlValue& seeds, const Sweep& sweep, const SweepPolicy& policy) {
    if (sweep.command == CaseCommand::simulate) reader.fail("seeds", "simulate has nothing random");
    Varied varied{.name = "--seed", .values = {}, .where = seeds.where};
    if (seeds.kind == TomlValue::Kind::array) {
        varied.values = seeds.items;
    } else {
        const double count = reader.number("seeds", toml::between(1.0, static_cast<double>(policy.most_cases)));
        if (count != std::floor(count)) reader.fail("seeds", "must be a whole number");
        for (double seed = 1.0; seed <= count; ++seed) varied.values.push_back(number_value(seed, seeds.where));
    }
    if (varied.values.empty()) reader.fail("seeds", "holds no value");
    for (const TomlValue& seed : varied.values)
        if (seed.kind != TomlValue::Kind::number || seed.number < 0.0 || seed.number != std::floor(seed.number))
            reader.fail("seeds", "must be whole numbers from 0 on");
    for (const Varied& other : sweep.varied)
        if (other.name == varied.name) reader.fail("seeds", "--seed is varied by [[vary]] as well");
    return varied;
}

/// The whole file. Seeds become the last axis, so that cases with equal values are neighbours.
Sweep read_document(const TomlValue& root, const std::filesystem::path& file, const SweepPolicy& policy) {
    const TomlReader reader(root, "", {"schema", "experiment", "command", "arguments", "seeds", "vary"});
    if (const std::string schema = reader.text("schema"); schema != current_schema)
        reader.fail("schema", "unknown schema \"" + schema + "\"; this program reads \"" + current_schema + "\"");
    Sweep sweep;
    sweep.file = file;
    const std::filesystem::path named = reader.name("experiment");
    // Relative to the sweep file, so that both can move together.
    sweep.experiment = named.is_absolute() ? named : (file.parent_path() / named).lexically_normal();
    std::error_code code;
    if (!std::filesystem::exists(sweep.experiment, code))
        reader.fail("experiment", sweep.experiment.string() + " is not there");
    sweep.command = reader.choice("command", command_words());
    if (reader.has("arguments")) sweep.arguments = reader.texts("arguments");
    for (const std::string& word : sweep.arguments)
        if (set_by_the_sweep(word)) reader.fail("arguments", word + " is set by the sweep itself");
    const std::vector<TomlReader> tables = reader.tables(
        "vary", {"key", "option", "values", "from", "to", "count", "spacing", "together"});
    for (std::size_t i = 0; i < tables.size(); ++i)
        sweep.varied.push_back(read_varied(tables[i], root.find("vary")->items[i], sweep, policy));
    if (reader.has("seeds")) sweep.varied.push_back(read_seeds(reader, *root.find("seeds"), sweep, policy));
    if (sweep.varied.empty()) reader.fail("vary", "is missing: a sweep varies something");
    // By factors, so that the product cannot overflow.
    double cases = 1.0;
    for (const std::size_t size : axis_sizes(sweep)) cases *= static_cast<double>(size);
    if (cases > static_cast<double>(policy.most_cases))
        reader.fail("vary", "the grid has " + format_number(cases, 4) + " cases; the limit is " +
                                std::to_string(policy.most_cases));
    return sweep;
}

}  // namespace

std::string to_string(CaseCommand command) {
    for (const auto& [word, meaning] : command_words())
        if (meaning == command) return word;
    return {};
}

Result<Sweep> read_sweep(const std::filesystem::path& file, const SweepPolicy& policy) {
    const Result<TomlValue> document = toml::read_toml(file);
    if (!document) return document.error();
    try {
        return read_document(*document, file, policy);
    } catch (const toml::TomlFailure& failure) {
        return failure.error;
    }
}

std::vector<std::size_t> axis_sizes(const Sweep& sweep) {
    std::vector<std::size_t> sizes;
    for (const Varied& varied : sweep.varied)
        if (!varied.together) sizes.push_back(varied.values.size());
    return sizes;
}

std::size_t case_count(const Sweep& sweep) {
    std::size_t count = 1;
    for (const std::size_t size : axis_sizes(sweep)) count *= size;
    return count;
}

}  // namespace myo::sweep
