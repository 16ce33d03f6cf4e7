#pragma once

#include <Eigen/Core>

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/simulate.hpp"
#include "measurement/marker_binding.hpp"
#include "measurement/observation_error.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::effect {

/// Number, vector, one name (marker, trial) or several (marker_swap's two markers).
using EffectParameter = std::variant<double, Eigen::VectorXd, std::string, std::vector<std::string>>;
/// By name. Vectors and positions are in the mesh frame, at rest.
using EffectParameters = std::map<std::string, EffectParameter>;

/// An effect with its parameters: what an experiment declares, or what is tried on it.
struct EffectDeclaration {
    std::string id;
    EffectParameters parameters;
    bool calibrate = false;
};

enum class EffectParameterKind {
    number,
    vector3,            // position or shift
    direction,          // unit vector: two angles for a fit, see direction.hpp; the scale is in rad
    number_or_vector3,  // a size, or one with its direction
    axis,               // 0 x, 1 y, 2 z
    marker,
    marker_pair,
    trial,
};

/// What a parameter may hold, and how a fit moves it.
struct EffectParameterEntry {
    std::string name;  // with the unit
    EffectParameterKind kind = EffectParameterKind::number;
    bool optional = false;
    double lowest = -std::numeric_limits<double>::max();  // of a number, bounds included
    double highest = std::numeric_limits<double>::max();
    double scale = 0.0;         // a change of this size matters: width of the prior. 0: a fit does not move it
    bool over_decades = false;  // positive, of unknown order of magnitude: a fit moves its logarithm from `scale` on
};

/// What an effect may know of the trial that it acts on.
struct EffectSite {
    model::BodyPointer body;  // as declared; its clamped nodes are the declared ones
    Box held;                 // the clamp
    std::vector<std::string> marker_names;
    std::vector<Eigen::Vector3d> marker_rest_m;
    std::vector<measurement::MarkerBinding> markers;  // on the body's cells
    std::vector<std::string> muscle_names;
    std::string trial;
    double session_time_s = 0.0;
    dynamics::StartKind start = dynamics::StartKind::straight;
    double interval_s = 0.01;  // between samples
    double end_s = 0.0;        // of the trial
};

/// What an effect may change: the model, how it starts, and how it is seen.
struct Affected {
    model::Model model;
    dynamics::SimulationOptions options;
    measurement::ObservationError seen;
};

/// Places and sizes from which a search for the effect starts.
///
/// columns: variants of the effect with small, but finite values, whose predictions less the unaffected ones span what
/// the effect does to first order: several where it has a direction. `joined` makes one effect of the multiples of the
/// columns that explain a residual best; null with one column: its parameter `amount` times the multiple, or divided by
/// it where absence is infinite.
struct EffectProbe {
    std::vector<EffectParameters> columns;
    std::string amount;
    bool reciprocal = false;
    EffectParameters (*joined)(const std::vector<EffectParameters>& columns,
                               const Eigen::VectorXd& multiples) = nullptr;
    bool large = false;  // of an amount far from small, for what goes with its square: tried where small ones explain
                         // nothing
};

/// What the search for an effect may know of the whole experiment.
struct EffectSearch {
    std::vector<EffectSite> sites;             // of the fit trials
    std::vector<model::Model> models;          // theirs, with the values of the declared fit
    double largest_energy_density_J_m3 = 0.0;  // isochoric, of any cell in any trial
    bool damping_is_fitted = false;
};

enum class EffectStage { force, support, material, actuation, measurement };
std::string to_string(EffectStage stage);

/// An entry of the catalogue.
struct Effect {
    std::string id;
    EffectStage stage = EffectStage::force;
    std::string summary;  // one line for a person
    std::vector<EffectParameterEntry> parameters;
    void (*apply)(const EffectSite&, const EffectParameters&, Affected&) = nullptr;
    std::vector<EffectProbe> (*probes)(const EffectSearch&) = nullptr;  // empty: it cannot show in this experiment
    EffectParameters (*plainest)(const model::Model& declared, const EffectParameters&) =
        nullptr;                       // the same effect, where several numbers say the same; may be null
    bool varies_within_cells = false;  // fields of moduli, energies beyond strain squared: see fine_element()

    const EffectParameterEntry* parameter(const std::string& name) const;
};

/// A parameter's number; of a number_or_vector3 given as a vector its length.
double number(const EffectParameters& parameters, const std::string& name);
Eigen::Vector3d vector(const EffectParameters& parameters, const std::string& name);
std::string text(const EffectParameters& parameters, const std::string& name);
bool has(const EffectParameters& parameters, const std::string& name);
/// Whether an effect with an optional parameter `trial` acts on this one.
bool acts_on(const EffectSite& site, const EffectParameters& parameters);

/// A probe of one number.
EffectProbe probe(EffectParameters at, const std::string& amount);

/// An entry for a number within bounds; see EffectParameterEntry.
EffectParameterEntry fitted_number(const std::string& name, double lowest, double highest, double scale,
                                   bool over_decades = false);

}  // namespace myo::effect
