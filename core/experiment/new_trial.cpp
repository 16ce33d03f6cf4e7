#include "experiment/new_trial.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "base/files.hpp"
#include "experiment/law_values.hpp"
#include "experiment/read_experiment.hpp"
#include "material/catalogue.hpp"
#include "measurement/trace_csv.hpp"
#include "mesh/vtk_writer.hpp"
#include "toml/toml_text.hpp"

namespace myo::experiment {

namespace fs = std::filesystem;

namespace {

constexpr const char* declaration_file = "experiment.toml";
/// Reflecting spheres of motion capture stand on posts, 6 to 15 mm off the body.
const std::string standoff_text = "max_standoff_m = 0.02\n";

// A control character in the origin would end the TOML comment early.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

/// Declaration of the trial as TOML; start_s = 0 because its samples are already in trial time.
std::string trial_text(const NewTrial& trial) {
    return "\n# " + one_line(trial.origin) + "\n[[trial]]\nname = " + toml::toml_text(trial.name) +
           "\nrole = " + toml::toml_text(to_string(trial.role)) + "\ntrace = " + toml::toml_text(trial.name + ".csv") +
           "\nformat = \"csv\"\nstart = " + (trial.start == StartState::straight ? "\"straight\"" : "\"equilibrium\"") +
           "\nstart_s = 0.0\n";
}

/// Writes trace and declaration; restores the folder if the result cannot be read as an experiment.
///
/// The new declaration is first written and read under a temporary name, so a failure leaves experiment.toml untouched.
Result<void> put(const fs::path& folder, const std::string& text, const NewTrial& trial) {
    const fs::path trace = folder / (trial.name + ".csv"), tried = folder / "experiment.new.toml";
    std::error_code code;
    if (fs::exists(trace, code))
        return Error{"there is a file of this name already; choose another name for the trial", trace.string()};
    if (const Result<void> written = measurement::write_trace_csv(trace, trial.recording); !written)
        return written.error();
    // The trace must exist before the declaration is read, as the reader opens it; every failure removes it again.
    const auto take_back = [&](const Error& error) {
        fs::remove(trace, code);
        fs::remove(tried, code);
        return error;
    };
    if (const Result<void> written = write_file(tried, text); !written) return take_back(written.error());
    if (const Result<Experiment> read = read_experiment(tried); !read) return take_back(read.error());
    // Only a declaration that has been read without error replaces the present one.
    const Result<void> written = write_file(folder / declaration_file, text);
    if (!written) return take_back(written.error());
    fs::remove(tried, code);
    return {};
}

// The name becomes a file in the folder and must not lead out of it.
bool is_file_name(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos;
}

}  // namespace

Result<void> add_trial(const fs::path& folder, const NewTrial& trial, const std::string* declaration) {
    if (!is_file_name(trial.name))
        return Error{"names the trial's file, so it must be a file's name without a slash", "\"" + trial.name + "\""};
    // The text as it is must be valid: otherwise its own errors would look like errors of the new trial.
    const fs::path file = folder / declaration_file;
    const Result<std::string> text = declaration ? Result<std::string>(*declaration) : read_file(file);
    if (!text) return text.error();
    const Result<Experiment> before = read_experiment_text(*text, file);
    if (!before) return before.error();
    for (const TrialDeclaration& known : before->trials)
        if (known.name == trial.name)
            return Error{"the experiment has a trial of this name already", "\"" + trial.name + "\""};
    return put(folder, *text + (text->ends_with('\n') ? "" : "\n") + trial_text(trial), trial);
}

namespace {

/// Makes a new folder, or takes an empty one; `made`: it did not exist.
Result<void> make_folder(const fs::path& folder, bool& made) {
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_empty(folder, code))
        return Error{"is not empty; choose a new folder", folder.string()};
    made = fs::create_directories(folder, code);
    if (code) return Error{"cannot be made: " + code.message(), folder.string()};
    return {};
}

/// Clamp and supports as TOML; empty without either.
std::string holding_text(const Experiment& declared) {
    const auto box = [](const Box& box_m) {
        return "box_m = [" + toml::toml_vector(box_m.lowest) + ", " + toml::toml_vector(box_m.highest) + "]\n";
    };
    std::string text;
    if (has_clamp(declared)) text += "\n[clamp]\n" + box(declared.clamp_box_m);
    for (const SupportDeclaration& support : declared.supports) {
        text += "\n[[support]]\n" + box(support.box_m);
        std::vector<std::string> axes;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (support.held[axis]) axes.emplace_back(1, "xyz"[axis]);
        if (!support.clamps()) text += "held = " + toml::toml_list(axes, toml::toml_text) + "\n";
    }
    return text;
}

/// Body, clamp, supports, material and gravity as TOML.
std::string body_text(const Experiment& declared) {
    const MaterialDeclaration& material = declared.material;
    std::string text = "schema = \"experiment/1\"\nname = " + toml::toml_text(declared.name) +
                       "\n\n[geometry]\nkind = \"stl\"\nfile = \"body.stl\"\nunit = \"m\"\n";
    text += holding_text(declared);
    text += "\n[material]\nmodel = " + toml::toml_text(material.model) +
            "\nyoungs_modulus_Pa = " + toml::toml_number(material.youngs_modulus_Pa) +
            "\npoissons_ratio = " + toml::toml_number(material.poissons_ratio) +
            "\ndensity_kg_m3 = " + toml::toml_number(material.density_kg_m3) + "\n";
    text += law_values_text(*material::find_material(material.model), material.law);
    if (material.damping_s) text += "damping_s = " + toml::toml_number(*material.damping_s) + "\n";
    return text + "\n[environment]\ngravity_m_s2 = " + toml::toml_vector(declared.gravity_m_s2) + "\n";
}

/// Writes body.stl and then what `put_text` writes; takes both back if that fails.
template <class PutText>
Result<void> write_folder(const fs::path& folder, const mesh::SurfaceMesh& surface, const PutText& put_text) {
    bool made = false;
    if (Result<void> ready = make_folder(folder, made); !ready) return ready;
    Result<void> written = mesh::write_stl(folder / "body.stl", surface, 1.0);
    if (written) written = put_text();
    if (written) return {};
    std::error_code code;
    // Errors of the clean-up are ignored: the first error is the one to report.
    fs::remove(folder / "body.stl", code);
    // A folder that existed before stays, even if it was empty.
    if (made) fs::remove(folder, code);
    return written.error();
}

}  // namespace

Result<void> write_experiment(const fs::path& folder, const Experiment& declared, const mesh::SurfaceMesh& surface,
                              const NewTrial& trial) {
    if (!is_file_name(trial.name))
        return Error{"names the trial's file, so it must be a file's name without a slash", "\"" + trial.name + "\""};
    // Mocap frames rarely coincide with the mesh frame, so displacements are compared instead of positions.
    std::string text = body_text(declared) + "\n[markers]\ncompare = \"displacement\"\n" + standoff_text +
                       "[markers.rest_m]\n";
    for (const MarkerDeclaration& marker : declared.markers.on_body)
        text += toml::toml_text(marker.name) + " = " + toml::toml_vector(marker.rest_m) + "\n";
    return write_folder(folder, surface, [&] { return put(folder, text + trial_text(trial), trial); });
}

Result<void> write_planned_experiment(const fs::path& folder, const Experiment& declared,
                                      const mesh::SurfaceMesh& surface) {
    const std::string text = body_text(declared) + "\n[markers]\ncompare = \"displacement\"\n" + standoff_text +
                             "[markers.rest_m]\n"
                             "\n[[trial]]\nname = \"release\"\nrole = \"simulate\"\nduration_s = 1.0\n"
                             "start = \"straight\"\n";
    return write_folder(folder, surface, [&]() -> Result<void> {
        const fs::path file = folder / declaration_file;
        // The line would be one of a text that no file holds.
        if (const Result<Experiment> read = read_experiment_text(text, file); !read)
            return Error{read.error().what, folder.string()};
        return write_file(file, text);
    });
}

Result<void> copy_experiment(const fs::path& from, const fs::path& to) {
    std::error_code code;
    if (fs::exists(to, code) && !fs::is_empty(to, code)) return Error{"is not empty; choose a new folder", to.string()};
    // Copying a folder into itself would recurse without end.
    const fs::path inner = fs::weakly_canonical(to, code).lexically_relative(fs::weakly_canonical(from, code));
    if (!inner.empty() && *inner.begin() != "..")
        return Error{"lies in the experiment that is to be copied; choose a folder outside", to.string()};
    fs::create_directories(to, code);
    if (!code) fs::copy(from, to, fs::copy_options::recursive, code);
    if (!code) return {};
    std::error_code ignored;
    // A half copy would look like an experiment.
    fs::remove_all(to, ignored);
    return Error{"the experiment cannot be copied there: " + code.message(), to.string()};
}

}  // namespace myo::experiment
