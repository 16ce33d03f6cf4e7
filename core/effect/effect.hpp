#pragma once

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/simulate.hpp"
#include "effect/effect_declaration.hpp"
#include "effect/effect_draw.hpp"
#include "measurement/marker_binding.hpp"
#include "measurement/observation_error.hpp"
#include "mesh/surface_mesh.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::effect {

// An effect is a phenomenon that a declared experiment does not contain: a force, a support, a property of material or
// actuator, or an error of the measurement. Each entry of the catalogue states its parameters and a function that
// applies it to the prepared trial. Effects are used in two ways: an experiment declares them, or a diagnosis tries
// them on the residual of a fit. In the second case the probes of an entry are the start values.

/// Type of a parameter.
enum class EffectParameterKind {
    number,
    vector3,            // position or shift
    direction,          // unit vector; fitted as two angles (direction.hpp), so that its scale is in rad
    number_or_vector3,  // a magnitude, or a vector
    number_or_list,     // a number for all trials, or one per trial
    axis,               // 0 x, 1 y, 2 z
    marker,
    marker_pair,
    trial,
    actuator,  // name of a muscle, chamber or tendon
};

/// Declaration of a parameter: type, range and how it is fitted.
struct EffectParameterEntry {
    std::string name;  // with its unit, e.g. mass_kg
    EffectParameterKind kind = EffectParameterKind::number;
    bool optional = false;
    double lowest = -std::numeric_limits<double>::max();  // range of a number, bounds included
    double highest = std::numeric_limits<double>::max();
    double scale = 0.0;         // a change of this size matters: width of the prior [unit of the name]; 0: not fitted
    bool over_decades = false;  // positive with unknown order of magnitude: ln(1 + value / scale) is fitted
    /// In the unit of the signals that it acts on: range and scale are those for muscles, whose unit is 1.
    bool of_signal = false;
};

/// Data of the trial on which an effect acts.
/// Constant while effects are applied: later effects see the body as declared, not as earlier ones changed it.
struct TrialContext {
    model::BodyPointer body;  // as declared, with the declared clamped nodes
    Box held;                 // clamped box
    std::vector<std::string> marker_names;
    std::vector<Eigen::Vector3d> marker_rest_m;       // rest positions [m], mesh frame
    std::vector<measurement::MarkerBinding> markers;  // bound to the cells of the body
    std::vector<std::string> actuator_names;          // muscles, chambers, tendons
    std::string trial;
    std::size_t number = 0;                     // of the trial in the experiment
    double session_time_s = 0.0;                // time of the trial within the session
    std::map<std::string, double> condition{};  // test conditions of the trial, by name
    dynamics::StartKind start = dynamics::StartKind::straight;
    double interval_s = 0.01;  // between samples of the recording
    double end_s = 0.0;        // end of the trial
    bool hold = false;         // at rest all along: statics
};

/// What an effect may change: model, start and options of the run, the motion of the mount, and the recording.
/// Effects are applied one after the other, so that each finds what the earlier ones have changed.
struct Affected {
    model::Model model;
    dynamics::SimulationOptions options;
    measurement::ObservationError observation_error;
    model::MountMotionPointer recorded_mount = {};          // by the time stamps of the recording; null: at rest
    std::vector<model::MountVibration> mount_vibrations{};  // added to it, by the clock of the simulation
};

/// Start values for the search for an effect.
///
/// `columns` are variants of the effect with small finite values. Their predictions minus the prediction without the
/// effect span its first-order response; several columns are needed if the effect has a direction. `joined` converts
/// the multiples of the columns that best explain a residual into one effect. It is null for a single column: then the
/// parameter `amount` is multiplied by the multiple, or divided by it (`reciprocal`) if absence means infinity.
struct EffectProbe {
    std::vector<EffectParameters> columns;
    std::string amount;
    bool reciprocal = false;
    EffectParameters (*joined)(const std::vector<EffectParameters>& columns,
                               const Eigen::VectorXd& multiples) = nullptr;
    bool large = false;  // an amount that is not small, for quadratic responses; tried if small ones explain nothing
};

/// Data of the whole experiment for the choice of start values.
struct EffectSearch {
    std::vector<TrialContext> trials;          // of the trials used in the fit
    std::vector<model::Model> models;          // models of these trials, with the values of the declared fit
    double largest_energy_density_J_m3 = 0.0;  // isochoric; maximum over cells and trials
    bool damping_is_fitted = false;
    std::vector<double> residual_lines_Hz{};  // frequencies that stand out in the residual of the fit, strongest first
};

/// What an effect changes; effects are applied in this order.
enum class EffectKind { force, support, material, actuation, measurement };
/// Name of an EffectKind in files and reports.
std::string to_string(EffectKind kind);

/// Events of single markers. A scan of the residuals over markers and times finds them; they have no probes.
enum class MarkerEvent {
    none,
    swap,  // parameters markers, time_s, trial
    slip,  // parameters marker, shift_m, time_s, trial
};

/// Entry of the catalogue. Whatever the program knows about a particular effect is stated here, so that no other file
/// names it.
struct Effect {
    std::string id{};
    EffectKind kind = EffectKind::force;
    std::string summary{};  // one line for the user
    std::vector<EffectParameterEntry> parameters{};
    /// Changes the model, options or recording of a trial.
    std::function<void(const TrialContext&, const EffectParameters&, Affected&)> apply = nullptr;
    /// Start values of a search; an empty list: not observable in this experiment; null: no probes exist.
    std::function<std::vector<EffectProbe>(const EffectSearch&)> probes = nullptr;
    /// Derivative by a number of the effect, where it has a closed form: a component of a parameter, or -1 of a plain
    /// one, in the model that apply() has changed and others may have; empty: it has none. Null: no number has one.
    std::function<std::optional<sensitivity::ModelTangent>(const EffectParameters&, const std::string& parameter,
                                                           int component, const Affected&)>
        tangent = nullptr;
    /// Canonical form of equivalent parameters; null: every value has one form.
    EffectParameters (*canonical)(const model::Model& declared, const EffectParameters&) = nullptr;
    /// Form in which equivalent parameters are equal without knowing the model, for errors of estimates; null: as they
    /// are.
    EffectParameters (*comparable)(const EffectParameters&) = nullptr;
    /// Moduli that vary within cells, or energies beyond quadratic: see fine_element().
    bool varies_within_cells = false;
    /// Its force has a corner, at a speed or a distance of zero: errors of mesh and step follow no order.
    bool has_corner = false;
    /// Parameter that is a length which the cells must resolve; empty: none.
    std::string resolved_length{};
    /// Parameter by which the clamp is shorter, so that a mesh can conform to the clamp's end instead; empty: none.
    std::string clamp_shortening{};
    /// Test conditions that every trial must state.
    std::vector<std::string> conditions{};
    MarkerEvent marker_event = MarkerEvent::none;
    EffectDraw draw{};

    /// Declaration of a parameter; null if there is none of this name.
    const EffectParameterEntry* parameter(const std::string& name) const;
};

/// Value of a number; the norm of a number_or_vector3 that is given as a vector. The parameter must exist.
/// Errors: a missing parameter or one of another type throws (std::out_of_range, std::bad_variant_access).
double number(const EffectParameters& parameters, const std::string& name);
/// Value of a vector3 or direction. The parameter must exist.
Eigen::Vector3d vector(const EffectParameters& parameters, const std::string& name);
/// Value of a name. The parameter must exist.
std::string text(const EffectParameters& parameters, const std::string& name);
/// Whether the parameter is given.
bool has(const EffectParameters& parameters, const std::string& name);
/// Whether the effect acts on this trial: it has no parameter `trial`, or it names this one.
bool acts_on(const TrialContext& context, const EffectParameters& parameters);

/// Names in results of the numbers by which fits move a parameter: one of a number, one per component of a vector or
/// list, two of a direction. Empty: the parameter is absent, or has no scale.
///
/// @param parameter  of the entry of the effect
/// @return           "effect.quadratic_drag.coefficient_kg_m3", "effect.point_mass.position_m.x",
///                   "effect.gravity_tilt.axis.turn_1_rad"
std::vector<std::string> fitted_names(const EffectDeclaration& effect, const EffectParameterEntry& parameter);

/// Probe with a single column whose parameter `amount` is multiplied.
EffectProbe probe(EffectParameters at, const std::string& amount);

/// Declaration of a required, fitted number; see EffectParameterEntry.
/// @param lowest, highest, scale  in the unit that the name ends in
EffectParameterEntry fitted_number(const std::string& name, double lowest, double highest, double scale,
                                   bool over_decades = false);

}  // namespace myo::effect
