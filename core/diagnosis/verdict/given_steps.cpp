#include "diagnosis/verdict/given_steps.hpp"

#include <limits>
#include <memory>
#include <utility>

#include "diagnosis/discretisation/effective_modulus.hpp"
#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "effect/catalogue.hpp"

namespace myo::diagnosis {
namespace {

/// Steps divided by a factor per trial. The limit of iterations, which is one per recording, grows with their number.
setup::Setup with_shorter_steps(setup::Setup setup, const std::vector<double>& factors) {
    for (std::size_t t = 0; t < factors.size(); ++t) {
        dynamics::SimulationOptions& options = setup.trials[t].options;
        options.h_s /= factors[t];
        const double most = factors[t] * options.max_iterations;
        options.max_iterations = most < std::numeric_limits<int>::max() ? static_cast<int>(most)
                                                                        : std::numeric_limits<int>::max();
    }
    return setup;
}

}  // namespace

bool needs_given_steps(const DiagnosisContext& context, const JudgedFit& fit) {
    return any_longer(context.step_factors) && effect::any_has_corner(fit.fit.effects);
}

FitWithSteps with_given_steps(DiagnosisContext context, JudgedFit fit) {
    Refinement& refinement = context.refinement;
    EffectiveModulus& modulus = refinement.unmatched.effective_modulus;
    // Its part of the step was found with the longer steps.
    modulus.step = modulus.finer_step = 0.0;
    scale_modulus(fit.fit, modulus.factor() / context.setup.modulus_factor);
    context.setup = with_shorter_steps(std::move(context.setup), context.step_factors);
    context.setup.modulus_factor = modulus.factor();
    if (refinement.finer)
        refinement.finer = std::make_shared<const setup::Setup>(
            with_shorter_steps(*refinement.finer, context.step_factors));
    context.step_factors.clear();
    fit.numerics.reset();
    // Derivatives and motions of the longer steps: vibrations that these did not resolve determine where a force acts.
    fit.fit.jacobian.resize(fit.fit.jacobian.rows(), 0);
    fit.fit.sensor_jacobian.resize(fit.fit.sensor_jacobian.rows(), 0);
    forget_paths(fit.fit.predictions);
    return {std::move(context), std::move(fit)};
}

}  // namespace myo::diagnosis
