#include "options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/solver_options.hpp"
#include "effect/catalogue.hpp"
#include "fem/element_block.hpp"
#include "material/catalogue.hpp"

namespace myo::app {
namespace {

/// Ends parsing with an error. CLI11 prints the option and the sentence.
[[noreturn]] void reject(const std::string& option, const std::string& sentence) {
    throw CLI::ValidationError(option, sentence);
}

/// Long option names of a command, for suggestions.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// A finite number; the entire word must be a number.
double number_of(const std::string& option, const std::string& text) {
    double value = 0.0;
    if (!parse_number(text, value) || !std::isfinite(value)) reject(option, "'" + text + "' is not a number");
    return value;
}

/// Whole number from `lowest` on; the entire word must be a number.
template <class Integer>
Integer integer_of(const std::string& option, const std::string& text, Integer lowest) {
    Integer value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || value < lowest)
        reject(option, "'" + text + "' is not a whole number from " + std::to_string(lowest) + " on");
    return value;
}

/// Option with one of the known words as its value.
///
/// @param parse  takes the word; returns false if it is unknown
template <class Parse, class Words>
void add_word(CLI::App& app, const std::string& name, const Parse& parse, const Words& known, const std::string& what) {
    app.add_option_function<std::string>(
           name,
           [name, parse, known](const std::string& id) {
               if (!parse(id)) reject(name, unknown_word(id, known));
           },
           what + ": " + join(known))
        ->type_name("NAME");
}

/// How the equations of motion are integrated.
void add_integration_options(CLI::App& app, SetupOptions& options) {
    setup::SetupSettings& settings = options.settings;
    add_word(
        app, "--integrator",
        [&settings](const std::string& id) { return dynamics::parse_integrator(id, settings.integrator); },
        dynamics::integrator_ids(), "time integration");
    app.add_option_function<std::string>(
           "--spectral-radius",
           [&options](const std::string& text) {
               const double value = number_of("--spectral-radius", text);
               if (value < 0.0 || value > 1.0)
                   reject("--spectral-radius", "'" + text + "' does not lie within 0 ... 1");
               // Kept apart from the settings, so that it can be refused with other integrators.
               options.spectral_radius = value;
           },
           "of " + to_string(dynamics::Integrator::generalized_alpha) +
               " at infinite frequency, 0 ... 1: less damps more (default: 0.5)")
        ->type_name("NUMBER");
    add_word(
        app, "--strategy",
        [&settings](const std::string& id) { return dynamics::parse_strategy(id, settings.strategy); },
        dynamics::strategy_ids(), "how a step is solved");
    add_positive_number(app, "--dt", settings.h_s,
                        "time step [s] (default: what the vibrations and the sampling of each trial ask for)")
        ->type_name("SECONDS");
}

/// Keys of experiment.toml that are replaced for this run.
void add_overrides(CLI::App& app, SetupOptions& options) {
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&options](const std::vector<std::string>& assignments) {
               for (const std::string& text : assignments) {
                   const std::size_t equals = text.find('=');
                   if (equals == std::string::npos || equals == 0)
                       reject("--set", "'" + text + "' is not of the form key=value");
                   options.overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
               }
           },
           "a key of experiment.toml for this run, as material.density_kg_m3=1100; may be repeated")
        ->type_name("KEY=VALUE")
        ->type_size(1)
        ->expected(-1);
}

}  // namespace

std::string unknown_word(const std::string& word, const std::vector<std::string>& known) {
    // The list of known words follows in any case, so that one message suffices.
    const std::string near = closest_word(word, known);
    // A question ends a sentence, so that the list begins a new one.
    return "'" + word + "' is not known" + (near.empty() ? "" : "; did you mean '" + near + "'?") +
           (near.empty() ? "; known: " : " Known: ") + join(known);
}

std::string surplus_arguments(const CLI::App& app) {
    const std::vector<std::string> rest = app.remaining();
    const auto option = std::find_if(rest.begin(), rest.end(),
                                     [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
    if (option == rest.end()) return "'" + rest.front() + "' is one argument too many";
    // "--dt=0.1" is the option --dt.
    const std::string name = option->substr(0, option->find('='));
    return "unknown option " + unknown_word(name, option_names(app));
}

std::vector<std::string> split_words(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == ',')
            words.emplace_back();
        else
            words.back() += c;
    }
    for (std::string& word : words) {
        const std::size_t first = word.find_first_not_of(" \t");
        word = first == std::string::npos ? "" : word.substr(first, word.find_last_not_of(" \t") - first + 1);
    }
    return words;
}

CLI::Option* add_positive_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help) {
    return app
        .add_option_function<std::string>(
            name,
            [name, &target](const std::string& text) {
                const double value = number_of(name, text);
                if (!(value > 0.0)) reject(name, "'" + text + "' is not positive");
                target = value;
            },
            help)
        ->type_name("NUMBER");
}

std::vector<std::string> effect_list(const std::string& option, const std::string& text) {
    std::vector<std::string> ids = split_words(text);
    for (const std::string& id : ids)
        if (!effect::find_effect(id)) reject(option, unknown_word(id, effect::effect_ids()));
    return ids;
}

CLI::Option* add_effect_list(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                             const std::string& help) {
    return app
        .add_option_function<std::string>(
            name, [name, &target](const std::string& text) { target = effect_list(name, text); }, help)
        ->type_name("A,B");
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& help) {
    return app
        .add_option_function<std::string>(
            name, [name, &target](const std::string& text) { target = number_of(name, text); }, help)
        ->type_name("NUMBER");
}

CLI::Option* add_optional_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                                 const std::string& help) {
    return app
        .add_option_function<std::string>(
            name, [name, &target](const std::string& text) { target = number_of(name, text); }, help)
        ->type_name("NUMBER");
}

CLI::Option* add_unit(CLI::App& app, std::optional<double>& metres_per_unit) {
    return app
        .add_option_function<std::string>(
            "--unit",
            [&metres_per_unit](const std::string& unit) {
                if (unit != "m" && unit != "mm") reject("--unit", unknown_word(unit, {"m", "mm"}));
                metres_per_unit = unit == "m" ? 1.0 : 1e-3;
            },
            "unit of the lengths in a mesh file: m, mm")
        ->type_name("UNIT");
}

CLI::Option* add_count(CLI::App& app, const std::string& name, int& target, const std::string& help) {
    return app
        .add_option_function<std::string>(
            name, [name, &target](const std::string& text) { target = integer_of<int>(name, text, 1); }, help)
        ->type_name("N");
}

CLI::Option* add_element(CLI::App& app, const std::string& name, std::optional<fem::ElementKind>& target) {
    return app
        .add_option_function<std::string>(
            name,
            [name, &target](const std::string& id) {
                fem::ElementKind kind{};
                if (!fem::parse_element(id, kind)) reject(name, unknown_word(id, fem::element_ids()));
                target = kind;
            },
            "element: " + join(fem::element_ids()))
        ->type_name("NAME");
}

CLI::Option* add_share(CLI::App& app, cases::Share& share) {
    return app
        .add_option_function<std::string>(
            "--share",
            [&share](const std::string& text) {
                const std::optional<cases::Share> parsed = cases::parse_share(text);
                if (!parsed) reject("--share", "'" + text + "' is not a share like 1/4, the first of four");
                share = *parsed;
            },
            "1/4: every fourth case, for four processes on one folder")
        ->type_name("I/N");
}

void add_console_options(CLI::App& app, WorkOptions& options) {
    app.add_flag("--quiet", options.quiet, "print errors only");
    app.add_flag("--json-progress", options.json_progress, "progress as one JSON line per event on standard error");
}

void add_work_options(CLI::App& app, WorkOptions& options) {
    add_count(app, "--threads", options.threads, "threads to work with (default: all)");
    app.add_option_function<std::string>(
           "--seed",
           [&options](const std::string& text) { options.seed = integer_of<std::uint64_t>("--seed", text, 0); },
           "seed of random starts (calibrate, optimize, reproduce beam-modulus), of --leave-out and of the cases of "
           "validate, recorded with the results")
        ->type_name("N");
    add_console_options(app, options);
}

void add_setup_options(CLI::App& app, SetupOptions& options) {
    setup::SetupSettings& settings = options.settings;
    // Declared first because CLI11 applies options in this order: later options may change what this one sets.
    app.add_flag_callback(
        "--as-published", [&settings] { settings = setup::published_settings(); },
        "the published formulation, for comparison: hex8_full, projective_corotational, equal vertex masses, truncated "
        "voxels, implicit_euler, no damping but "
        "the declared; other options change parts of it");
    add_element(app, "--element", settings.mesh.element);
    add_positive_number(app, "--resolution", settings.mesh.resolution_m, "edge length of the mesh [m]")
        ->type_name("METRES");
    add_word(
        app, "--voxels", [&settings](const std::string& id) { return setup::parse_voxels(id, settings.mesh.voxels); },
        setup::voxels_ids(), "how hexahedra fill the body");
    add_word(
        app, "--mass", [&settings](const std::string& id) { return model::parse_mass_model(id, settings.mass_model); },
        model::mass_model_ids(), "mass of the body");
    add_integration_options(app, options);
    add_word(
        app, "--material",
        [&settings](const std::string& id) {
            // Only the name is kept: parameters of the law come from the experiment.
            const bool known = material::find_material(id) != nullptr;
            if (known) settings.material = id;
            return known;
        },
        material::material_ids(), "material law");
    add_overrides(app, options);
    add_number(app, "--velocity-force", settings.velocity_force_1_s, "velocity force Lambda M v [1/s]");
}

setup::SetupSettings setup_settings(const SetupOptions& options, const WorkOptions& work) {
    setup::SetupSettings settings = options.settings;
    settings.threads = work.threads > 0 ? work.threads : hardware_threads();
    settings.spectral_radius = options.spectral_radius.value_or(settings.spectral_radius);
    return settings;
}

}  // namespace myo::app
