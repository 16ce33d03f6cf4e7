#include "check/catalogue.hpp"

#include <algorithm>
#include <iterator>

#include "check/checks.hpp"

namespace myo::check {

// Columns: id, task that remedies it, question, when, source of the threshold, function, the cause by which a violation
// explains a residual.
const std::vector<Check>& check_catalogue() {
    static const std::vector<Check> checks{
        {"units", "material", "Are the numbers in SI units?", CheckTime::before,
         "materials from gels and foams to plastics and metals", check_units, "the unit of a number"},
        {"time_unit", "measure", "Are the recordings' times in seconds?", CheckTime::before,
         "no body left to itself swings slower than its first vibration; cameras", check_time_unit,
         "the unit of the times"},
        {"mesh", "mesh", "Is the mesh fine enough to bend and to twist?", CheckTime::before,
         "errors of coarse meshes relative to fine ones", check_mesh, "a coarse mesh"},
        {"markers", "mesh", "Is the mesh fine enough for the markers?", CheckTime::before,
         "strains are linear within a cell", check_markers},
        {"support", "body", "Does the support hold the body?", CheckTime::before,
         "a body held on a line turns about it", check_support, "the support"},
        {"pose", "body", "Is the pose under gravity stable?", CheckTime::before,
         "linear buckling: the squared frequency falls to 0 in proportion to the load", check_pose,
         "the direction of gravity"},
        {"signals", "fibres", "Do the signals meet their trials?", CheckTime::before,
         "a signal in another clock or unit of time misses the trial", check_signals, "signals that miss their trial"},
        {"recordings", "measure", "Are the trials to predict others than those to fit?", CheckTime::before,
         "what was fitted is no test", check_recordings},
        {"step", "run", "Is the time step short enough?", CheckTime::both,
         "a modulus fitted on a vibration errs by twice the error of its frequency", check_step, "the time step"},
        {"start", "measure", "Does the model begin where the recording begins?", CheckTime::both,
         "5 noise levels and a twentieth of the motion", check_start, "the start of the recording"},
        {"inside_out", "run", "Do the cells keep their orientation?", CheckTime::after,
         "a Jacobian below 0 is no deformation", check_inside_out, "cells turned inside out"},
        {"tendon_legs", "fibres", "Do the tendons keep their lever arms between their guides?", CheckTime::after,
         "the mean lever arm of a leg in an arc changes by 10 %", check_tendon_legs, "the lever arms of the tendons"},
        {"bounds", "fit", "Did the fit end within its bounds?", CheckTime::after, "the declared ranges", check_bounds,
         "a value at its bound"},
        {"influence", "fit", "Do the data determine what is fitted?", CheckTime::after,
         "singular values of the Jacobian", check_influence},
        {"places", "measure", "Do the markers sit where they are declared?", CheckTime::after,
         "3 deviations of a place as declared", check_places, "the places of the markers"},
        {"residual", "diagnose", "Does the model explain the recordings?", CheckTime::after, "the noise of the markers",
         check_residual},
    };
    return checks;
}

const Check* find_check(const std::string& id) {
    const std::vector<Check>& all = check_catalogue();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Check& check) { return check.id == id; });
    return found != all.end() ? &*found : nullptr;
}

namespace {

/// Runs the checks in catalogue order; each sees the findings of those before it. Findings made before the job are
/// reused for checks that do not depend on its result.
std::vector<Finding> run_checks(CheckedJob job, const std::vector<Finding>& before) {
    std::vector<Finding> findings;
    job.earlier = &findings;
    for (const Check& check : check_catalogue()) {
        if (check.time == CheckTime::after && job.run == nullptr) continue;
        std::vector<Finding> own;
        // The result of a job cannot change these findings, and some of them cost seconds.
        if (check.time == CheckTime::before && !before.empty()) {
            std::copy_if(before.begin(), before.end(), std::back_inserter(own),
                         [&](const Finding& finding) { return finding.check == check.id; });
        } else {
            // Checks of both times run again after a job: they see its run in place of the declared start and steps.
            own = run_check(check, job);
        }
        findings.insert(findings.end(), own.begin(), own.end());
    }
    return findings;
}

}  // namespace

std::vector<Finding> run_check(const Check& check, const CheckedJob& job) {
    std::vector<Finding> findings = check.find(job);
    for (Finding& finding : findings) {
        finding.check = check.id;
        finding.source = check.source;
    }
    return findings;
}

std::vector<Finding> check_before(const setup::Setup& setup) { return run_checks({setup}, {}); }

std::vector<Finding> check_after(const CheckedJob& job, const std::vector<Finding>& before) {
    return run_checks(job, before);
}

}  // namespace myo::check
