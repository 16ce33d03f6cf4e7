#include "results/optimized_experiment.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "experiment/actuators.hpp"
#include "experiment/experiment_text.hpp"
#include "results/optimize_output.hpp"
#include "results/output_files.hpp"
#include "toml/toml_edit.hpp"
#include "toml/toml_text.hpp"

namespace myo::results {
namespace {
namespace fs = std::filesystem;

/// Edits of a text, one after another; the first error stays.
class Edits {
public:
    explicit Edits(Result<std::string> text) : text_(std::move(text)) {}
    void set(const toml::TomlPath& path, const std::string& value) {
        if (text_) text_ = toml::with_value(*text_, path, value);
    }
    void remove(const toml::TomlPath& path) {
        if (text_) text_ = toml::without(*text_, path);
    }
    Result<std::string> take() { return std::move(text_); }

private:
    Result<std::string> text_;
};

/// Names of the masks of all muscles.
std::vector<fs::path> all_mask_files(const experiment::Experiment& experiment) {
    // Safe file names, made distinct in the order of the muscles: index m belongs to muscle m.
    std::vector<std::string> names;
    for (const experiment::MuscleDeclaration& muscle : experiment.muscles) names.push_back(muscle.name);
    std::vector<fs::path> files;
    for (const std::string& name : trial_file_names(names)) files.emplace_back(name + "_mask.csv");
    return files;
}

/// States one quantity of the body that was found.
void state_item(const experiment::Experiment& experiment, const calibration::FoundItem& found, Edits& edits) {
    if (found.item.kind == calibration::SoughtKind::modulus) {
        // With the digits that people read.
        double modulus_Pa = found.youngs_modulus_Pa;
        parse_number(format_number(modulus_Pa, 8), modulus_Pa);
        const std::string modulus = toml::toml_number(modulus_Pa);
        if (found.item.of.empty())
            edits.set({"material", "youngs_modulus_Pa"}, modulus);
        else
            edits.set({"part", found.index, "youngs_modulus_Pa"}, modulus);
        return;
    }
    if (found.mask)
        edits.set({"muscle", found.index, "mask"}, toml::toml_text(all_mask_files(experiment)[found.index].string()));
    if (found.fibre) edits.set({"muscle", found.index, "fibre"}, toml::toml_vector(*found.fibre));
}

/// Why the signals cannot stand in the file; empty if they can.
std::string hindrance(const experiment::Experiment& experiment) {
    for (const experiment::MuscleDeclaration& muscle : experiment.muscles)
        if (muscle.signal)
            return "muscle \"" + muscle.name + "\" has a signal for all trials, which comes before that of a trial";
    return "";
}

/// Signals of the trial in place of its commands.
void state_signals(const setup::Setup& setup, const calibration::Optimization& optimization, std::size_t trial,
                   Edits& edits) {
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    // All kinds of commands, since any of them left in the file would conflict with the new ones or add to them.
    for (const char* key : {"actuation_step", "activation", "pressure_Pa", "tension_N", "shortening_m", "actuation"})
        edits.remove({"trial", trial, key});
    if (!sought.constant)
        return edits.set({"trial", trial, "actuation"}, toml::toml_text(actuation_file_name(setup).string()));
    for (std::size_t s = 0; s < sought.signals.size(); ++s) {
        const std::size_t actuator = *experiment::find_actuator(setup.experiment, sought.signals[s].name);
        edits.set({"trial", trial, experiment::constant_key(experiment::actuators(setup.experiment)[actuator].kind),
                   sought.signals[s].name},
                  toml::toml_number(optimization.fit.values(static_cast<Eigen::Index>(s), 0)));
    }
}

}  // namespace

Result<std::string> optimized_experiment(const fs::path& written, const fs::path& folder, const setup::Setup& setup,
                                         const calibration::Optimization& optimization, std::size_t trial,
                                         std::string* skipped) {
    Edits edits(experiment::experiment_text_for(folder, written));
    // Edits keep the user's text, comments included, except for the values that are replaced.
    for (const calibration::FoundItem& found : optimization.found) state_item(setup.experiment, found, edits);
    if (!optimization.problem.sought.signals.empty()) {
        const std::string reason = hindrance(setup.experiment);
        if (reason.empty())
            state_signals(setup, optimization, trial, edits);
        else if (skipped != nullptr)
            *skipped = "the signals found are not in experiment_optimized.toml: " + reason;
    }
    return edits.take();
}

std::vector<fs::path> mask_files(const experiment::Experiment& experiment,
                                 const std::vector<calibration::SoughtItem>& seek) {
    const std::vector<fs::path> all = all_mask_files(experiment);
    std::vector<fs::path> files;
    for (std::size_t m = 0; m < all.size(); ++m) {
        const experiment::MuscleDeclaration& muscle = experiment.muscles[m];
        // The single direction of other muscles is a key of the text; painted fibres are a file.
        if (std::holds_alternative<experiment::MuscleMask>(muscle.part) &&
            std::any_of(seek.begin(), seek.end(), [&](const calibration::SoughtItem& item) {
                return item.of == muscle.name && item.kind != calibration::SoughtKind::modulus;
            }))
            files.push_back(all[m]);
    }
    return files;
}

Result<void> write_masks(const fs::path& folder, const experiment::Experiment& experiment,
                         const std::vector<calibration::FoundItem>& found) {
    const std::vector<fs::path> all = all_mask_files(experiment);
    for (const calibration::FoundItem& item : found)
        if (item.mask)
            if (const Result<void> written = fibre::write_painted_mask(folder / all[item.index], *item.mask); !written)
                return written.error();
    return {};
}

}  // namespace myo::results
