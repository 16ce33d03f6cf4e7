#include <cassert>
#include <cmath>
#include <limits>

#include "loop/confusion.hpp"
#include "loop/diagnosis_report_parts.hpp"
#include "loop/judge.hpp"
#include "loop/longer_steps.hpp"
#include "project/output_json.hpp"
#include "project/readable_parameter.hpp"
#include "project/study_report.hpp"
#include "project/study_report_parts.hpp"
#include "report/markup.hpp"

namespace myo {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t shown_candidates = 12;

void add_columns(Table& table, const std::vector<Column>& columns) { table.columns.insert(table.columns.end(), columns.begin(), columns.end()); }

std::string yes(bool fired) { return fired ? "yes" : "no"; }

/// Value and deviation of a parameter in a fit, as two cells; dashes where the fit does not have it.
std::vector<Cell> estimate_cells(const JointFit& fit, const StudyParameter& wanted, const ReadableParameter& shown) {
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        if (fit.parameters[i].parameter.name != wanted.parameter.name) continue;
        const auto row = static_cast<Eigen::Index>(i);
        const double deviation = row < fit.report.deviations.size() ? fit.report.deviations(row) : no_value;
        const ReadableEstimate estimate = readable_estimate(shown.factor * value_of(fit.parameters[i], fit.values), shown.factor * deviation);
        return {estimate.value, estimate.deviation.empty() ? "–" : estimate.deviation};
    }
    return {"–", "–"};
}

Table marker_table(const Diagnosis& d, const Study& study, const TrialScore* before, const TrialScore* after) {
    Table table{"", {{"Marker"}, {"Before", "mm", 3}, {"After", "mm", 3}, {"Before", "× noise", 3}, {"After", "× noise", 3}}, {}};
    for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
        const double b = before != nullptr ? before->markers[m].rms_m : no_value, a = after != nullptr ? after->markers[m].rms_m : no_value;
        const double noise = study.noise_m(static_cast<Eigen::Index>(m));
        if (has_two_fits(d)) table.rows.push_back({study.marker_names[m], 1e3 * b, 1e3 * a, b / noise, a / noise});
        else table.rows.push_back({study.marker_names[m], 1e3 * b, b / noise});
    }
    if (!has_two_fits(d)) table.columns = {{"Marker"}, {"Error", "mm", 3}, {"Error", "× noise", 3}};
    return table;
}

std::vector<Cell> candidate_row(const Study& study, const std::string& name, double explained, double p, const JudgedFit* fit) {
    std::vector<Cell> row{name, 100.0 * explained, p_words(p)};
    if (fit == nullptr) row.insert(row.end(), {"not fitted", no_value, no_value, no_value, no_value});
    else row.insert(row.end(), {fitted_words(study, fit->fit), 1e3 * fit->rms_m, fit->held_out_rms, fit->tests.systematic.rms, fit->weight});
    return row;
}

}  // namespace

Section parameter_section(const Study& study, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    Table table{"", {{"Parameter"}, {"Unit"}, {"Declared model"}, {"±"}}, {}};
    if (two) add_columns(table, {Column{"With the effect"}, Column{"±"}});
    const std::vector<StudyParameter>& all = two ? d.augmented.fit.parameters : d.declared.fit.parameters;
    for (const StudyParameter& p : all) {
        const ReadableParameter shown = readable_parameter(p, study);
        std::vector<Cell> row{shown.name, shown.unit.empty() ? "1" : shown.unit};
        for (const JudgedFit* fit : {&d.declared, &d.augmented}) {
            if (fit == &d.augmented && !two) break;
            for (Cell& cell : estimate_cells(fit->fit, p, shown)) row.push_back(std::move(cell));
        }
        table.rows.push_back(std::move(row));
    }
    const char* const words = "± is one standard deviation, from what the fit leaves. It does not cover what the model leaves out.";
    if (table.rows.empty()) return {"Parameters", {Paragraph{"The experiment declares all parameters as known: nothing was fitted."}}};
    return {"Parameters", {table, Paragraph{words}}};
}

Section error_section(const Study& study, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    Table table{"", {{"Trial"}, {"Role"}, {"Before", "mm", 3}, {"After", "mm", 3}, {"Before", "× noise", 3}, {"After", "× noise", 3}}, {}};
    if (!two) table.columns = {{"Trial"}, {"Role"}, {"Error", "mm", 3}, {"Error", "× noise", 3}};
    Details markers{"Errors of each marker", {}};
    for (const StudyTrial& trial : study.trials) {
        const TrialScore* const before = find_score(d.before, trial.name);
        const TrialScore* const after = find_score(d.after, trial.name);
        const double b = before != nullptr ? before->rms_m : no_value, a = after != nullptr ? after->rms_m : no_value;
        if (two) table.rows.push_back({trial.name, role_words(trial.role), 1e3 * b, 1e3 * a, b / d.noise_m, a / d.noise_m});
        else table.rows.push_back({trial.name, role_words(trial.role), 1e3 * b, b / d.noise_m});
        Table by_marker = marker_table(d, study, before, after);
        by_marker.caption = trial.name;
        markers.blocks.push_back(std::move(by_marker));
    }
    const std::string words = std::string("Root mean square over all marker coordinates, simulation against measurement; what the mesh and the step add is taken off. Trials marked “predicted” took no part in any fit or choice.") +
                              (two ? " Before: the declared model, fitted. After: " + after_words(d) + "." : "");
    return {"Errors", {Paragraph{words}, table, markers}};
}

Section significance_section(const Study&, const Diagnosis& d) {
    const bool two = has_two_fits(d);
    Table table{"", {{"Test"}, {"Asks"}, {"p before"}, {"Fires"}}, {}};
    if (two) add_columns(table, {Column{"p after"}, Column{"Fires"}});
    const auto add = [&](const std::string& name, const std::string& question, const auto& p) {
        std::vector<Cell> row{name, question, p_words(p(d.declared.tests)), yes(p(d.declared.tests) < d.declared.tests.threshold)};
        if (two) row.insert(row.end(), {p_words(p(d.augmented.tests)), yes(p(d.augmented.tests) < d.augmented.tests.threshold)});
        table.rows.push_back(std::move(row));
    };
    add("Variance", "more than the noise?", [](const ResidualTests& t) { return t.variance.p; });
    add("Ljung–Box", "does it remember?", [](const ResidualTests& t) { return t.ljung_box.p; });
    add("Periodicity", "does one frequency stand out?", [](const ResidualTests& t) { return t.periodicity.p; });
    add("Space", "do the markers move together?", [](const ResidualTests& t) { return t.space.p; });
    const auto systematic = [](const ResidualTests& t) {
        return readable_number(t.systematic.rms, 3) + (std::isfinite(t.systematic.deviation) ? " ± " + readable_number(t.systematic.deviation, 2) : "");
    };
    std::string words = "A test fires where noise alone would give its sign with a probability p below " + p_words(d.declared.tests.threshold) + ", so that all four together are wrong in " +
                        readable_number(100.0 * d.settings.alpha, 2) + " % of all cases. Of what is left, " + systematic(d.declared.tests) + " times the noise is systematic before";
    if (two) words += ", " + systematic(d.augmented.tests) + " after";
    words += "; up to " + readable_number(numerical_allowance(d.data, d.numerics), 2) + " is put down to the program itself.";
    if (d.declared.wanders() || (two && d.augmented.wanders()))
        words += std::string(" What is systematic ") + (d.declared.wanders() ? "" : "after ") + "is each marker's own: shifted in time against each other, their courses make as strong a pattern. Only because they remember does the test of space fire.";
    return {"Is there anything to explain?", {table, Paragraph{words}}};
}

Section numerics_section(const Study& study, const Diagnosis& d) {
    const NumericalError& n = d.numerics;
    Table table{"", {{"Suspect"}, {"How it was tried"}, {"Moves the prediction", "mm", 3}, {"In units of the noise", "", 3}}, {}};
    const auto add = [&](const std::string& suspect, const std::string& how, double rms_m) { table.rows.push_back({suspect, how, 1e3 * rms_m, rms_m / d.noise_m}); };
    const std::string step = steps_in_words(study, d.step_factors);
    add("Numerical damping, time step", n.step_ratio > 0.0 ? "steps of " + step + " times " + readable_number(n.step_ratio, 2) : "steps of " + step, n.step_ratio > 0.0 ? n.step_rms_m : no_value);
    add("Discretisation", n.mesh_ratio > 0.0 ? "cells of " + readable_number(n.mesh_ratio, 2) + " times the edge" : "no finer mesh was made", n.mesh_ratio > 0.0 ? n.mesh_rms_m : no_value);
    if (n.stiffening.any()) add("What is left of both", "with cells of " + readable_number(n.stiffening.factor(), 4) + " times the body's modulus", n.rest_rms_m);
    add("What extrapolation may leave", "share of both that is uncertain", n.left_rms_m);
    Section section{"Suspects ruled out", {Paragraph{"Before nature is blamed: how much of the residual the program makes itself. Both errors are extrapolated and taken off the predictions. Coarse cells bend as if of another modulus: where that is much, they get the modulus that makes up for it first."}, table}};
    section.blocks.push_back(Paragraph{"The time scheme adds a damping ratio of " + readable_number(n.numerical_damping, 2) + " to the first vibration."});
    if (!n.message.empty()) section.blocks.push_back(WarningBox{{n.message}});
    return section;
}

Section candidate_section(const Study& study, const Diagnosis& d) {
    const std::vector<Column> columns{{"Effect"},           {"Explains", "%", 3},    {"p"},          {"Fitted value"}, {"Error", "mm", 3},
                                      {"Held out", "× noise", 3}, {"Systematic", "× noise", 3}, {"Weight", "", 3}};
    Table table{"", columns, {}}, others{"", columns, {}}, pairs{"", columns, {}};
    table.rows.push_back(candidate_row(study, "(declared model)", no_value, no_value, &d.declared));
    table.rows.back()[3] = "";
    for (const Candidate& c : d.candidates) {
        const bool usable = c.score.usable();
        Table& where = table.rows.size() <= shown_candidates && (usable || c.judged) ? table : others;
        where.rows.push_back(candidate_row(study, effect_name(c.score.id), usable ? c.score.test.explained : no_value, usable ? c.adjusted_p : no_value, c.judged ? &*c.judged : nullptr));
        if (!c.score.failure.empty()) where.rows.back()[3] = c.score.failure;
        else if (!usable) where.rows.back()[3] = "does nothing here";
    }
    Section section{"Candidates", {Paragraph{"Each effect of the catalogue was asked how much of the residual it could take away, after what the declared parameters can absorb; p is the probability of as much by chance, "
                                             "corrected for all that were asked. The best were fitted together with the declared parameters. “Held out” is the error on blocks of data that the fit did not see; "
                                             "the weights of all fits add up to one."},
                                   table}};
    if (!others.rows.empty()) {
        for (std::vector<Cell>& row : others.rows) row.resize(4, Cell(""));
        others.columns.resize(4);
        others.columns[3].title = "Remark";
        section.blocks.push_back(Details{"Effects that explain little or nothing", {others}});
    }
    for (const JudgedFit& pair : d.pairs) {
        pairs.rows.push_back(candidate_row(study, effect_name(names_of(pair.fit.effects)), no_value, no_value, &pair));
        pairs.rows.back().erase(pairs.rows.back().begin() + 1, pairs.rows.back().begin() + 3);
    }
    pairs.columns.erase(pairs.columns.begin() + 1, pairs.columns.begin() + 3);
    pairs.columns[0].title = "Pair";
    if (!pairs.rows.empty()) section.blocks.insert(section.blocks.end(), {Paragraph{"One effect left something, so a second one was fitted beside the best."}, pairs});
    return section;
}

Section confusion_section(const Diagnosis& d) {
    assert(!d.confusions.empty());
    Table table{"", {{"Effect"}, {"Looks like"}, {"Cosine", "", 4}, {"Do these data decide?"}, {"What would tell them apart"}}, {}};
    for (const Confusion& c : d.confusions) table.rows.push_back({effect_name(c.first), effect_name(c.second), c.cosine, is_decided(d, c) ? "yes, by the fits" : "no", c.next_experiment});
    return {"What looks alike in this experiment",
            {Paragraph{"These effects leave nearly the same trace in these trials: a cosine of 1 or −1 between what they do to the residual means that no fit can decide. Near it a fit decides by little, where the noise is small."}, table}};
}

Section cost_section(const Diagnosis& d) {
    Table table{"", {{"Stage"}, {"Time", "s", 3}, {"Runs of a trial", "", 6}}, {}};
    int runs = 0;
    for (const StageCost& cost : d.cost) {
        table.rows.push_back({cost.stage, cost.seconds, cost.runs});
        runs += cost.runs;
    }
    table.rows.push_back({"all", d.seconds, runs});
    return {"Cost", {table}};
}

}  // namespace myo
