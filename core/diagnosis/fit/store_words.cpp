#include "diagnosis/fit/store_words.hpp"

#include <cstddef>
#include <cstdint>

#include "base/files.hpp"
#include "base/fingerprint.hpp"

namespace myo::diagnosis {
namespace {

/// Hash of recordings, loads, and declared parameters.
/// Start values and steps are part of the key of each fit instead, see fit_key().
std::uint64_t setup_fingerprint(const setup::Setup& setup) {
    Fingerprint print;
    const experiment::MaterialDeclaration& material = setup.experiment.material;
    for (const double number : {material.youngs_modulus_Pa, material.poissons_ratio, material.density_kg_m3,
                                material.damping_s.value_or(-1.0)})
        print.add(number);
    for (const double number : material.law) print.add(number);
    print.add_all(setup.experiment.gravity_m_s2);
    print.add_all(setup.noise_m);
    // A law may have changed under its id.
    for (const std::filesystem::path& file : setup.experiment.law_files)
        if (const Result<std::string> text = read_file(file)) print.add_text(*text);
    // Added only where it is used, so that the hash of other setups does not depend on it.
    if (setup.experiment.markers.placement_m > 0.0) print.add(setup.experiment.markers.placement_m);
    for (const setup::PreparedTrial& trial : setup.trials) {
        print.add_all(trial.measured.time_s);
        for (const Eigen::Matrix3Xd& track : trial.measured.tracks) print.add_all(track);
        for (const model::AttachedMass& mass : trial.model.masses) print.add(mass.mass_kg);
        for (const model::DeadForce& force : trial.model.forces) {
            print.add_all(force.force_N);
            print.add(force.from_s);
            print.add(force.until_s);
            // A force that is only switched on and off has no course.
            if (force.switches()) continue;
            print.add(force.course.times_s.data(), static_cast<std::ptrdiff_t>(force.course.times_s.size()));
            print.add(force.course.values.data(), static_cast<std::ptrdiff_t>(force.course.values.size()));
        }
        for (const fibre::Signal& signal : trial.model.activation)
            print.add(signal.values.data(), static_cast<std::ptrdiff_t>(signal.values.size()));
        for (const fibre::Signal& signal : trial.recorded_commands) {
            print.add(signal.times_s.data(), static_cast<std::ptrdiff_t>(signal.times_s.size()));
            print.add(signal.values.data(), static_cast<std::ptrdiff_t>(signal.values.size()));
        }
    }
    return print.value();
}

}  // namespace

std::string store_words(const setup::Setup& setup) {
    return setup.experiment.name + ", " + to_string(setup.body->kind) + " " +
           std::to_string(setup.mesh.mesh.node_count()) + " nodes, " + to_string(setup.settings.integrator) + ", " +
           std::to_string(setup_fingerprint(setup));
}

}  // namespace myo::diagnosis
