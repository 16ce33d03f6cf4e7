#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/check_view.hpp"
#include "commands/settings.hpp"

// Data of a diagnosis as it is shown: plain values, copied from the core's result by the backend. A running diagnosis
// publishes incomplete ones.

namespace myo::ui::commands {

/// A force distribution over the body in one trial, summed over patches of nodes.
struct PatchForces {
    Eigen::VectorXd time_s;                 // T times [s], ascending
    std::vector<Eigen::Matrix3Xd> force_N;  // per time, 3 x patches
    double largest_N = 0.0;                 // largest length of all patches and times
};

/// Time courses of the missing force, for its plot.
struct ForceCourses {
    std::string trial;  // name of the trial
    Eigen::VectorXd time_s;
    std::vector<std::string> names;            // of the courses: "1: at the free end, along +y"
    std::vector<Eigen::VectorXd> amplitude_N;  // per course, at time_s
};

/// One row of the ranking: the declared model, the model with one effect (or several), or the missing force if no
/// effect explains the residual.
struct DiagnosisRow {
    enum class Kind { declared, effects, missing_force };

    Kind kind = Kind::effects;
    std::string key;          // ids, such as "quadratic_drag+clamp_slip"; stays the same while the ranking changes
    std::string name;         // "Quadratic drag"
    std::string value;        // fitted value "coefficient 903 ± 12 kg/m³"; if it was not fitted, the reason
    std::string brief;        // shorter: "903 ± 12 kg/m³", or "5 values"; empty: as value
    bool one_number = false;  // brief says the same as value, except for the parameter's name
    std::string like;         // names of effects that this experiment cannot distinguish from it; may be empty
    double explained = std::numeric_limits<double>::quiet_NaN();  // share of the residual, before any fit
    double rms_m = std::numeric_limits<double>::quiet_NaN();      // over the fit trials
    // rms on data that the fit did not use, in units of the noise
    double held_out = std::numeric_limits<double>::quiet_NaN();
    double weight = std::numeric_limits<double>::quiet_NaN();  // share of the evidence among all fits
    bool fitted = false;                                       // fitted together with the declared parameters
    bool chosen = false;                                       // the verdict is based on this row
    // [trial][marker] 3 x T [m]: change of the prediction by this row; empty or NaN: unknown
    std::vector<std::vector<Eigen::Matrix3Xd>> predicted_m;
    std::vector<double> after_m;                            // per trial: rms with this row; NaN: not predicted
    std::vector<std::shared_ptr<const PatchForces>> force;  // per trial; null: none
    std::string no_force;                                   // reason for missing forces, as shown
    Settings settings;  // settings of the fit including the effects; "Add to the model" takes them over
};

/// Residual of the declared model in one trial.
struct DiagnosisTrial {
    std::string name;
    bool fitted = true;  // otherwise predicted only
    // Per marker 3 x T: measured - declared model; NaN where they are not compared; empty: not known yet.
    std::vector<Eigen::Matrix3Xd> residual_m;
    double before_m = std::numeric_limits<double>::quiet_NaN();  // rms of the declared model
};

/// Kind of verdict: nothing is missing, effects are missing, or something is missing that no effect explains.
enum class DiagnosisVerdict { none, effects, unknown };

/// A diagnosis as it is shown. Replaced as a whole whenever a running diagnosis publishes more.
struct DiagnosisView {
    bool complete = false;  // there is a verdict; otherwise what is known so far
    bool stopped = false;   // cancelled by the user before there was a verdict
    DiagnosisVerdict verdict = DiagnosisVerdict::unknown;
    std::string headline;                 // "Quadratic drag is missing: coefficient 903 ± 12 kg/m³"
    double confidence = 0.0;              // of the verdict, 0 to 1
    std::string because;                  // reason for the verdict in one or two sentences
    std::vector<std::string> confounded;  // pairs of effects that this experiment cannot distinguish, in words
    std::vector<std::string> alike;       // similar effects between which the fits decide, in words
    std::vector<std::string> notes;       // further remarks
    double noise_m = 0.0;                 // rms that a correct model would leave
    double seconds = 0.0;                 // wall time
    std::vector<DiagnosisTrial> trials;   // in the scene's order
    std::vector<DiagnosisRow> rows;       // the declared model, then by decreasing credibility
    ForceCourses missing_force;           // may be empty
    Eigen::VectorXi patch_of_node;        // per node of the diagnosed body; empty before there are forces
    int patches = 0;                      // number of patches
    CheckRows checks;                     // of the diagnosed experiment; empty before there is a verdict
    std::shared_ptr<const void> page;     // page for the report, owned by the backend; may be null
    int worst_trial = 0, worst_marker = 0, worst_axis = 0;  // where the declared model has its largest error

    /// The row of the verdict; null if it names none.
    const DiagnosisRow* chosen_row() const {
        for (const DiagnosisRow& each : rows)
            if (each.chosen) return &each;
        return nullptr;
    }
    /// The row with this key; null if there is none.
    const DiagnosisRow* row(const std::string& key) const {
        for (const DiagnosisRow& each : rows)
            if (each.key == key) return &each;
        return nullptr;
    }
};

}  // namespace myo::ui::commands
