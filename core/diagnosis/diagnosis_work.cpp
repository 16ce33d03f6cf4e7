#include "diagnosis/diagnosis_work.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/fingerprint.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Hash of what a fit depends on apart from mesh and steps: recordings, loads, and declared parameters.
std::uint64_t fingerprint(const setup::Setup& setup) {
    Fingerprint print;
    const experiment::MaterialDeclaration& material = setup.experiment.material;
    for (const double number : {material.youngs_modulus_Pa, material.poissons_ratio, material.density_kg_m3,
                                material.damping_s.value_or(-1.0)})
        print.add(number);
    for (const double number : material.law) print.add(number);
    print.add_all(setup.experiment.gravity_m_s2);
    print.add_all(setup.noise_m);
    for (const setup::PreparedTrial& trial : setup.trials) {
        print.add_all(trial.measured.time_s);
        for (const Eigen::Matrix3Xd& track : trial.measured.tracks) print.add_all(track);
        for (const model::AttachedMass& mass : trial.model.masses) print.add(mass.mass_kg);
        for (const model::DeadForce& force : trial.model.forces) {
            print.add_all(force.force_N);
            print.add(force.from_s);
            print.add(force.until_s);
        }
        for (const fibre::Signal& signal : trial.model.activation)
            print.add(signal.values.data(), static_cast<std::ptrdiff_t>(signal.values.size()));
    }
    return print.value();
}

std::string setup_words(const setup::Setup& setup) {
    return setup.experiment.name + ", " + to_string(setup.body->kind) + " " +
           std::to_string(setup.mesh.mesh.node_count()) + " nodes, " + to_string(setup.settings.integrator) + ", " +
           std::to_string(fingerprint(setup));
}

setup::Setup prepared(setup::Setup setup) {
    for (setup::PreparedTrial& trial : setup.trials) {
        trial.options.solver.tolerance = std::max(diagnosis_policy.numerics.solver_tolerance,
                                                  trial.options.solver.tolerance);
        trial.options.solver.tangent_tolerance = std::max(diagnosis_policy.numerics.tangent_tolerance,
                                                          trial.options.solver.tangent_tolerance);
    }
    return prediction::with_kept_paths(std::move(setup));
}

setup::Setup on_one_thread(setup::Setup setup) {
    setup.settings.threads = 1;
    return setup;
}

}  // namespace

DiagnosisWork::DiagnosisWork(const setup::Setup& as_declared, const DiagnoseSettings& settings, const Progress& told,
                             const std::function<void(const Diagnosis&)>& shown)
    : setup(prepared(for_candidates(as_declared, settings))),
      serial(on_one_thread(setup)),
      progress(told),
      live(shown),
      store(settings.fits ? std::make_unique<FitStore>(*settings.fits, setup_words(setup))
                          : std::make_unique<FitStore>()),
      errors(setup, settings.refine_mesh) {
    result.settings = settings;
}

bool DiagnosisWork::allowed(const std::string& effect) const { return may_be_named(result.settings, effect); }

std::vector<std::size_t> DiagnosisWork::all_trials() const {
    std::vector<std::size_t> all(setup.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

void DiagnosisWork::show() const {
    if (live) live(result);
}

StageCost& DiagnosisWork::cost_of(const std::string& stage) {
    const auto same = std::find_if(result.cost.begin(), result.cost.end(),
                                   [&](const StageCost& cost) { return cost.stage == stage; });
    return same != result.cost.end() ? *same : result.cost.emplace_back(StageCost{stage, 0.0, 0});
}

JointFit DiagnosisWork::fit(const std::string& name, const prediction::ParameterValues& start, const Effort& effort,
                            const Neighbourhood& known) {
    JointFit found = stage(name, 0, [&] {
        return stored_fit(*store, setup, result.data, start, EffectFreedom::all, effort, known, progress);
    });
    cost_of(name).runs += found.runs(fit_count());
    return found;
}

std::vector<JudgedFit> DiagnosisWork::fit_all(const std::string& name, const JointFit& base,
                                              const std::vector<CandidateStart>& starts, double least_so_far,
                                              double pruning_factor) {
    CandidateFits found = stage(name, 0, [&] {
        return fit_candidates({setup, serial, result.data, result.settings, *store}, base, starts, least_so_far,
                              pruning_factor, name, progress);
    });
    cost_of(name).runs += found.runs;
    return std::move(found.fits);
}

}  // namespace myo::diagnosis
