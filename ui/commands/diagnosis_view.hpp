#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/check_view.hpp"
#include "commands/settings.hpp"

// What a person sees of a diagnosis: plain values, copied from it by the backend. Some of it while it still runs.

namespace myo::ui::commands {

/// A force over the body in one trial, added up in patches of nodes.
struct PatchForces {
    Eigen::VectorXd time_s;                 // T
    std::vector<Eigen::Matrix3Xd> force_N;  // per time, 3 x patches
    double largest_N = 0.0;                 // length of the longest, of all times
};

/// What is to be plotted besides residuals: the courses of a force.
struct ForceCourses {
    std::string trial;
    Eigen::VectorXd time_s;
    std::vector<std::string> names;  // "1: at the free end, along +y"
    std::vector<Eigen::VectorXd> amplitude_N;
};

/// The declared model, an effect beside it (or several), or the force that is missing where none explains.
struct DiagnosisRow {
    enum class Kind { declared, effects, missing_force };

    Kind kind = Kind::effects;
    std::string key;          // ids, as "quadratic_drag+clamp_slip"; does not change while the ranking does
    std::string name;         // "Quadratic drag"
    std::string value;        // "coefficient 903 ± 12 kg/m³"; of what was not fitted why
    std::string brief;        // "903 ± 12 kg/m³" of one number, "5 values" of several; empty: as value
    bool one_number = false;  // brief says all that value does, but for the parameter's name
    std::string like;         // names of effects that this experiment cannot tell from it; may be empty
    double explained = std::numeric_limits<double>::quiet_NaN();  // share of the residual, before any fit
    double rms_m = std::numeric_limits<double>::quiet_NaN();      // over the fit trials
    double held_out = std::numeric_limits<double>::quiet_NaN();   // rms in units of the noise, of data that the fit did
                                                                  // not see
    double weight = std::numeric_limits<double>::quiet_NaN();     // share of the evidence among all fits
    bool fitted = false;
    bool chosen = false;  // the verdict stands on it
    std::vector<std::vector<Eigen::Matrix3Xd>>
        predicted_m;              // [trial][marker] 3 x T: change of the prediction by it; empty, NaN: unknown
    std::vector<double> after_m;  // per trial: rms with it; NaN: not predicted
    std::vector<std::shared_ptr<const PatchForces>> force;  // per trial; null: none
    std::string no_force;                                   // why there is none
    Settings settings;  // of the fit, with the effects in: what "add to the model" takes over
};

struct DiagnosisTrial {
    std::string name;
    bool fitted = true;  // else predicted only
    std::vector<Eigen::Matrix3Xd>
        residual_m;  // per marker 3 x T: measured less declared model, NaN where not compared; empty: unknown yet
    double before_m = std::numeric_limits<double>::quiet_NaN();  // rms of the declared model
};

enum class DiagnosisVerdict { none, effects, unknown };

struct DiagnosisView {
    bool complete = false;  // there is a verdict; else what is known so far
    bool stopped = false;   // by the user, before it had one
    DiagnosisVerdict verdict = DiagnosisVerdict::unknown;
    std::string headline;  // "Quadratic drag is missing: coefficient 903 ± 12 kg/m³"
    double confidence = 0.0;
    std::string because;                  // one or two sentences
    std::vector<std::string> confounded;  // "Not to be told apart here: quadratic drag and linear drag (cosine 0.98); a
                                          // slower release would separate them."
    std::vector<std::string> alike;       // "Alike here, but the fits decide: ..."
    std::vector<std::string> notes;
    double noise_m = 0.0;  // rms that a right model would leave
    double seconds = 0.0;
    std::vector<DiagnosisTrial> trials;  // of the scene, in its order
    std::vector<DiagnosisRow> rows;      // the declared model, then by falling credibility
    ForceCourses missing_force;
    Eigen::VectorXi patch_of_node;  // n nodes of the body that was diagnosed; empty before there are forces
    int patches = 0;
    CheckRows checks;                                       // of the experiment as diagnosed; empty before a verdict
    std::shared_ptr<const void> page;                       // about it, for the report: the backend's own; may be null
    int worst_trial = 0, worst_marker = 0, worst_axis = 0;  // where the declared model is furthest off

    /// The row with this key, or null.
    const DiagnosisRow* row(const std::string& key) const {
        for (const DiagnosisRow& each : rows)
            if (each.key == key) return &each;
        return nullptr;
    }
};

}  // namespace myo::ui::commands
