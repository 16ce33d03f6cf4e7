#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "effect/effect.hpp"

namespace myo::effect {
namespace base_vibration_parts {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

struct BaseVibrationPolicy {
    double probed_m = 1e-4;       // amplitude of a column; as little as cameras resolve
    std::size_t frequencies = 3;  // tried, those that stand out most in the residual
    double cycles = 2.0;          // within a trial, where the residual has no line
};
constexpr BaseVibrationPolicy base_vibration_policy;

/// Phase in a trial: a list has one per trial, and its first for trials that it does not reach.
double phase_in(const EffectParameters& parameters, std::size_t trial) {
    if (!has(parameters, "phase_rad")) return 0.0;
    const auto* const list = std::get_if<VectorXd>(&parameters.at("phase_rad"));
    if (!list) return number(parameters, "phase_rad");
    const auto i = static_cast<Eigen::Index>(trial);
    return list->size() == 0 ? 0.0 : (*list)(i < list->size() ? i : 0);
}

/// Adds a sinusoidal motion of the mount; the run sees it as inertia forces, the cameras as a motion of the clamp.
/// The pose of a hold is that of a body at rest.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    if (context.hold) return;
    affected.mount_vibrations.push_back(
        {number(parameters, "amplitude_m") * vector(parameters, "direction").normalized(),
         number(parameters, "frequency_Hz"), phase_in(parameters, context.number)});
}

/// Amplitudes of sine and cosine in each trial, 3 x 2 per trial. With one direction for all trials each is d (a, b);
/// the direction is the first principal one, the amplitude the root mean square over the trials.
EffectParameters joined(const std::vector<EffectParameters>& columns, const VectorXd& multiples) {
    std::map<std::size_t, Eigen::Matrix<double, 3, 2>> of_trial;
    std::size_t trials = 1;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        // The length of the list of phases says of which trial a column is, see probes().
        const auto& only = std::get<VectorXd>(columns[i].at("phase_rad"));
        const std::size_t trial = static_cast<std::size_t>(only.size()) - 1;
        trials = std::max(trials, trial + 1);
        auto& sum = of_trial.try_emplace(trial, Eigen::Matrix<double, 3, 2>::Zero()).first->second;
        sum.col(only(only.size() - 1) == 0.0 ? 0 : 1) += multiples(static_cast<Eigen::Index>(i)) *
                                                         number(columns[i], "amplitude_m") *
                                                         vector(columns[i], "direction");
    }
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    // Sum of squares over trials and phases: its first principal axis is the best common direction.
    for (const auto& [trial, sum] : of_trial) moments += sum * sum.transpose();
    const Vector3d d = Eigen::JacobiSVD<Eigen::Matrix3d>(moments, Eigen::ComputeFullU).matrixU().col(0);
    double squares = 0.0;
    VectorXd phases = VectorXd::Zero(static_cast<Eigen::Index>(trials));
    for (const auto& [trial, sum] : of_trial) {
        const Eigen::Vector2d along = sum.transpose() * d;
        squares += along.squaredNorm() / static_cast<double>(of_trial.size());
        phases(static_cast<Eigen::Index>(trial)) = std::atan2(along.y(), along.x());
    }
    // An amplitude of exactly 0 would be the absent value, from which a fit over decades cannot start.
    EffectParameters result{{"amplitude_m", std::max(std::sqrt(squares), 0.01 * base_vibration_policy.probed_m)},
                            {"frequency_Hz", number(columns.front(), "frequency_Hz")},
                            {"direction", VectorXd(d)}};
    if (of_trial.size() == 1)
        result["phase_rad"] = phases(static_cast<Eigen::Index>(of_trial.begin()->first));
    else
        result["phase_rad"] = phases;
    return result;
}

/// Six columns per trial and frequency: three directions, in phase with the sine and a quarter turn ahead.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const auto moving = std::find_if(search.trials.begin(), search.trials.end(),
                                     [](const TrialContext& trial) { return !trial.hold; });
    if (moving == search.trials.end()) return {};
    std::vector<double> frequencies = search.residual_lines_Hz;
    frequencies.resize(std::min(frequencies.size(), base_vibration_policy.frequencies));
    if (frequencies.empty()) {
        const double end_s = moving->end_s;
        frequencies.push_back(base_vibration_policy.cycles / (end_s > 0.0 ? end_s : 1.0));
    }
    std::vector<EffectProbe> list;
    for (const double frequency : frequencies) {
        EffectProbe& probe = list.emplace_back();
        for (const TrialContext& trial : search.trials) {
            if (trial.hold) continue;
            for (int axis = 0; axis < 3; ++axis)
                for (const double phase : {0.0, 0.5 * pi}) {
                    // The last entry is that of the trial, which joined() reads.
                    VectorXd phases = VectorXd::Zero(static_cast<Eigen::Index>(trial.number) + 1);
                    phases(phases.size() - 1) = phase;
                    EffectParameters column{{"amplitude_m", base_vibration_policy.probed_m},
                                            {"frequency_Hz", frequency},
                                            {"direction", VectorXd(Vector3d::Unit(axis))},
                                            {"phase_rad", phases}};
                    if (search.trials.size() > 1) column["trial"] = trial.trial;
                    probe.columns.push_back(std::move(column));
                }
        }
        probe.joined = joined;
    }
    return list;
}

/// Direction with a positive largest component, phases within half a turn of zero.
EffectParameters one_form(EffectParameters parameters) {
    Vector3d d = vector(parameters, "direction").normalized();
    Eigen::Index largest = 0;
    d.cwiseAbs().maxCoeff(&largest);
    const double turn = d(largest) < 0.0 ? pi : 0.0;
    if (turn > 0.0) d = -d;
    parameters["direction"] = VectorXd(d);
    const auto wrapped = [&](double phase) { return std::remainder(phase + turn, 2.0 * pi); };
    if (!has(parameters, "phase_rad")) {
        if (turn > 0.0) parameters["phase_rad"] = wrapped(0.0);
        return parameters;
    }
    if (auto* const list = std::get_if<VectorXd>(&parameters.at("phase_rad")))
        *list = list->unaryExpr(wrapped).eval();
    else
        parameters["phase_rad"] = wrapped(number(parameters, "phase_rad"));
    return parameters;
}

/// d and -d with the phase turned by pi are one vibration.
EffectParameters canonical(const model::Model&, const EffectParameters& parameters) { return one_form(parameters); }

EffectParameters comparable(const EffectParameters& parameters) {
    EffectParameters result = one_form(parameters);
    // Phases differ between trials and say nothing about the mount: amplitude, frequency and direction are compared.
    result.erase("phase_rad");
    return result;
}

/// Frequencies about those of soft bodies [Hz].
EffectParameters drawn(const DrawContext&, RandomStream& random) {
    return {{"frequency_Hz", random.uniform(1.0, 15.0)},
            {"direction", VectorXd(drawn_direction(random))},
            {"phase_rad", random.uniform(-pi, pi)}};
}

}  // namespace base_vibration_parts

Effect base_vibration() {
    using namespace base_vibration_parts;
    return {.id = "base_vibration",
            .kind = EffectKind::support,
            .summary = "the mount vibrates along a line, the cameras stand still",
            .parameters = {fitted_number("amplitude_m", 0.0, 1.0, 1e-3, true),
                           fitted_number("frequency_Hz", 0.0, 1e4, 1.0),
                           {"direction", EffectParameterKind::direction, false, -pi, pi, 0.3},
                           {"phase_rad", EffectParameterKind::number_or_list, true, -1e3, 1e3, 0.5}},
            .apply = apply,
            .probes = probes,
            .canonical = canonical,
            .comparable = comparable,
            .draw = {.amount = "amplitude_m", .lowest = 1e-4, .highest = 5e-3, .others = drawn}};
}

}  // namespace myo::effect
