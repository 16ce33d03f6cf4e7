#include <cassert>
#include <cmath>
#include <limits>

#include "base/markup.hpp"
#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "results/calibration_report.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/output_json.hpp"
#include "results/readable_parameter.hpp"
#include "results/robot_tables.hpp"

namespace myo::diagnosis {
namespace {

// Shown as a dash.
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

void add_columns(report::Table& table, const std::vector<report::Column>& columns) {
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
}

/// Word for whether a test fires.
std::string yes(bool fired) { return fired ? "yes" : "no"; }

/// Two cells with value and deviation of a parameter; dashes if the fit does not have it.
std::vector<report::Cell> estimate_cells(const JointFit& fit, const prediction::ModelParameter& wanted,
                                         const results::ReadableParameter& shown) {
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        if (fit.parameters[i].parameter.name != wanted.parameter.name) continue;
        const auto row = static_cast<Eigen::Index>(i);
        const double deviation = row < fit.report.deviations.size() ? fit.report.deviations(row) : no_value;
        const results::ReadableEstimate estimate = results::readable_estimate(
            shown.factor * prediction::value_of(fit.parameters[i], fit.values), shown.factor * deviation);
        return {estimate.value, estimate.deviation.empty() ? "–" : estimate.deviation};
    }
    return {"–", "–"};
}

/// Errors of each marker in one trial, in mm and in noise levels.
/// @param before, after  scores of the trial; null: it was not run
report::Table marker_table(const Diagnosis& d, const setup::Setup& setup, const prediction::TrialScore* before,
                           const prediction::TrialScore* after) {
    report::Table table{
        "",
        {{"Marker"}, {"Before", "mm", 3}, {"After", "mm", 3}, {"Before", "× noise", 3}, {"After", "× noise", 3}},
        {}};
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
        const double b = before != nullptr ? before->markers[m].rms_m : no_value,
                     a = after != nullptr ? after->markers[m].rms_m : no_value;
        const double noise = setup.noise_m(static_cast<Eigen::Index>(m));
        if (has_two_fits(d))
            table.rows.push_back({setup.marker_names[m], 1e3 * b, 1e3 * a, b / noise, a / noise});
        else
            table.rows.push_back({setup.marker_names[m], 1e3 * b, b / noise});
    }
    if (!has_two_fits(d)) table.columns = {{"Marker"}, {"Error", "mm", 3}, {"Error", "× noise", 3}};
    return table;
}

/// Row of the table of candidates.
/// @param explained  share of the squared residual, 0 ... 1; NaN: not scored
/// @param fit        null: not fitted
std::vector<report::Cell> candidate_row(const setup::Setup& setup, const std::string& name, double explained, double p,
                                        const JudgedFit* fit) {
    std::vector<report::Cell> row{name, 100.0 * explained, p_words(p)};
    if (fit == nullptr)
        row.insert(row.end(), {"not fitted", no_value, no_value, no_value, no_value});
    else
        row.insert(row.end(), {fitted_words(setup, fit->fit), 1e3 * fit->rms_m, fit->held_out_rms,
                               fit->tests.systematic.rms, fit->weight});
    return row;
}

}  // namespace

report::Section parameter_section(const setup::Setup& setup, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    report::Table table{"", {{"Parameter"}, {"Unit"}, {"Declared model"}, {"±"}}, {}};
    if (two) add_columns(table, {report::Column{"With the effect"}, report::Column{"±"}});
    // The fit of the verdict has all parameters of the declared one, and those of its effects.
    const std::vector<prediction::ModelParameter>& all = two ? d.augmented.fit.parameters : d.declared.fit.parameters;
    for (const prediction::ModelParameter& p : all) {
        const results::ReadableParameter shown = results::readable_parameter(p, setup);
        std::vector<report::Cell> row{shown.name, shown.unit.empty() ? "1" : shown.unit};
        for (const JudgedFit* fit : {&d.declared, &d.augmented}) {
            if (fit == &d.augmented && !two) break;
            for (report::Cell& cell : estimate_cells(fit->fit, p, shown)) row.push_back(std::move(cell));
        }
        table.rows.push_back(std::move(row));
    }
    const char* const words =
        "± is one standard deviation, from what the fit leaves, its correlation in time, and the doubt in the "
        "removed errors of mesh and step. It does not cover what the model leaves out.";
    if (table.rows.empty())
        return {"Parameters",
                {report::Paragraph{"The experiment declares all parameters as known: nothing was fitted."}}};
    return {"Parameters", {table, report::Paragraph{words}}};
}

report::Section error_section(const setup::Setup& setup, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    report::Table table{"",
                        {{"Trial"},
                         {"Role"},
                         {"Before", "mm", 3},
                         {"After", "mm", 3},
                         {"Before", "× noise", 3},
                         {"After", "× noise", 3}},
                        {}};
    if (!two) table.columns = {{"Trial"}, {"Role"}, {"Error", "mm", 3}, {"Error", "× noise", 3}};
    report::Details markers{"Errors of each marker", {}};
    for (const setup::PreparedTrial& trial : setup.trials) {
        const prediction::TrialScore* const before = results::find_score(d.before, trial.name);
        const prediction::TrialScore* const after = results::find_score(d.after, trial.name);
        const double b = before != nullptr ? before->rms_m : no_value, a = after != nullptr ? after->rms_m : no_value;
        if (two)
            table.rows.push_back({trial.name, result_word(trial.role), 1e3 * b, 1e3 * a, b / d.noise_m, a / d.noise_m});
        else
            table.rows.push_back({trial.name, result_word(trial.role), 1e3 * b, b / d.noise_m});
        report::Table by_marker = marker_table(d, setup, before, after);
        by_marker.caption = trial.name;
        markers.blocks.push_back(std::move(by_marker));
    }
    const std::string words =
        std::string(
            "Root mean square over all marker coordinates, simulation against measurement; what the mesh and the step "
            "add is taken off. Trials marked “predicted” were not used in any fit or choice.") +
        (two ? " Before: the declared model, fitted. After: " + after_words(d) + "." : "");
    report::Section section{"Errors", {report::Paragraph{words}, table, markers}};
    if (report::Table sensors = results::sensor_table(setup, d.before, two ? &d.after : nullptr); !sensors.rows.empty())
        section.blocks.emplace_back(std::move(sensors));
    return section;
}

report::Section significance_section(const setup::Setup&, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    report::Table table{"", {{"Test"}, {"Asks"}, {"p before"}, {"Fires"}}, {}};
    if (two) add_columns(table, {report::Column{"p after"}, report::Column{"Fires"}});
    const auto add = [&](const std::string& name, const std::string& question, const auto& p) {
        std::vector<report::Cell> row{name, question, p_words(p(d.declared.tests)),
                                      yes(p(d.declared.tests) < d.declared.tests.threshold)};
        if (two)
            row.insert(row.end(),
                       {p_words(p(d.augmented.tests)), yes(p(d.augmented.tests) < d.augmented.tests.threshold)});
        table.rows.push_back(std::move(row));
    };
    add("Variance", "more than the noise?", [](const statistics::ResidualTests& t) { return t.variance.p; });
    add("Ljung–Box", "is it autocorrelated?", [](const statistics::ResidualTests& t) { return t.ljung_box.p; });
    add("Periodicity", "is there a dominant frequency?",
        [](const statistics::ResidualTests& t) { return t.periodicity.p; });
    add("Space", "do the markers move together?", [](const statistics::ResidualTests& t) { return t.space.p; });
    const auto systematic = [](const statistics::ResidualTests& t) {
        return readable_number(t.systematic.rms, 3) +
               (std::isfinite(t.systematic.deviation) ? " ± " + readable_number(t.systematic.deviation, 2) : "");
    };
    std::string words = "A test fires where noise alone would give its sign with a probability p below " +
                        p_words(d.declared.tests.threshold) + ", so that all four together are wrong in " +
                        readable_number(100.0 * d.settings.alpha, 2) + " % of all cases. Of the residual, " +
                        systematic(d.declared.tests) + " times the noise is systematic before";
    if (two) words += ", " + systematic(d.augmented.tests) + " after";
    words += "; up to " + readable_number(numerical_allowance(d.data, d.numerics, d.settings.policy.judgement), 2) +
             " is attributed to numerical error.";
    if (d.declared.drifts() || (two && d.augmented.drifts()))
        words +=
            std::string(" What is systematic ") + (d.declared.drifts() ? "" : "after ") +
            "is uncorrelated between markers: courses shifted in time against each other make as strong a pattern. "
            "The test of space fires only because of their autocorrelation.";
    return {"Is there anything to explain?", {table, report::Paragraph{words}}};
}

report::Section numerics_section(const setup::Setup& setup, const Diagnosis& d) {
    const NumericalError& n = d.numerics;
    report::Table table{
        "", {{"Source"}, {"Method"}, {"Change of the prediction", "mm", 3}, {"In units of the noise", "", 3}}, {}};
    const auto add = [&](const std::string& suspect, const std::string& how, double rms_m) {
        table.rows.push_back({suspect, how, 1e3 * rms_m, rms_m / d.noise_m});
    };
    const std::string step = steps_in_words(setup, d.step_factors);
    add("Numerical damping, time step",
        n.step_ratio > 0.0 ? "steps of " + step + " times " + readable_number(n.step_ratio, 2) : "steps of " + step,
        n.step_ratio > 0.0 ? n.step_rms_m : no_value);
    add("Discretisation",
        n.mesh_ratio > 0.0 ? "cells of " + readable_number(n.mesh_ratio, 2) + " times the edge"
                           : "no finer mesh was made",
        n.mesh_ratio > 0.0 ? n.mesh_rms_m : no_value);
    if (n.effective_modulus.any())
        add("Remainder of both",
            "with cells of " + readable_number(n.effective_modulus.factor(), 4) + " times the body's modulus",
            n.rest_rms_m);
    add("Uncertainty of the extrapolation", "share of both that is uncertain", n.left_rms_m);
    report::Section section{
        "Numerical errors",
        {report::Paragraph{"Share of the residual that numerical errors cause. Both errors "
                           "are extrapolated and removed from the predictions. Coarse cells bend as if of another "
                           "modulus: where this matters, an effective modulus is used first."},
         table}};
    section.blocks.push_back(report::Paragraph{"The time scheme adds a damping ratio of " +
                                               readable_number(n.numerical_damping, 2) + " to the first vibration."});
    if (!n.message.empty()) section.blocks.push_back(report::WarningBox{{n.message}});
    return section;
}

report::Section candidate_section(const setup::Setup& setup, const Diagnosis& d) {
    const std::vector<report::Column> columns{{"Effect"},
                                              {"Explains", "%", 3},
                                              {"p"},
                                              {"Fitted value"},
                                              {"Error", "mm", 3},
                                              {"Held out", "× noise", 3},
                                              {"Systematic", "× noise", 3},
                                              {"Weight", "", 3}};
    report::Table table{"", columns, {}}, others{"", columns, {}}, sets{"", columns, {}};
    table.rows.push_back(candidate_row(setup, "(declared model)", no_value, no_value, &d.declared));
    table.rows.back()[3] = "";
    for (const Candidate& c : d.candidates) {
        const bool usable = c.score.usable();
        report::Table& where = table.rows.size() <= diagnosis_report_policy.candidates && (usable || c.judged) ? table
                                                                                                               : others;
        where.rows.push_back(candidate_row(setup, results::effect_name(c.score.id),
                                           usable ? c.score.test.explained : no_value, usable ? c.adjusted_p : no_value,
                                           c.judged ? &*c.judged : nullptr));
        if (!c.score.failure.empty())
            where.rows.back()[3] = c.score.failure;
        else if (!usable)
            where.rows.back()[3] = "no influence";
    }
    report::Section section{
        "Candidates",
        {report::Paragraph{
             "Score of each effect of the catalogue: the share of the residual that it could remove, after "
             "what the declared parameters can absorb; p is the probability of as much by chance, "
             "corrected for all that were tried. The best were fitted together with the declared "
             "parameters. “Held out” is the error on blocks of data that the fit did not see; "
             "the weights of all fits add up to one."},
         table}};
    if (!others.rows.empty()) {
        // Only the first four columns are shown here; the fourth holds the reason.
        for (std::vector<report::Cell>& row : others.rows) row.resize(4, report::Cell(""));
        others.columns.resize(4);
        others.columns[3].title = "Remark";
        section.blocks.push_back(report::Details{"Effects that explain little or none", {others}});
    }
    for (const JudgedFit& set : d.sets) {
        sets.rows.push_back(
            candidate_row(setup, results::effect_name(names_of(set.fit.effects)), no_value, no_value, &set));
        // Sets have no score of their own: columns 1 and 2, share and p, are left out.
        sets.rows.back().erase(sets.rows.back().begin() + 1, sets.rows.back().begin() + 3);
    }
    sets.columns.erase(sets.columns.begin() + 1, sets.columns.begin() + 3);
    sets.columns[0].title = "Set";
    if (!sets.rows.empty())
        section.blocks.insert(
            section.blocks.end(),
            {report::Paragraph{"One effect left a residual, so further ones were fitted with it, and exchanged."},
             sets});
    return section;
}

report::Section confusion_section(const Diagnosis& d) {
    assert(!d.confusions.empty());
    report::Table table{
        "",
        {{"Effect"}, {"Similar to"}, {"Cosine", "", 4}, {"Do these data decide?"}, {"What would separate them"}},
        {}};
    for (const Confusion& c : d.confusions)
        table.rows.push_back({results::effect_name(c.first), results::effect_name(c.second), c.cosine,
                              is_decided(d, c) ? "yes, by the fits" : "no", c.next_experiment});
    return {
        "Confounded effects",
        {report::Paragraph{
             "These effects leave nearly the same trace in these trials: a cosine of 1 or −1 between what they do to "
             "the residual means that no fit can decide. Near it a fit decides by little, where the noise is small."},
         table}};
}

report::Section cost_section(const Diagnosis& d) {
    report::Table table{"", {{"Phase"}, {"Time", "s", 3}, {"Runs of a trial", "", 6}}, {}};
    int runs = 0;
    for (const PhaseCost& cost : d.cost) {
        table.rows.push_back({cost.phase, cost.seconds, cost.runs});
        runs += cost.runs;
    }
    table.rows.push_back({"all", d.seconds, runs});
    return {"Cost", {table}};
}

}  // namespace myo::diagnosis
