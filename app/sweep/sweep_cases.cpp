#include "sweep/sweep_cases.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <system_error>

#include "base/files.hpp"
#include "base/fingerprint.hpp"
#include "experiment/read_experiment.hpp"
#include "results/output_files.hpp"
#include "toml/toml_edit.hpp"
#include "toml/toml_key.hpp"
#include "toml/toml_text.hpp"

namespace myo::sweep {
namespace {

namespace fs = std::filesystem;

/// The declaration as it is written, and where the varied keys stand in it.
struct Declared {
    fs::path file;
    std::string text;
    std::vector<toml::TomlPath> paths;  // one per varied quantity; empty for options
};

/// Error at a varied quantity of the sweep file, without the place of the experiment.
Error error_of(const Varied& varied, const std::string& sentence) {
    return {varied.name + ": " + sentence, varied.where};
}

/// Reads the declaration and finds the varied keys.
///
/// Errors: the file cannot be read or is no TOML; a key that no path leads to, at its place in the sweep file.
Result<Declared> read_declared(const Sweep& sweep) {
    std::error_code code;
    Declared declared;
    declared.file = fs::is_directory(sweep.experiment, code) ? sweep.experiment / "experiment.toml" : sweep.experiment;
    Result<std::string> text = read_file(declared.file);
    if (!text) return text.error();
    declared.text = *std::move(text);
    const Result<toml::TomlValue> document = toml::parse_toml(declared.text, declared.file.string());
    if (!document) return document.error();
    for (const Varied& varied : sweep.varied) {
        declared.paths.emplace_back();
        if (varied.is_option()) continue;
        Result<toml::TomlPath> path = toml::path_of_key(*document, varied.name);
        if (!path) return error_of(varied, path.error().what);
        declared.paths.back() = *std::move(path);
    }
    return declared;
}

/// Index of every varied quantity in a case: a number with one digit per axis, the last of which changes fastest.
std::vector<std::size_t> choice_of(const Sweep& sweep, std::size_t rank) {
    const std::vector<std::size_t> sizes = axis_sizes(sweep);
    std::vector<std::size_t> digits(sizes.size());
    for (std::size_t axis = sizes.size(); axis-- > 0; rank /= sizes[axis]) digits[axis] = rank % sizes[axis];
    std::vector<std::size_t> choice;
    std::size_t axis = 0;
    for (const Varied& varied : sweep.varied) {
        if (!varied.together) ++axis;
        choice.push_back(digits[axis - 1]);
    }
    return choice;
}

/// Sets the values of a case in the text of the declaration.
Result<std::string> text_of(const Sweep& sweep, const Declared& declared, const SweepCase& c) {
    std::string text = declared.text;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k) {
        const Varied& varied = sweep.varied[k];
        if (varied.is_option()) continue;
        Result<std::string> edited = toml::with_value(text, declared.paths[k],
                                                      toml::toml_value_text(varied.values[c.choice[k]]));
        if (!edited) return error_of(varied, edited.error().what);
        text = *std::move(edited);
    }
    return text;
}

/// A flag is given or not; other options are followed by their value.
std::vector<std::string> options_of(const Sweep& sweep, const SweepCase& c) {
    std::vector<std::string> words = sweep.arguments;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k) {
        const Varied& varied = sweep.varied[k];
        if (!varied.is_option()) continue;
        const toml::TomlValue& value = varied.values[c.choice[k]];
        const bool flag = value.kind == toml::TomlValue::Kind::boolean;
        if (!flag || value.truth) words.push_back(varied.name);
        if (!flag) words.push_back(value_words(varied, c.choice[k]));
    }
    return words;
}

/// The reader's sentence at the varied key that it begins with, or else at the first one.
Error refused_case(const Sweep& sweep, const Declared& declared, const SweepCase& c, const Error& error) {
    std::size_t blamed = 0;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k)
        if (!declared.paths[k].empty() && error.what.starts_with(toml::path_text(declared.paths[k]))) blamed = k;
    return {"case " + std::to_string(c.number) + " (" + case_words(sweep, c) + "): " + error.what,
            sweep.varied[blamed].where};
}

/// Contents of files, each read once.
class FileContents {
public:
    Result<std::uint64_t> hash_of(const fs::path& file) {
        if (const auto known = hashes_.find(file); known != hashes_.end()) return known->second;
        const Result<std::string> content = read_file(file);
        if (!content) return content.error();
        Fingerprint fingerprint;
        fingerprint.add_text(*content);
        return hashes_[file] = fingerprint.value();
    }

private:
    std::map<fs::path, std::uint64_t> hashes_;
};

/// Hash of everything that decides the result of a case.
///
/// @param files  all that the experiment reads, its declaration among them
Result<std::uint64_t> fingerprint_of(const Sweep& sweep, const SweepCase& c, const std::vector<fs::path>& files,
                                     const fs::path& declaration, const std::string& version, FileContents& contents) {
    Fingerprint fingerprint;
    fingerprint.add_text(version);
    fingerprint.add_text(to_string(sweep.command));
    for (const std::string& word : c.options) fingerprint.add_text(word);
    fingerprint.add_text(c.text);
    for (const fs::path& file : files) {
        if (file == declaration) continue;  // its text with the values of the case is counted above
        const Result<std::uint64_t> hash = contents.hash_of(file);
        if (!hash) return hash.error();
        fingerprint.add_text(std::to_string(*hash));
    }
    return fingerprint.value();
}

}  // namespace

Result<PreparedSweep> prepare_sweep(const Sweep& sweep, const CheckArguments& check, const std::string& version) {
    const Result<Declared> declared = read_declared(sweep);
    if (!declared) return declared.error();
    PreparedSweep prepared{.sweep = sweep, .home = declared->file.parent_path()};
    FileContents contents;
    const std::size_t count = case_count(sweep);
    for (std::size_t rank = 0; rank < count; ++rank) {
        SweepCase c{.number = static_cast<int>(rank) + 1, .choice = choice_of(sweep, rank)};
        Result<std::string> text = text_of(sweep, *declared, c);
        if (!text) return text.error();
        // Every case is read as its command will read it, so that no case fails by its declaration.
        c.text = *std::move(text);
        c.options = options_of(sweep, c);
        const Result<experiment::Experiment> experiment = experiment::read_experiment_text(c.text, declared->file);
        if (!experiment) {
            // An experiment that is wrong as it stands is reported as such, with its own line.
            const auto as_declared = experiment::read_experiment_text(declared->text, declared->file);
            return as_declared ? refused_case(sweep, *declared, c, experiment.error()) : as_declared.error();
        }
        prepared.experiment_name = experiment->name;
        // Neighbouring cases mostly have equal options, which need not be parsed again.
        const bool new_options = prepared.cases.empty() || prepared.cases.back().options != c.options;
        if (const Result<void> taken = new_options ? check(to_string(sweep.command), c.options) : Result<void>();
            !taken)
            return refused_case(sweep, *declared, c, taken.error());
        const Result<std::uint64_t> fingerprint = fingerprint_of(
            sweep, c, results::files_read(declared->file, *experiment), declared->file, version, contents);
        if (!fingerprint) return fingerprint.error();
        c.fingerprint = *fingerprint;
        prepared.cases.push_back(std::move(c));
    }
    return prepared;
}

std::string value_words(const Varied& varied, std::size_t index) {
    const toml::TomlValue& value = varied.values[index];
    if (value.kind == toml::TomlValue::Kind::text) return value.text;
    if (value.kind != toml::TomlValue::Kind::number) return toml::toml_value_text(value);
    // Unlike in TOML, a whole number has neither decimal point nor exponent: options that count would refuse it.
    const bool whole = value.number == std::floor(value.number) && std::abs(value.number) < 1e15;
    char text[40];
    const auto [end, code] = whole ? std::to_chars(text, text + sizeof text, value.number, std::chars_format::fixed)
                                   : std::to_chars(text, text + sizeof text, value.number);
    return {text, end};
}

std::string case_words(const Sweep& sweep, const SweepCase& sweep_case) {
    std::string words;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k)
        words += (k > 0 ? ", " : "") + sweep.varied[k].name + " = " +
                 value_words(sweep.varied[k], sweep_case.choice[k]);
    return words;
}

}  // namespace myo::sweep
