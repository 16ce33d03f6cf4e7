#include "diagnosis/fit/store_words.hpp"

#include <cstddef>
#include <cstdint>

#include "base/files.hpp"
#include "base/fingerprint.hpp"

namespace myo::diagnosis {
namespace {

/// Adds where the body is, where it is held, and where its markers and muscles sit.
void add_body(const setup::Setup& setup, Fingerprint& print) {
    const model::Body& body = *setup.body;
    print.add_all(body.mesh.nodes);
    for (std::size_t node = 0; node < body.clamped.size(); ++node)
        if (body.clamped[node]) print.add(static_cast<double>(node));
    for (const model::GuidedNode& guided : body.guided) {
        print.add(guided.node);
        for (const bool held : guided.held) print.add(held ? 1.0 : 0.0);
    }
    for (const measurement::MarkerBinding& marker : setup.markers.bindings) {
        for (const int node : marker.nodes) print.add(node);
        print.add_all(marker.weights);
        print.add_all(marker.offset);
    }
    print.add_all(setup.part_shares);
    for (const setup::Chamber& chamber : setup.chambers) {
        for (const int wall : chamber.walls) print.add(wall);
        print.add(chamber.volume_factor);
    }
    for (const setup::Tendon& tendon : setup.tendons) {
        for (const model::TendonGuide& guide : tendon.route.guides) print.add_all(guide.rest_m);
        for (const double number :
             {tendon.route.friction, tendon.by_shortening ? 1.0 : 0.0, tendon.stiffness_N_m, tendon.slack_m})
            print.add(number);
    }
}

/// Adds the muscles of a trial's model.
void add_muscles(const model::Model& model, Fingerprint& print) {
    for (const fibre::FibreGroup& muscle : *model.fibres) {
        print.add(muscle.stiffness_Pa);
        for (const fibre::FibrePoint& point : muscle.points) {
            print.add(point.cell);
            print.add(point.volume);
            print.add_all(point.shape);
        }
    }
}

/// Adds what was measured beside the markers, and how the trial is run.
void add_readings(const setup::PreparedTrial& trial, Fingerprint& print) {
    print.add(static_cast<double>(trial.role));
    print.add(trial.hold ? 1.0 : 0.0);
    for (const setup::SensorSeries& series : trial.sensors) {
        print.add_text(series.column);
        print.add(series.noise);
        print.add_all(series.time_s);
        print.add_all(series.values);
    }
    if (!trial.mount) return;
    for (const double t : trial.measured.time_s) {
        const model::MountPose pose = trial.mount->at(t);
        print.add_all(pose.place_m);
        print.add_all(pose.rotation);
    }
}

/// Hash of the body, recordings, loads, and declared parameters.
/// Start values and steps are part of the key of each fit instead, see fit_key().
std::uint64_t setup_fingerprint(const setup::Setup& setup) {
    Fingerprint print;
    const experiment::MaterialDeclaration& material = setup.experiment.material;
    for (const double number : {material.youngs_modulus_Pa, material.poissons_ratio, material.density_kg_m3,
                                material.damping_s.value_or(-1.0)})
        print.add(number);
    for (const double number : material.law) print.add(number);
    print.add_all(setup.experiment.gravity_m_s2);
    add_body(setup, print);
    if (!setup.trials.empty()) add_muscles(setup.trials.front().model, print);
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
        // As recorded: those of the model depend on the steps.
        for (const std::vector<fibre::Signal>* signals : {&trial.recorded_activation, &trial.recorded_commands})
            for (const fibre::Signal& signal : *signals) {
                print.add(signal.times_s.data(), static_cast<std::ptrdiff_t>(signal.times_s.size()));
                print.add(signal.values.data(), static_cast<std::ptrdiff_t>(signal.values.size()));
            }
        add_readings(trial, print);
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
