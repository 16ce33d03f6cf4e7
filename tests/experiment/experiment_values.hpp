#pragma once

#include <optional>
#include <string>
#include <variant>

#include "base/result.hpp"
#include "experiment/read_trial.hpp"
#include "fibre/painted_mask.hpp"
#include "support/value_lines.hpp"

namespace myo::test {

/// Adds the numbers and words of an experiment, with its recordings, as read from its files. Keys are those of the file
/// where there is one. Files are named without their folder, and warnings are left out.
class ExperimentValues {
public:
    ExperimentValues(std::string name, const experiment::Experiment& e, ValueLines& lines)
        : e_(e), name_(std::move(name)), lines_(lines) {}

    void add() const {
        put("name", e_.name);
        put("description", e_.description);
        add_body();
        add_markers();
        for (std::size_t i = 0; i < e_.muscles.size(); ++i) add_muscle(item("muscle", i), e_.muscles[i]);
        for (std::size_t i = 0; i < e_.trials.size(); ++i) add_trial(item("trial", i), e_.trials[i]);
        for (std::size_t i = 0; i < e_.effects.size(); ++i) add_effect(item("effect", i), e_.effects[i]);
    }

private:
    template <class Value>
    void put(const std::string& key, const Value& value) const {
        lines_.add(name_ + "." + key, value);
    }
    template <class Value>
    void put(const std::string& key, const std::optional<Value>& value) const {
        if (value) put(key, *value);
    }
    void put_box(const std::string& key, const Box& box) const {
        put(key + ".lowest", box.lowest);
        put(key + ".highest", box.highest);
    }
    static std::string item(const std::string& table, std::size_t i) { return table + "[" + std::to_string(i) + "]"; }
    static std::string file_name(const std::filesystem::path& file) { return file.filename().string(); }

    void add_body() const {
        if (const auto* const box = std::get_if<experiment::BoxGeometry>(&e_.geometry)) {
            put("geometry.size_m", box->size_m);
            put("geometry.origin_m", box->origin_m);
        } else {
            const auto& stl = std::get<experiment::StlGeometry>(e_.geometry);
            put("geometry.file", file_name(stl.file));
            put("geometry.metres_per_unit", stl.metres_per_unit);
            put("geometry.rotation", stl.rotation);
        }
        put_box("clamp.box_m", e_.clamp_box_m);
        const experiment::MaterialDeclaration& m = e_.material;
        put("material.model", m.model);
        put("material.youngs_modulus_Pa", m.youngs_modulus_Pa);
        put("material.youngs_modulus_tolerance", m.youngs_modulus_tolerance);
        put("material.poissons_ratio", m.poissons_ratio);
        put("material.density_kg_m3", m.density_kg_m3);
        put("material.damping_s", m.damping_s);
        put("material.calibrate", m.calibrate);
        put("environment.gravity_m_s2", e_.gravity_m_s2);
    }

    void add_markers() const {
        put("registration.known", e_.registration.known);
        put("registration.rest_pose", e_.registration.method == experiment::RegistrationMethod::rest_pose);
        put("registration.max_translation_m", e_.registration.max_translation_m);
        put("registration.max_rotation_deg", e_.registration.max_rotation_deg);
        put("markers.noise_m", e_.markers.noise_m);
        put("markers.max_standoff_m", e_.markers.max_standoff_m);
        put("markers.displacement", e_.markers.compare == experiment::Comparison::displacement);
        for (const auto& marker : e_.markers.on_body) {
            put("markers.rest_m." + marker.name, marker.rest_m);
            put("markers.labels." + marker.name, marker.label);
        }
        for (const auto& marker : e_.markers.fixed) put("markers.fixed_m." + marker.name, marker.rest_m);
    }

    void add_muscle(const std::string& key, const experiment::MuscleDeclaration& m) const {
        put(key + ".name", m.name);
        put(key + ".stiffness_Pa", m.stiffness_Pa);
        if (const auto* const box = std::get_if<experiment::MuscleBox>(&m.part)) {
            put_box(key + ".box_m", box->box_m);
            put(key + ".fibre", box->fibre);
        } else if (const auto* const line = std::get_if<experiment::MuscleLine>(&m.part)) {
            put(key + ".line_m", line->line.points_m);
            put(key + ".radius_m", line->radius_m);
        } else {
            const auto& mask = std::get<experiment::MuscleMask>(m.part);
            const auto& file = std::get<std::filesystem::path>(mask.painted);
            put(key + ".mask", file_name(file));
            put(key + ".fibre", mask.fibre);
            add_mask(key + ".mask", *fibre::read_painted_mask(file));
        }
        if (m.follows) put(key + ".follows.muscle", m.follows->muscle);
        if (m.follows) put(key + ".follows.ratio", m.follows->ratio);
        if (m.signal) put(key + ".signal.time_s", m.signal->times_s);
        if (m.signal) put(key + ".signal.a", m.signal->values);
    }

    void add_mask(const std::string& key, const fibre::PaintedMask& mask) const {
        put(key + ".cell_size_m", mask.cell_size_m);
        put(key + ".centroids_m", mask.centroids_m);
        put(key + ".weights", mask.weights);
        put(key + ".directions", mask.directions);
    }

    void add_trial(const std::string& key, const experiment::TrialDeclaration& t) const {
        put(key + ".name", t.name);
        put(key + ".fit", t.role == experiment::TrialRole::fit);
        put(key + ".trace", file_name(t.trace));
        put(key + ".straight", t.start == experiment::StartState::straight);
        put(key + ".session_time_s", t.session_time_s);
        put(key + ".start_s", t.start_s);
        put(key + ".end_s", t.end_s);
        for (const auto& step : t.actuation_steps) {
            const std::string step_key = key + ".actuation_step." + step.muscle;
            if (step.level)
                put(step_key, *step.level);
            else
                put(step_key, "free");
        }
        for (const auto& [name, value] : t.condition) put(key + ".condition." + name, value);
        for (std::size_t i = 0; i < t.loads.size(); ++i) add_load(key + "." + item("load", i), t.loads[i]);
        add_recording(key, t);
    }

    void add_load(const std::string& key, const experiment::LoadDeclaration& load) const {
        put(key + ".is_mass", load.kind == experiment::LoadKind::mass);
        put_box(key + ".box_m", load.box_m);
        put(key + ".mass_kg", load.mass_kg);
        put(key + ".force_N", load.force_N);
        put(key + ".from_s", load.from_s);
        put(key + ".until_s", load.until_s);
    }

    void add_recording(const std::string& key, const experiment::TrialDeclaration& t) const {
        const Result<measurement::Recording> recording = experiment::read_trial_recording(e_, t);
        if (!recording) return put(key + ".recording", recording.error().text());
        put(key + ".recording.labels", recording->labels);
        put(key + ".recording.time_s", recording->time_s);
        for (std::size_t i = 0; i < recording->tracks.size(); ++i)
            put(key + ".recording." + recording->labels[i], recording->tracks[i].rightCols(2));
        const Result<measurement::ActuationTable> actuation = experiment::read_trial_actuation(e_, t);
        if (!actuation) return put(key + ".actuation", actuation.error().text());
        put(key + ".actuation.time_s", actuation->time_s);
        put(key + ".actuation.a", actuation->values);
    }

    void add_effect(const std::string& key, const effect::EffectDeclaration& effect) const {
        put(key + ".id", effect.id);
        put(key + ".calibrate", effect.calibrate);
        for (const auto& [name, value] : effect.parameters) put(key + "." + name, value);
    }

    const experiment::Experiment& e_;
    std::string name_;
    ValueLines& lines_;
};

}  // namespace myo::test
