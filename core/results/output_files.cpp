#include "results/output_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include "base/files.hpp"
#include "measurement/trace_csv.hpp"
#include "mesh/volume_reader.hpp"
#include "mesh/vtk_writer.hpp"
#include "prediction/laboratory_trace.hpp"
#include "results/output_motion.hpp"

namespace myo::results {
namespace {
namespace fs = std::filesystem;

struct OutputNamePolicy {
    std::size_t max_bytes = 150;  // file systems allow 255; the rest is for endings and numbers
};
constexpr OutputNamePolicy output_name_policy;

/// File names of the trials of a setup, in their order.
std::vector<std::string> names_of(const setup::Setup& setup) { return trial_file_names(setup.experiment); }

// Bytes above 127 belong to letters of other alphabets in UTF-8 and are kept.
std::string safe_name(const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        safe += std::isalnum(byte) != 0 || byte > 127 || c == '-' || c == '_' || c == '.' ? c : '_';
    }
    if (safe.empty() || safe.front() == '.') safe.insert(safe.begin(), '_');
    if (safe.size() <= output_name_policy.max_bytes) return safe;
    std::size_t end = output_name_policy.max_bytes;
    // Bytes that continue a character of UTF-8 are left out together with its first one.
    while (end > 0 && (static_cast<unsigned char>(safe[end]) & 0xC0) == 0x80) --end;
    return safe.substr(0, end);
}

/// Indices of the steps closest to equally spaced times, without repetition.
std::vector<std::size_t> spread(const std::vector<double>& times_s, int count) {
    std::vector<std::size_t> chosen;
    const double first = times_s.front(), last = times_s.back();
    for (int i = 0; i < count; ++i) {
        const double wanted = first + (last - first) * i / std::max(1, count - 1);
        const auto above = std::lower_bound(times_s.begin(), times_s.end(), wanted - 1e-12);
        auto k = static_cast<std::size_t>(above - times_s.begin());
        if (k == times_s.size()) --k;
        // The nearer one of the two steps around the wanted time.
        if (k > 0 && wanted - times_s[k - 1] < times_s[k] - wanted) --k;
        if (chosen.empty() || k > chosen.back()) chosen.push_back(k);
    }
    return chosen;
}

/// "<name>_frames/0007.vtu".
fs::path frame_file(const std::string& name, int frame) {
    char number[16];
    std::snprintf(number, sizeof number, "%04d.vtu", frame);
    return fs::path(name + "_frames") / number;
}

/// Removes an earlier series and no other file in its folder.
void remove_series(const fs::path& folder, const std::string& name) {
    std::error_code code;
    fs::remove(folder / (name + ".pvd"), code);
    for (int i = 0; fs::remove(folder / frame_file(name, i), code); ++i) {}
    fs::remove(folder / frame_file(name, 0).parent_path(), code);  // fails, harmlessly, unless empty
}

/// Frames of one trial as VTU files and the PVD index.
Result<void> write_trial_series(const fs::path& folder, const std::string& name, const setup::Setup& setup,
                                const dynamics::Trace& trace, int frames, const Progress& progress) {
    std::vector<double> times;
    std::vector<fs::path> files;
    // Frames are steps of the run, not interpolated states: the stored velocities belong to them.
    const std::vector<std::size_t> steps = spread(trace.times_s, frames);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (progress.cancelled()) return Error{"stopped by the user", ""};
        const std::size_t k = steps[i];
        mesh::VolumeMesh mesh = setup.mesh.mesh;
        // Written with the mesh in its deformed shape; the rest shape is position minus displacement.
        const Eigen::Matrix3Xd displacement = trace.positions[k] - mesh.nodes;
        mesh.nodes = trace.positions[k];
        const fs::path file = frame_file(name, static_cast<int>(i));
        if (const Result<void> written = mesh::write_vtu(
                folder / file, mesh, {{"displacement", displacement}, {"velocity", trace.velocities[k]}});
            !written)
            return written.error();
        times.push_back(trace.times_s[k]);
        files.push_back(file);
        progress.report({"write " + name, static_cast<double>(i + 1), static_cast<double>(steps.size()), "frames", {}});
    }
    return mesh::write_pvd(folder / (name + ".pvd"), times, files);
}

}  // namespace

std::vector<std::string> trial_file_names(const std::vector<std::string>& trial_names) {
    std::vector<std::string> names;
    for (const std::string& trial : trial_names) {
        const std::string wanted = safe_name(trial);
        std::string name = wanted;
        // Two names can become equal by the replacement of characters.
        for (int i = 2; std::find(names.begin(), names.end(), name) != names.end(); ++i)
            name = wanted + "_" + std::to_string(i);
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> trial_file_names(const experiment::Experiment& experiment) {
    std::vector<std::string> names;
    for (const experiment::TrialDeclaration& trial : experiment.trials) names.push_back(trial.name);
    return trial_file_names(names);
}

Result<void> write_traces(const fs::path& folder, const setup::Setup& setup, const prediction::SetupRun& run) {
    const std::vector<std::string> names = names_of(setup);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        if (!run.predictions[t].ok()) continue;
        if (const Result<void> written = measurement::write_trace_csv(
                folder / (names[t] + ".csv"), simulated_recording(setup, t, run.predictions[t]));
            !written)
            return written.error();
    }
    return {};
}

Result<void> write_series(const fs::path& folder, const setup::Setup& setup, const prediction::SetupRun& run,
                          int frames, const Progress& progress) {
    const std::vector<std::string> names = names_of(setup);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        if (!run.predictions[t].ok()) continue;
        // The earlier series may have more frames than the new one; a failed series is removed as a whole.
        remove_series(folder, names[t]);
        const dynamics::Trace& trace = run.predictions[t].trace;
        // A body on a moving mount is computed in the frame of its mount and shown in that of the laboratory.
        const std::optional<dynamics::Trace> seen = prediction::laboratory_trace(setup, t, run.values, trace);
        const Result<void> written = write_trial_series(folder, names[t], setup, seen ? *seen : trace, frames,
                                                        progress);
        if (written) continue;
        remove_series(folder, names[t]);
        return written.error();
    }
    return {};
}

std::vector<fs::path> files_read(const fs::path& declared, const experiment::Experiment& experiment) {
    std::error_code code;
    std::vector<fs::path> files{fs::is_directory(declared, code) ? declared / "experiment.toml" : declared};
    if (const auto* surface = std::get_if<experiment::StlGeometry>(&experiment.geometry))
        files.push_back(surface->file);
    files.insert(files.end(), experiment.law_files.begin(), experiment.law_files.end());
    if (const auto* volume = std::get_if<experiment::VolumeGeometry>(&experiment.geometry))
        for (fs::path& file : mesh::volume_files(volume->file)) files.push_back(std::move(file));
    for (const experiment::PartDeclaration& part : experiment.parts) {
        if (const auto* file = std::get_if<fs::path>(&part.place)) files.push_back(*file);
        const auto* const painted = std::get_if<experiment::PartDeclaration::Painted>(&part.place);
        if (const auto* mask = painted ? std::get_if<fs::path>(&painted->mask) : nullptr) files.push_back(*mask);
    }
    for (const experiment::TrialDeclaration& trial : experiment.trials) {
        if (!trial.trace.empty()) files.push_back(trial.trace);
        if (trial.actuation) files.push_back(*trial.actuation);
        if (trial.sensors) files.push_back(*trial.sensors);
        for (const experiment::GoalDeclaration& goal : trial.goals)
            if (goal.file) files.push_back(*goal.file);
    }
    for (const experiment::MuscleDeclaration& muscle : experiment.muscles) {
        if (muscle.signal_file) files.push_back(*muscle.signal_file);
        if (const auto* mask = std::get_if<experiment::MuscleMask>(&muscle.part))
            if (const auto* file = std::get_if<fs::path>(&mask->painted)) files.push_back(*file);
    }
    return files;
}

std::vector<fs::path> trace_files(const fs::path& folder, const experiment::Experiment& experiment) {
    std::vector<fs::path> files;
    for (const std::string& name : trial_file_names(experiment)) files.push_back(folder / (name + ".csv"));
    return files;
}

std::vector<fs::path> series_files(const fs::path& folder, const experiment::Experiment& experiment, int frames) {
    std::vector<fs::path> files;
    std::error_code code;
    for (const std::string& name : trial_file_names(experiment)) {
        files.push_back(folder / (name + ".pvd"));
        // An earlier series, which is removed, may be longer.
        for (int i = 0; i < frames || fs::exists(folder / frame_file(name, i), code); ++i)
            files.push_back(folder / frame_file(name, i));
    }
    return files;
}

Result<void> prepare_output_folder(const fs::path& folder) {
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_directory(folder, code))
        return Error{"is a file, not a folder", folder.string()};
    fs::create_directories(folder, code);
    if (code) return Error{"folder cannot be made: " + code.message(), folder.string()};
    // Only writing shows whether a folder is writable: permissions do not cover read-only or full file systems.
    const fs::path probe = folder / (".write_test." + std::to_string(::getpid()));
    if (!write_file(probe, "")) return Error{"no file can be written there", folder.string()};
    // The name has the process in it: two jobs may test one folder at once.
    fs::remove(probe, code);
    return {};
}

}  // namespace myo::results
