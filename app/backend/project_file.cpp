#include "backend/project_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <system_error>

#include "backend/experiment_contents.hpp"
#include "backend/painted_parts.hpp"
#include "backend/project_masks.hpp"
#include "base/files.hpp"
#include "commands/settings.hpp"
#include "experiment/effect_toml.hpp"
#include "fibre/painted_mask.hpp"
#include "material/catalogue.hpp"
#include "mesh/cell_traits.hpp"
#include "toml/toml_reader.hpp"
#include "toml/toml_text.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

const std::string schema = "myoloop-project/1";

/// A boolean view option and its key.
struct ViewSwitch {
    const char* key;
    bool ui::commands::ViewOptions::*value;
};
constexpr ViewSwitch view_switches[] = {{"edges", &ui::commands::ViewOptions::edges},
                                        {"grid", &ui::commands::ViewOptions::grid},
                                        {"measured", &ui::commands::ViewOptions::measured},
                                        {"simulated", &ui::commands::ViewOptions::simulated},
                                        {"trails", &ui::commands::ViewOptions::trails},
                                        {"errors", &ui::commands::ViewOptions::errors},
                                        {"labels", &ui::commands::ViewOptions::labels},
                                        {"clamp", &ui::commands::ViewOptions::clamp},
                                        {"loads", &ui::commands::ViewOptions::loads},
                                        {"obstacles", &ui::commands::ViewOptions::obstacles},
                                        {"actuators", &ui::commands::ViewOptions::actuators},
                                        {"fibres", &ui::commands::ViewOptions::fibres},
                                        {"effect_force", &ui::commands::ViewOptions::effect_force},
                                        {"undeformed", &ui::commands::ViewOptions::undeformed},
                                        {"side_by_side", &ui::commands::ViewOptions::side_by_side}};

/// Relative path if it is at most three levels up, else the absolute one.
std::string seen_from(const fs::path& path, const fs::path& folder) {
    std::error_code ignored;
    const fs::path near = fs::weakly_canonical(path, ignored).lexically_relative(fs::weakly_canonical(folder, ignored));
    const auto ups = std::count(near.begin(), near.end(), "..");
    return near.empty() || ups > 3 ? path.generic_string() : near.generic_string();
}

/// Parameters of laws, the chosen one's and those kept of others, one line each.
std::string law_text(const ui::commands::Settings& s) {
    std::string text;
    for (const auto& [key, value] : s.law) text += key + " = " + toml::toml_number(value) + "\n";
    return text;
}

/// Mesh, material, time and effects as TOML.
std::string settings_text(const ui::commands::Settings& s) {
    std::string text = "\n[mesh]\nelement = " + toml::toml_text(to_string(s.element)) +
                       "\nresolution_m = " + toml::toml_number(s.resolution_m) + "\n";
    text += "\n[material]\nmodel = " + toml::toml_text(s.material) + "\n" + law_text(s) +
            "youngs_modulus_Pa = " + toml::toml_number(s.youngs_modulus_Pa) +
            "\npoissons_ratio = " + toml::toml_number(s.poissons_ratio) +
            "\ndensity_kg_m3 = " + toml::toml_number(s.density_kg_m3) +
            "\ndamping_s = " + toml::toml_number(s.damping_s) + "\n";
    text += "\n[time]\nintegrator = " + toml::toml_text(s.integrator) +
            "\nstep_s = " + toml::toml_number(s.time_step_s) + "\nown_step = " + (s.own_step ? "true" : "false") +
            "\nspectral_radius = " + toml::toml_number(s.spectral_radius) +
            "\nvelocity_force_1_s = " + toml::toml_number(s.velocity_force_1_s) + "\n";
    for (const ui::commands::AddedEffect& effect : s.effects) {
        text += "\n[[effect]]\nid = " + toml::toml_text(effect.declaration.id) +
                "\nname = " + toml::toml_text(effect.name) + "\nvalue = " + toml::toml_text(effect.value) + "\n";
        if (effect.off) text += "off = true\n";
        if (!effect.declaration.calibrate) text += "calibrate = false\n";
        text += "[effect.parameters]\n";
        for (const auto& [name, value] : effect.declaration.parameters)
            text += toml::toml_text(name) + " = " + experiment::effect_toml(value) + "\n";
    }
    for (const ui::commands::SwitchedOff& effect : s.off)
        text += "\n[[effect_off]]\nindex = " + std::to_string(effect.index) + "\nid = " + toml::toml_text(effect.id) +
                "\n";
    return text;
}

/// A muscle as TOML.
/// @param mask  path of its mask file relative to the project; empty: no paint
std::string muscle_text(const ui::commands::Muscle& m, const std::string& mask) {
    std::string text = "\n[[muscle]]\nname = " + toml::toml_text(m.name) + "\n";
    if (!m.declared.empty()) text += "declared = " + toml::toml_text(m.declared) + "\n";
    text += "color = " + std::to_string(m.color) + "\nstiffness_Pa = " + toml::toml_number(m.stiffness_Pa) +
            "\nextends = " + (m.extends ? "true" : "false") + "\n";
    if (!m.follows.empty())
        text += "follows = { muscle = " + toml::toml_text(m.follows) + ", ratio = " + toml::toml_number(m.ratio) +
                " }\n";
    if (!m.sought) text += "sought = false\n";
    if (!mask.empty()) text += "mask = " + toml::toml_text(mask) + "\n";
    if (m.signal)
        text += "signal = { time_s = " + toml::toml_list(m.signal->times_s, toml::toml_number) +
                ", a = " + toml::toml_list(m.signal->values, toml::toml_number) + " }\n";
    return text;
}

/// View options as TOML; field ranges are in SI.
std::string view_text(const ui::commands::ViewOptions& view) {
    std::string text = "\n[view]\n";
    for (const ViewSwitch& each : view_switches)
        text += std::string(each.key) + " = " + (view.*each.value ? "true" : "false") + "\n";
    text += "opacity = " + toml::toml_number(view.opacity) + "\n";
    if (!view.color_map.empty()) text += "color_map = " + toml::toml_text(view.color_map) + "\n";
    if (!view.field.empty()) text += "field = " + toml::toml_text(view.field) + "\n";
    if (view.clip.on)
        text += "cut = { normal = " + toml::toml_vector(view.clip.normal) +
                ", position_m = " + toml::toml_number(view.clip.position_m) +
                ", flip = " + (view.clip.flip ? "true" : "false") + " }\n";
    if (view.field_ranges.empty()) return text;
    text += "[view.field_ranges]\n";  // SI
    for (const auto& [field, range] : view.field_ranges)
        text += toml::toml_text(field) + " = " + toml::toml_list(range, toml::toml_number) + "\n";
    return text;
}

/// Array of finite numbers; a failure names the key.
/// @param holder  the same table as parsed, since the reader returns no arrays of free length
std::vector<double> numbers_of(const toml::TomlReader& table, const std::string& key, const toml::TomlValue& holder) {
    const toml::TomlValue* const array = holder.find(key);
    if (array == nullptr || array->kind != toml::TomlValue::Kind::array) table.fail(key, "must be an array of numbers");
    std::vector<double> numbers;
    for (const toml::TomlValue& item : array->items) {
        if (item.kind != toml::TomlValue::Kind::number || !std::isfinite(item.number))
            table.fail(key, "must hold finite numbers only");
        numbers.push_back(item.number);
    }
    return numbers;
}

Eigen::VectorXd as_vector(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

/// Inline signal: as many values as times, ascending.
fibre::Signal read_signal(const toml::TomlReader& muscle, const toml::TomlValue& value) {
    const toml::TomlReader table = muscle.table("signal", {"time_s", "a"});
    const fibre::Signal signal{numbers_of(table, "time_s", value), numbers_of(table, "a", value)};
    if (signal.times_s.empty() || signal.times_s.size() != signal.values.size())
        table.fail("a", "must hold one value for each of time_s");
    if (!std::is_sorted(signal.times_s.begin(), signal.times_s.end())) table.fail("time_s", "must ascend");
    return signal;
}

/// @param warnings  receives missing masks: their paint is lost, the rest of the project is read
std::vector<ui::commands::Muscle> read_project_muscles(const toml::TomlReader& document, const toml::TomlValue& root,
                                                       const fs::path& folder, std::vector<std::string>& warnings) {
    std::vector<ui::commands::Muscle> muscles;
    const toml::TomlValue* const entries = root.find("muscle");
    for (const toml::TomlReader& table : document.tables(
             "muscle",
             {"name", "declared", "color", "stiffness_Pa", "extends", "follows", "mask", "signal", "sought"})) {
        ui::commands::Muscle muscle;
        muscle.name = table.name("name");
        if (std::any_of(muscles.begin(), muscles.end(),
                        [&](const ui::commands::Muscle& other) { return other.name == muscle.name; }))
            table.fail("name", "is that of another muscle, too");
        muscle.declared = table.text_or("declared", "");
        muscle.color = static_cast<int>(table.number_or("color", 0.0, toml::between(0.0, 1000.0)));
        muscle.stiffness_Pa = table.number(
            "stiffness_Pa",
            toml::between(ui::commands::muscle_stiffness_limits.lowest, ui::commands::muscle_stiffness_limits.highest));
        muscle.extends = table.boolean_or("extends", false);
        muscle.sought = table.boolean_or("sought", true);
        if (table.has("follows")) {
            const toml::TomlReader follows = table.table("follows", {"muscle", "ratio"});
            muscle.follows = follows.text("muscle");
            muscle.ratio = follows.number("ratio", toml::between(ui::commands::muscle_ratio_limits.lowest,
                                                                 ui::commands::muscle_ratio_limits.highest));
        }
        std::error_code ignored;
        if (table.has("mask") && !fs::exists(folder / table.text("mask"), ignored)) {
            warnings.push_back("The paint of muscle \"" + muscle.name + "\" is lost: its mask " + table.text("mask") +
                               " is not there.");
        } else if (table.has("mask")) {
            const Result<fibre::PaintedMask> mask = fibre::read_painted_mask(table.file("mask", folder));
            if (!mask) table.fail("mask", mask.error().text());
            muscle.paint = std::make_shared<const fibre::PaintedMask>(*mask);
        }
        if (table.has("signal")) muscle.signal = read_signal(table, *entries->items[muscles.size()].find("signal"));
        muscles.push_back(std::move(muscle));
    }
    for (const ui::commands::Muscle& muscle : muscles) {
        if (muscle.follows.empty()) continue;
        // One level only: a follower of a follower is rejected.
        const auto leads = [&](const ui::commands::Muscle& other) {
            return other.name == muscle.follows && other.follows.empty();
        };
        if (std::none_of(muscles.begin(), muscles.end(), leads))
            document.fail("muscle",
                          "\"" + muscle.name + "\" follows \"" + muscle.follows + "\", which has no signal of its own");
    }
    return muscles;
}

/// Effects added in the window. Their parameter names are not checked here.
std::vector<ui::commands::AddedEffect> read_project_effects(const toml::TomlReader& document,
                                                            const toml::TomlValue& root) {
    std::vector<ui::commands::AddedEffect> effects;
    const toml::TomlValue* const entries = root.find("effect");
    for (const toml::TomlReader& table :
         document.tables("effect", {"id", "name", "value", "off", "calibrate", "parameters"})) {
        ui::commands::AddedEffect effect{{table.text("id"), {}, table.boolean_or("calibrate", true)},
                                         table.text("name"),
                                         table.text("value"),
                                         table.boolean_or("off", false)};
        const toml::TomlReader named = table.table_of_names("parameters");
        const toml::TomlValue& parameters = *entries->items[effects.size()].find("parameters");
        for (std::size_t k = 0; k < parameters.keys.size(); ++k) {
            const toml::TomlValue& value = parameters.items[k];
            effect::EffectParameter& slot = effect.declaration.parameters[parameters.keys[k]];
            const bool words = value.kind == toml::TomlValue::Kind::array && !value.items.empty() &&
                               value.items.front().kind == toml::TomlValue::Kind::text;
            if (value.kind == toml::TomlValue::Kind::number)
                slot = value.number;
            else if (value.kind == toml::TomlValue::Kind::text)
                slot = value.text;
            else if (words)
                slot = named.texts(parameters.keys[k]);
            else
                slot = as_vector(numbers_of(named, parameters.keys[k], parameters));
        }
        effects.push_back(std::move(effect));
    }
    return effects;
}

/// Settings; values outside the limits of the window's fields are rejected.
ui::commands::Settings read_settings(const toml::TomlReader& document, const toml::TomlValue& root,
                                     const fs::path& folder, std::vector<std::string>& warnings) {
    const auto within = [](const ui::commands::Limits& limits) { return toml::between(limits.lowest, limits.highest); };
    ui::commands::Settings s;
    const toml::TomlReader mesh = document.table("mesh", {"element", "resolution_m"});
    s.element = mesh.choice<mesh::CellType>("element", mesh::named_cell_types());
    s.resolution_m = mesh.number("resolution_m", toml::positive());
    std::vector<std::string> material_keys{"model", "youngs_modulus_Pa", "poissons_ratio", "density_kg_m3",
                                           "damping_s"};
    const std::vector<material::LawParameter> law = material::all_law_parameters();
    for (const material::LawParameter& p : law) material_keys.push_back(p.name);
    const toml::TomlReader material = document.table("material", material_keys);
    s.material = material.text("model");
    for (const material::LawParameter& p : law)
        if (material.has(p.name)) s.law[p.name] = material.number(p.name, toml::between(p.lower, p.upper));
    s.youngs_modulus_Pa = material.number("youngs_modulus_Pa", within(ui::commands::youngs_modulus_limits));
    s.poissons_ratio = material.number("poissons_ratio", within(ui::commands::poissons_ratio_limits));
    s.density_kg_m3 = material.number("density_kg_m3", within(ui::commands::density_limits));
    s.damping_s = material.number("damping_s", within(ui::commands::damping_limits));
    const toml::TomlReader time = document.table(
        "time", {"integrator", "step_s", "own_step", "spectral_radius", "velocity_force_1_s"});
    s.integrator = time.text("integrator");
    s.time_step_s = time.number("step_s", within(ui::commands::time_step_limits));
    s.own_step = time.boolean_or("own_step", true);  // files from before this key had a step set by the user
    s.spectral_radius = time.number_or("spectral_radius", s.spectral_radius,
                                       within(ui::commands::spectral_radius_limits));
    s.velocity_force_1_s = time.number_or("velocity_force_1_s", 0.0, within(ui::commands::velocity_force_limits));
    s.muscles = read_project_muscles(document, root, folder, warnings);
    s.effects = read_project_effects(document, root);
    for (const toml::TomlReader& table : document.tables("effect_off", {"index", "id"}))
        s.off.push_back({static_cast<std::size_t>(table.number("index", toml::between(0.0, 1e6))), table.text("id")});
    return s;
}

/// View options; missing keys keep their defaults.
ui::commands::ViewOptions read_view(const toml::TomlReader& document) {
    ui::commands::ViewOptions result;
    std::vector<std::string> keys{"opacity", "field", "color_map", "cut", "field_ranges"};
    for (const ViewSwitch& each : view_switches) keys.emplace_back(each.key);
    const toml::TomlReader view = document.table("view", keys);
    for (const ViewSwitch& each : view_switches) result.*each.value = view.boolean_or(each.key, result.*each.value);
    result.opacity = view.number_or("opacity", 1.0, toml::between(0.0, 1.0));
    result.field = view.text_or("field", "");
    result.color_map = view.text_or("color_map", "");
    if (view.has("cut")) {
        const toml::TomlReader cut = view.table("cut", {"normal", "position_m", "flip"});
        result.clip = {true, cut.vector3("normal"), cut.number("position_m"), cut.boolean_or("flip", false)};
        if (std::abs(result.clip.normal.norm() - 1.0) > 1e-6) cut.fail("normal", "must have the length 1");
    }
    if (!view.has("field_ranges")) return result;
    const toml::TomlReader ranges = view.table_of_names("field_ranges");
    for (const std::string& field : ranges.keys()) {
        const Eigen::VectorXd range = ranges.vector(field, 2);
        if (!(range(0) < range(1))) ranges.fail(field, "must ascend");
        result.field_ranges[field] = {range(0), range(1)};
    }
    return result;
}

/// A project from its parsed file; throws TomlFailure.
ui::commands::Project read_document(const toml::TomlValue& root, const fs::path& file) {
    if (const toml::TomlValue* const named = root.find("schema"); named == nullptr || named->text != schema)
        throw toml::TomlFailure{Error{"schema: this is not a project; this program reads \"" + schema + "\"",
                                      named ? named->where : file.string()}};
    const toml::TomlReader document(
        root, "",
        {"schema", "source", "copy_of", "self_contained", "metres_per_unit", "trial", "declaration", "declared_mesh",
         "mesh", "material", "time", "view", "muscle", "painted", "effect", "effect_off"});
    ui::commands::Project project;
    std::error_code ignored;
    const fs::path source = document.text("source");
    project.source = source.is_absolute() ? source : (file.parent_path() / source).lexically_normal();
    project.source_missing = !fs::exists(project.source, ignored);
    // A trailing slash is removed, so that paths compare equal.
    if (project.source.filename().empty()) project.source = project.source.parent_path();
    project.self_contained = document.boolean_or("self_contained", false);
    if (document.has("copy_of")) project.copy_of = document.text("copy_of");
    project.metres_per_unit = document.optional_number("metres_per_unit", toml::positive());
    project.trial = document.text_or("trial", "");
    project.settings = read_settings(document, root, file.parent_path(), project.warnings);
    if (document.has("declaration"))
        project.settings.declaration = {std::make_shared<const std::string>(document.text("declaration")),
                                        document.text_or("declared_mesh", ""),
                                        read_project_parts(document, file.parent_path(), project.warnings)};
    if (document.has("view")) project.view = read_view(document);
    return project;
}

}  // namespace

Result<void> write_project_file(const fs::path& file, const ui::commands::Project& project) {
    std::error_code ignored;
    const fs::path folder = fs::absolute(file, ignored).parent_path();
    const fs::path files = fs::path(file).replace_extension(".files");
    fs::path source = project.source;
    if (project.self_contained) {
        const Result<fs::path> inside = put_inside(project, files);
        if (!inside) return inside.error();
        source = *inside;
    }
    std::string
        text = "# A project of Myoloop: what was set, painted and drawn on an experiment or a mesh.\nschema = " +
               toml::toml_text(schema) + "\nsource = " + toml::toml_text(seen_from(source, folder)) + "\n";
    if (!project.copy_of.empty()) text += "copy_of = " + toml::toml_text(project.copy_of.generic_string()) + "\n";
    if (project.self_contained) text += "self_contained = true\n";
    if (project.metres_per_unit) text += "metres_per_unit = " + toml::toml_number(*project.metres_per_unit) + "\n";
    if (!project.trial.empty()) text += "trial = " + toml::toml_text(project.trial) + "\n";
    // The copy of a self-contained project has the edits already.
    if (const ui::commands::Declaration& d = project.settings.declaration; d.text && !project.self_contained)
        text += "declaration = " + toml::toml_text(*d.text) + "\ndeclared_mesh = " + toml::toml_text(d.mesh_words) +
                "\n";
    text += settings_text(project.settings);
    std::set<std::string> used;
    if (!project.self_contained) {
        const Result<std::string> masks = project_text_of_masks(project.settings.declaration, files, used);
        if (!masks) return masks.error();
        text += *masks;
    }
    for (const ui::commands::Muscle& muscle : project.settings.muscles) {
        std::string mask;
        if (muscle.paint && muscle.paint->count() > 0) {
            const std::string name = mask_name(muscle.name, *muscle.paint);
            // An existing file of this name has the same content.
            if (!fs::exists(files / name, ignored))
                if (const Result<void> written = fibre::write_painted_mask(files / name, *muscle.paint); !written)
                    return written;
            used.insert(name);
            mask = files.filename().string() + "/" + name;
        }
        text += muscle_text(muscle, mask);
    }
    text += view_text(project.view);
    // Masks are written before the project file and removed after it, so an interruption leaves a consistent project.
    const std::set<std::string> before = named_masks(file, files);
    if (const Result<void> written = write_file(file, text); !written) return written;
    for (const std::string& mask : before)
        if (!used.contains(mask) && !is_named_beside(file, files.filename().string() + "/" + mask))
            fs::remove(files / mask, ignored);
    return {};
}

Result<ui::commands::Project> read_project_file(const fs::path& file) {
    const Result<toml::TomlValue> document = toml::read_toml(file);
    if (!document) return document.error();
    try {
        return read_document(*document, fs::absolute(file));
    } catch (const toml::TomlFailure& failure) {
        return failure.error;
    }
}

}  // namespace myo::backend
