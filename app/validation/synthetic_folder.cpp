#include "validation/synthetic_folder.hpp"

#include <cmath>
#include <limits>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/trace_csv.hpp"
#include "prediction/prediction.hpp"

namespace myo::validation {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

// Pieces of experiment.toml. Nine digits: more than a person writes, so that no rounding is left to be found.
std::string number_text(double value) { return format_number(value, 9); }

std::string vector_text(const Vector3d& v) {
    return "[" + number_text(v(0)) + ", " + number_text(v(1)) + ", " + number_text(v(2)) + "]";
}

std::string box_text(const Box& box) { return "[" + vector_text(box.lowest) + ", " + vector_text(box.highest) + "]"; }

/// Name of a marker in declaration and traces, from 1: "m1".
std::string marker_name(std::size_t index) { return "m" + std::to_string(index + 1); }

/// Boxes by their size, other bodies as STL in their unit.
std::string geometry_text(const SyntheticBody& body) {
    if (body.is_declared_box())
        return "[geometry]\nkind = \"box\"\nsize_m = " + vector_text(body.bounds.size()) +
               "\norigin_m = " + vector_text(body.bounds.lowest) + "\n";
    return std::string("[geometry]\nkind = \"stl\"\nfile = \"body.stl\"\nunit = \"") +
           (body.metres_per_unit == 1.0 ? "m" : "mm") + "\"\n";
}

/// Declared material: the modulus with its tolerance; the damping only where it is known.
std::string material_text(const SyntheticMaterial& m) {
    std::string text = "[material]\nmodel = \"neo_hookean\"\nyoungs_modulus_Pa = " +
                       number_text(m.declared_modulus_Pa) +
                       "\nyoungs_modulus_tolerance = 0.3\npoissons_ratio = " + number_text(m.poissons_ratio) +
                       "\ndensity_kg_m3 = " + number_text(m.density_kg_m3) + "\n";
    if (m.damping_is_known)
        return text + "damping_s = " + number_text(m.damping_s) + "\ncalibrate = [\"youngs_modulus\"]\n";
    return text + "calibrate = [\"youngs_modulus\", \"damping\"]\n";
}

/// A tendon of prescribed tension; its friction is not declared.
std::string tendon_text(const SyntheticTendon& tendon) {
    std::string guides;
    for (const auto& guide : tendon.path_m.colwise())
        guides += (guides.empty() ? "" : ", ") + vector_text(Eigen::Vector3d(guide));
    return "[[tendon]]\nname = \"" + tendon.name + "\"\npath_m = [" + guides + "]\ndrive = \"tension\"\n";
}

/// Limits of an unknown registration; drawn_case() stays within them.
std::string registration_text(const SyntheticCase& c) {
    if (c.registration_is_known) return "[registration]\nknown = true\n";
    return "[registration]\nknown = false\nmax_translation_m = 0.001\nmax_rotation_deg = 0.5\n";
}

/// A trial with its files and loads; a trial may use the recording of another one.
std::string trial_text(const SyntheticTrial& trial) {
    std::string text = "[[trial]]\nname = \"" + trial.name + "\"\nrole = \"" +
                       (trial.role == experiment::TrialRole::fit ? "fit" : "validate") + "\"\ntrace = \"" +
                       trial.recording() + ".csv\"\nformat = \"csv\"\nstart = \"" +
                       (trial.start == experiment::StartState::straight ? "straight" : "equilibrium") +
                       "\"\nsession_time_s = " + number_text(trial.session_time_s) + "\n";
    if (trial.has_actuation()) text += "actuation = \"" + trial.recording() + "_actuation.csv\"\n";
    for (const experiment::LoadDeclaration& load : trial.loads) {
        text += "[[trial.load]]\nkind = \"" + std::string(load.kind == experiment::LoadKind::mass ? "mass" : "force") +
                "\"\nbox_m = " + box_text(load.box_m) + "\n";
        text += load.kind == experiment::LoadKind::mass ? "mass_kg = " + number_text(load.mass_kg) + "\n"
                                                        : "force_N = " + vector_text(load.force_N) + "\n";
        if (std::isfinite(load.from_s)) text += "from_s = " + number_text(load.from_s) + "\n";
        if (std::isfinite(load.until_s)) text += "until_s = " + number_text(load.until_s) + "\n";
    }
    return text;
}

/// Sample times of a trial [s]: whole sampling intervals from t = 0 to its end.
Eigen::VectorXd sample_times(const SyntheticCase& c, const SyntheticTrial& trial) {
    const auto count = static_cast<Index>(std::lround(trial.end_s * c.rate_Hz)) + 1;
    return Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1) / c.rate_Hz);
}

/// Recording of a body that does not move: makes the folder readable before the motions are simulated.
measurement::Recording still_recording(const SyntheticCase& c, const SyntheticTrial& trial) {
    measurement::Recording recording;
    recording.rate_Hz = c.rate_Hz;
    recording.time_s = sample_times(c, trial);
    for (std::size_t m = 0; m < c.markers.size(); ++m) {
        recording.labels.push_back(marker_name(m));
        recording.tracks.push_back(c.markers[m].replicate(1, recording.time_s.size()));
    }
    return recording;
}

/// Recording by the cameras: transformed into their frame, with noise and with one marker occluded for a while.
measurement::Recording seen_recording(const SyntheticCase& c, const SyntheticTrial& trial,
                                      const std::vector<Eigen::Matrix3Xd>& positions_m, RandomStream& random) {
    measurement::Recording recording = still_recording(c, trial);
    const Eigen::Matrix3d R = measurement::small_rotation(c.rotation_rad);
    for (std::size_t m = 0; m < positions_m.size(); ++m) {
        Eigen::Matrix3Xd& track = recording.tracks[m];
        track = (R * positions_m[m]).colwise() + c.translation_m;
        for (double& x : track.reshaped()) x += c.noise_m * random.normal();
    }
    const auto hidden = static_cast<Index>(c.occluded * static_cast<double>(recording.time_s.size()));
    if (hidden > 0) {
        Eigen::Matrix3Xd&
            track = recording.tracks[static_cast<std::size_t>(random.below(static_cast<int>(c.markers.size())))];
        const auto first = static_cast<Index>(random.below(static_cast<int>(track.cols() - hidden)));
        track.middleCols(first, hidden).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return recording;
}

/// Commands of muscles and tendon at the sample times, as an actuation file.
Result<void> write_actuation(const SyntheticCase& c, const SyntheticTrial& trial, const std::filesystem::path& path) {
    measurement::ActuationTable table;
    table.time_s = sample_times(c, trial);
    std::vector<fibre::Signal> signals = trial.activation;
    for (const SyntheticMuscle& muscle : c.muscles) table.muscles.push_back(muscle.name);
    if (trial.tension_N) {
        table.muscles.push_back(c.tendon->name + "_N");
        signals.push_back(*trial.tension_N);
    }
    table.values.resize(static_cast<Index>(signals.size()), table.time_s.size());
    for (std::size_t s = 0; s < signals.size(); ++s)
        for (Index i = 0; i < table.time_s.size(); ++i)
            table.values(static_cast<Index>(s), i) = signals[s].value(table.time_s(i));
    // Declaration error of the unit: times in ms if signal_unit_s is 1e-3.
    table.time_s /= trial.signal_unit_s;
    return measurement::write_actuation_csv(path, table);
}

}  // namespace

std::string experiment_text(const SyntheticCase& c) {
    std::string text = "schema = \"experiment/1\"\nname = \"" + c.name() + "\"\n\n" + geometry_text(c.body) +
                       "\n[clamp]\nbox_m = " + box_text(c.body.clamp) + "\n\n" + material_text(c.material) +
                       "\n[environment]\ngravity_m_s2 = " + vector_text(c.gravity_m_s2) + "\n";
    for (const SyntheticMuscle& muscle : c.muscles)
        text += "\n[[muscle]]\nname = \"" + muscle.name + "\"\nbox_m = " + box_text(muscle.box) +
                "\nfibre = [1.0, 0.0, 0.0]\nstiffness_Pa = " + number_text(muscle.stiffness_Pa) + "\n";
    if (c.tendon) text += "\n" + tendon_text(*c.tendon);
    text += "\n" + registration_text(c) + "\n[markers]\n";
    if (c.noise_is_declared) text += "noise_m = " + number_text(c.noise_m) + "\n";
    text += "[markers.rest_m]\n";
    for (std::size_t m = 0; m < c.markers.size(); ++m)
        text += marker_name(m) + " = " + vector_text(c.markers[m]) + "\n";
    for (const SyntheticTrial& trial : c.trials) text += "\n" + trial_text(trial);
    return text;
}

Result<void> write_still_experiment(const SyntheticCase& c, const std::filesystem::path& folder) {
    if (const Result<void> file = write_file(folder / "experiment.toml", experiment_text(c)); !file) return file;
    if (!c.body.is_declared_box())
        if (const Result<void> file = write_file(folder / "body.stl", stl_text(c.body)); !file) return file;
    for (const SyntheticTrial& trial : c.trials) {
        if (const Result<void> file = measurement::write_trace_csv(folder / (trial.name + ".csv"),
                                                                   still_recording(c, trial));
            !file)
            return file;
        if (!trial.has_actuation()) continue;
        if (const Result<void> file = write_actuation(c, trial, folder / (trial.name + "_actuation.csv")); !file)
            return file;
    }
    return {};
}

Result<void> write_traces(const SyntheticCase& c, const std::vector<std::vector<Eigen::Matrix3Xd>>& positions_m,
                          const std::filesystem::path& folder) {
    RandomStream random = c.noise();
    for (std::size_t t = 0; t < positions_m.size(); ++t) {
        const SyntheticTrial& trial = c.trials[t];
        measurement::Recording seen = seen_recording(c, trial, positions_m[t], random);
        // Declaration error of the clock: the file does not start at t = 0.
        seen.time_s.array() += trial.clock_s;
        if (const Result<void> file = measurement::write_trace_csv(folder / (trial.name + ".csv"), seen); !file)
            return file;
    }
    return {};
}

}  // namespace myo::validation
