#include "experiment/read_trial.hpp"
#include "model/model.hpp"
#include "setup/parts.hpp"
#include "setup/setup.hpp"

// What a fit changes in the model of a trial: values of the materials and levels of the muscles.

namespace myo::setup {

void set_materials(const Setup& setup, const MaterialValues& values, double factor, model::Model& model) {
    const experiment::Experiment& experiment = setup.experiment;
    model.damping_s = values.damping_s;
    // Without parts all cells have one material.
    if (setup.part_shares.size() == 0) {
        model.moduli = model::uniform_moduli(setup.body->cell_count(), factor * values.youngs_modulus_Pa,
                                             experiment.material.poissons_ratio);
        return;
    }
    model.moduli = mixed_moduli(experiment, setup.part_shares, values, factor);
    model.damping_excess_s = damping_excess(experiment, setup.part_shares, values);
}

std::vector<fibre::Signal> with_level(const experiment::Experiment& experiment, std::vector<fibre::Signal> activation,
                                      std::size_t leader, double level) {
    const std::vector<experiment::MuscleLeader> leaders = experiment::muscle_leaders(experiment);
    for (std::size_t m = 0; m < leaders.size(); ++m)
        if (leaders[m].leader == leader)
            // Followers are linear in a - 1, see MuscleLeader.
            activation[m] = fibre::Signal::step(0.0, 1.0, 1.0 + leaders[m].factor * (level - 1.0));
    return activation;
}

void declare_activation(const experiment::Experiment& experiment, std::vector<fibre::Signal>& activation) {
    const std::vector<experiment::MuscleLeader> leaders = experiment::muscle_leaders(experiment);
    for (std::size_t m = 0; m < leaders.size(); ++m) {
        const std::optional<fibre::Signal>& signal = experiment.muscles[leaders[m].leader].signal;
        if (!signal) continue;
        // Followers of a declared signal follow it as well, whatever was recorded for their leader.
        activation[m] = *signal;
        for (double& a : activation[m].values) a = 1.0 + leaders[m].factor * (a - 1.0);
    }
}

std::vector<fibre::Signal> level_tangent(const experiment::Experiment& experiment, std::size_t leader) {
    std::vector<fibre::Signal> tangent;
    for (const experiment::MuscleLeader& muscle : experiment::muscle_leaders(experiment))
        tangent.push_back(fibre::Signal::step(0.0, 0.0, muscle.leader == leader ? muscle.factor : 0.0));
    return tangent;
}

}  // namespace myo::setup
