#include "setup/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiment/read_experiment.hpp"
#include "measurement/actuation_csv.hpp"
#include "model/elastic_bed.hpp"
#include "model/tendon.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The series without samples that a column belongs to, in the order of the sensors.
std::vector<SensorSeries> all_columns(const experiment::Experiment& experiment) {
    using Kind = experiment::SensorKind;
    std::vector<SensorSeries> columns;
    for (std::size_t s = 0; s < experiment.sensors.size(); ++s) {
        const experiment::SensorDeclaration& sensor = experiment.sensors[s];
        const std::string unit = sensor.kind == Kind::chamber_volume      ? "m3"
                                 : sensor.kind == Kind::tendon_shortening ? "m"
                                                                          : "N";
        if (sensor.kind != Kind::reaction)
            columns.push_back({s, 0, sensor.name + "_" + unit, unit, sensor.noise, {}, {}});
        else
            for (int axis = 0; axis < 3; ++axis)
                columns.push_back(
                    {s, axis, sensor.name + "_" + std::string(1, "xyz"[axis]) + "_N", unit, sensor.noise, {}, {}});
    }
    return columns;
}

/// Values over the run at times of the samples, linear in between; NaN outside.
VectorXd interpolated(const std::vector<double>& time_s, const std::vector<double>& values, double first_s,
                      double last_s, const VectorXd& at_s) {
    VectorXd result = VectorXd::Constant(at_s.size(), std::numeric_limits<double>::quiet_NaN());
    for (Index i = 0; i < at_s.size(); ++i) {
        const double t = at_s[i];
        // The ends of the run count, whatever the rounding of sampled times. Up to them the first and last value
        // extend: reactions are known in the middle of steps only.
        if (!(t >= first_s - 1e-12 && t <= last_s + 1e-12)) continue;
        const auto above = static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), t) - time_s.begin());
        if (above == 0 || above == time_s.size()) {
            result[i] = above == 0 ? values.front() : values.back();
            continue;
        }
        const double w = (t - time_s[above - 1]) / (time_s[above] - time_s[above - 1]);
        result[i] = (1.0 - w) * values[above - 1] + w * values[above];
    }
    return result;
}

/// External force on the body but for that of its support, summed over the body.
Vector3d external_force(const model::Model& model, const model::MassMatrix& mass, const Matrix3Xd& x,
                        const Matrix3Xd& v, double t) {
    Vector3d sum = model::external_forces(model, mass, t).rowwise().sum() +
                   model.velocity_force_1_s * model::times_mass(v, mass).rowwise().sum();
    for (const model::ForceElementPointer& element : model.force_elements) {
        if (model::is_elastic_bed(*element)) continue;  // it is the support
        model::InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, x.cols());
        // Gradient of the potential, or of what stands for it: the force is its negative.
        element->add(*model.body, {x, &v, 0.0, t, false}, model::HessianKind::none, out);
        sum -= out.gradient.rowwise().sum();
    }
    return sum;
}

/// Component of the reaction over a run: at its start for a pose at rest, else in the middle of every step.
void reaction(const model::Model& model, const dynamics::Trace& trace, int axis, std::vector<double>& time_s,
              std::vector<double>& values) {
    const std::vector<model::MassSpan> masses = model::mass_spans(model);
    const auto mass_at = [&](double t) -> const model::MassMatrix& { return masses[model::span_at(masses, t)].mass; };
    const Matrix3Xd rest = Matrix3Xd::Zero(3, trace.positions.front().cols());
    // At rest the reaction balances all other external forces.
    if (trace.times_s.size() == 1) {
        time_s.push_back(trace.times_s[0]);
        const double t = trace.times_s[0];
        values.push_back(-external_force(model, mass_at(t), trace.positions[0], rest, t)[axis]);
        return;
    }
    for (std::size_t k = 0; k + 1 < trace.times_s.size(); ++k) {
        const double h = trace.times_s[k + 1] - trace.times_s[k];
        // Two states at one time have no rate of momentum.
        if (!(h > 0.0)) continue;
        const double middle = 0.5 * (trace.times_s[k] + trace.times_s[k + 1]);
        const Matrix3Xd x = 0.5 * (trace.positions[k] + trace.positions[k + 1]);
        const Matrix3Xd v = 0.5 * (trace.velocities[k] + trace.velocities[k + 1]);
        const Matrix3Xd change = trace.velocities[k + 1] - trace.velocities[k];
        const model::MassMatrix& mass = mass_at(middle);
        const Vector3d rate = model::times_mass(change, mass).rowwise().sum() / h;
        time_s.push_back(middle);
        values.push_back((rate - external_force(model, mass, x, v, middle))[axis]);
    }
}

}  // namespace

Result<std::vector<SensorSeries>> read_sensor_series(const experiment::Experiment& experiment,
                                                     const experiment::TrialDeclaration& trial, double start_s) {
    std::vector<SensorSeries> read;
    const std::vector<SensorSeries> columns = all_columns(experiment);
    const auto column = [&](const std::string& name) {
        return std::find_if(columns.begin(), columns.end(), [&](const SensorSeries& c) { return c.column == name; });
    };
    for (const auto& [name, value] : trial.sensor_values) {
        SensorSeries series = *column(name);
        series.time_s = VectorXd::Zero(1);
        series.values = VectorXd::Constant(1, value);
        read.push_back(std::move(series));
    }
    if (!trial.sensors) return read;
    const Result<measurement::ActuationTable> table = measurement::read_actuation_csv(*trial.sensors);
    if (!table) return table.error();
    for (std::size_t c = 0; c < table->muscles.size(); ++c) {
        const auto known = column(table->muscles[c]);
        if (known == columns.end())
            return Error{"column \"" + table->muscles[c] + "\" belongs to no declared [[sensor]]",
                         trial.sensors->string()};
        SensorSeries series = *known;
        series.time_s = table->time_s.array() - start_s;
        series.values = table->values.row(static_cast<Index>(c));
        // All samples of a hold measure one pose.
        if (trial.hold) {
            series.values = VectorXd::Constant(1, series.values.mean());
            series.time_s = VectorXd::Zero(1);
        }
        read.push_back(std::move(series));
    }
    return read;
}

VectorXd sensor_readings(const experiment::Experiment& experiment, const std::vector<Chamber>& chambers,
                         const SensorSeries& series, const model::Model& model, const dynamics::Trace& trace,
                         const VectorXd& at_s) {
    const experiment::SensorDeclaration& sensor = experiment.sensors[series.sensor];
    std::vector<double> time_s, values;
    if (sensor.kind == experiment::SensorKind::reaction) {
        reaction(model, trace, series.axis, time_s, values);
        return interpolated(time_s, values, trace.times_s.front(), trace.times_s.back(), at_s);
    }
    std::size_t place = 0;  // among chambers or tendons
    const auto named = [&](const auto& declared) {
        for (std::size_t i = 0; i < declared.size(); ++i)
            if (declared[i].name == sensor.of) place = i;
    };
    sensor.kind == experiment::SensorKind::chamber_volume ? named(experiment.chambers) : named(experiment.tendons);
    for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
        time_s.push_back(trace.times_s[k]);
        if (sensor.kind == experiment::SensorKind::chamber_volume) {
            values.push_back(chamber_volume(*model.body, chambers[place], trace.positions[k]));
            continue;
        }
        // Elements of chambers come first, then those of tendons.
        const model::ForceElement& tendon = *model.force_elements[experiment.chambers.size() + place];
        const model::TendonState state = model::tendon_state(
            tendon, {trace.positions[k], nullptr, 0.0, trace.times_s[k], false});
        values.push_back(sensor.kind == experiment::SensorKind::tendon_tension ? state.tension_N : state.shortening_m);
    }
    return interpolated(time_s, values, time_s.front(), time_s.back(), at_s);
}

}  // namespace myo::setup
