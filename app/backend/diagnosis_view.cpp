#include "backend/diagnosis_view.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <limits>

#include "backend/effect_settings.hpp"
#include "backend/law_settings.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "diagnosis/missing_force/effect_forces.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "results/output_json.hpp"
#include "results/readable_parameter.hpp"

namespace myo::backend {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr const char* declared_key = "declared";
constexpr const char* missing_force_key = "missing force";
constexpr int about_patches = 48, about_moments = 48;  // force patches on the body, and times per trial
constexpr std::size_t max_with_forces = 8;

std::string capitalised(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

/// Key of a row from the ids of its effects: "a+b".
std::string key_of(const std::vector<effect::EffectDeclaration>& effects) {
    std::vector<std::string> ids;
    for (const effect::EffectDeclaration& effect : effects) ids.push_back(effect.id);
    std::sort(ids.begin(), ids.end());  // the order of a set does not matter
    return join(ids, "+");
}

/// A flat residual vector [m] on the samples of the trials: [trial][marker] 3 x T, NaN elsewhere; trials without
/// samples stay empty.
std::vector<std::vector<Matrix3Xd>> on_samples(const setup::Setup& setup, const diagnosis::FitData& data,
                                               const VectorXd& flat_m) {
    std::vector<std::vector<Matrix3Xd>> result(setup.trials.size());
    for (const statistics::ResidualSeries& series : data.layout.series) {
        const auto t = static_cast<std::size_t>(series.trial);
        if (result[t].empty())
            result[t].assign(setup.marker_names.size(),
                             Matrix3Xd::Constant(3, setup.trials[t].measured.sample_count(), no_number));
        for (Index k = series.begin; k < series.end; ++k)
            result[t][static_cast<std::size_t>(series.marker)](
                series.axis, data.layout.sample[static_cast<std::size_t>(k)]) = flat_m(k);
    }
    return result;
}

/// Root mean square of a flat residual per trial [m]; NaN for trials without samples.
std::vector<double> rms_of_trials(const setup::Setup& setup, const diagnosis::FitData& data, const VectorXd& residual) {
    std::vector<double> squares(setup.trials.size(), 0.0), count(setup.trials.size(), 0.0), result;
    for (const statistics::ResidualSeries& series : data.layout.series) {
        squares[static_cast<std::size_t>(series.trial)] += residual.segment(series.begin, series.size())
                                                               .cwiseProduct(
                                                                   data.noise_m.segment(series.begin, series.size()))
                                                               .squaredNorm();
        count[static_cast<std::size_t>(series.trial)] += static_cast<double>(series.size());
    }
    for (std::size_t t = 0; t < squares.size(); ++t)
        result.push_back(count[t] > 0.0 ? std::sqrt(squares[t] / count[t]) : no_number);
    return result;
}

/// Whether the run contains a completed prediction of this trial.
bool is_predicted(const prediction::SetupRun& run, std::size_t trial) {
    return trial < run.predictions.size() && run.predictions[trial].ok();
}

/// rms of a trial [m], or `otherwise` if the trial did not complete.
double score_of(const prediction::SetupRun& run, const std::string& trial, double otherwise) {
    const prediction::TrialScore* const score = results::find_score(run, trial);
    return score ? score->rms_m : otherwise;
}

/// The fit that a row displays, or null.
const diagnosis::JudgedFit* fit_of(const diagnosis::Diagnosis& d, const std::string& key) {
    if (key == declared_key) return &d.declared;
    for (const diagnosis::Candidate& candidate : d.candidates)
        if (candidate.judged && candidate.score.id == key) return &*candidate.judged;
    for (const diagnosis::JudgedFit& set : d.sets)
        if (key_of(set.fit.effects) == key) return &set;
    return nullptr;
}

/// Builds the displayed form of a diagnosis, complete or in progress.
class View {
public:
    View(const DiagnosisSource& source, const diagnosis::Diagnosis& d) : source_(source), setup_(source.setup), d_(d) {}

    ui::commands::DiagnosisView take() {
        // Nothing can be displayed before the declared fit.
        if (!d_.declared.usable()) return std::move(view_);
        view_.complete = d_.complete() && !d_.verdict.reason.empty();
        view_.stopped = d_.stopped;
        view_.noise_m = d_.noise_m;
        view_.seconds = d_.seconds;
        for (const std::string& note : d_.notes) view_.notes.push_back(capitalised(note) + ".");
        if (view_.complete) set_verdict();
        set_trials();
        add_rows();
        for (const diagnosis::Confusion& c : diagnosis::confusions_of_verdict(d_)) {
            const std::string words = diagnosis::name_in_sentence(c.first) + " and " +
                                      diagnosis::name_in_sentence(c.second) + " (cosine " + format_number(c.cosine, 3) +
                                      "); " + c.next_experiment + " would separate them.";
            if (diagnosis::is_decided(d_, c))
                view_.alike.push_back("Similar here, but the fits decide: " + words);
            else
                view_.confounded.push_back("Confounded here: " + words);
        }
        return std::move(view_);
    }

private:
    /// Headline and chosen row of the verdict.
    void set_verdict() {
        const diagnosis::Verdict& verdict = d_.verdict;
        view_.confidence = verdict.confidence;
        view_.because = reason();
        switch (verdict.kind) {
            case diagnosis::VerdictKind::none:
                view_.verdict = ui::commands::DiagnosisVerdict::none;
                view_.headline = "No effect is missing";
                chosen_ = declared_key;
                break;
            case diagnosis::VerdictKind::effects:
                view_.verdict = ui::commands::DiagnosisVerdict::effects;
                view_.headline = capitalised(diagnosis::names_of(verdict.effects)) +
                                 (verdict.effects.size() > 1 ? " are missing: " : " is missing: ") +
                                 diagnosis::fitted_words(setup_, d_.augmented.fit);
                chosen_ = key_of(verdict.effects);
                break;
            case diagnosis::VerdictKind::unknown:
                view_.verdict = ui::commands::DiagnosisVerdict::unknown;
                view_.headline = "An effect is missing that none of the known effects explains";
                chosen_ = d_.missing_force && !d_.missing_force->modes.empty() ? missing_force_key : "";
                break;
        }
    }

    /// Explanation of the verdict with readable effect names and the error on validation trials.
    std::string reason() const {
        std::string text = capitalised(d_.verdict.reason);
        if (d_.verdict.kind == diagnosis::VerdictKind::effects)
            text = "With " + diagnosis::names_of(d_.verdict.effects) +
                   " the systematic part of the residual falls from " +
                   format_number(d_.declared.tests.systematic.rms, 3) + " to " +
                   format_number(d_.augmented.tests.systematic.rms, 2) + " times the noise." + d_.verdict.cautions;
        const double before = d_.before.validation_rms_m, after = d_.after.validation_rms_m;
        if (d_.verdict.kind != diagnosis::VerdictKind::none && std::isfinite(before) && std::isfinite(after) &&
            before > 0.0)
            text += " On trials that were not used the error changes from " + format_number(1e3 * before, 3) + " to " +
                    format_number(1e3 * after, 3) + " mm.";
        return text;
    }

    /// Residual of the declared model per trial, and the coordinate with the largest mean square.
    void set_trials() {
        // Displayed as measurement minus prediction [m]; the fit's residual is prediction minus measurement over noise.
        const VectorXd flat = -d_.declared.fit.residual.cwiseProduct(d_.data.noise_m);
        const std::vector<std::vector<Matrix3Xd>> left = on_samples(setup_, d_.data, flat);
        const std::vector<double> rms = rms_of_trials(setup_, d_.data, d_.declared.fit.residual);
        for (std::size_t t = 0; t < setup_.trials.size(); ++t) {
            ui::commands::DiagnosisTrial trial{setup_.trials[t].name,
                                               setup_.trials[t].role == experiment::TrialRole::fit, left[t],
                                               score_of(d_.before, setup_.trials[t].name, rms[t])};
            if (trial.residual_m.empty() && is_predicted(d_.before, t))
                for (const Matrix3Xd& residual : d_.before.predictions[t].residual_m)
                    trial.residual_m.push_back(-residual);
            view_.trials.push_back(std::move(trial));
        }
        // The coordinate with the largest mean, not the largest sum: series differ in their number of visible samples.
        double most = -1.0;
        for (const statistics::ResidualSeries& series : d_.data.layout.series) {
            const double mean = series.size() > 0 ? flat.segment(series.begin, series.size()).squaredNorm() /
                                                        static_cast<double>(series.size())
                                                  : 0.0;
            if (mean <= most) continue;
            most = mean;
            view_.worst_trial = series.trial;
            view_.worst_marker = series.marker;
            view_.worst_axis = series.axis;
        }
    }

    /// Fitted parameters in words; `brief` is the short form for a narrow column.
    void set_value(ui::commands::DiagnosisRow& row, const diagnosis::JointFit& fit) const {
        row.value = diagnosis::fitted_words(setup_, fit);
        const std::vector<diagnosis::EffectEstimate> numbers = diagnosis::effect_estimates(setup_, fit);
        if (numbers.size() > 1) row.brief = std::to_string(numbers.size()) + " values";
        if (numbers.size() != 1) return;
        row.brief = diagnosis::estimate_words(numbers.front());
        row.one_number = row.value.ends_with(row.brief);  // otherwise words follow the number
    }

    /// Row of a fitted candidate: parameters, rms, predicted change, and the settings that adopt it.
    ui::commands::DiagnosisRow fitted_row(const std::string& key, const std::string& name,
                                          const diagnosis::JudgedFit& fit) const {
        ui::commands::DiagnosisRow row;
        row.key = key;
        row.name = name;
        row.chosen = key == chosen_;
        row.fitted = true;
        // The fit behind the verdict was repeated at the end.
        const diagnosis::JudgedFit& last = row.chosen && d_.augmented.usable() ? d_.augmented : fit;
        set_value(row, last.fit);
        row.rms_m = last.rms_m;
        row.held_out = fit.held_out_rms;
        row.weight = fit.weight;
        row.predicted_m = on_samples(setup_, d_.data,
                                     (fit.fit.residual - d_.declared.fit.residual).cwiseProduct(d_.data.noise_m));
        row.after_m = rms_of_trials(setup_, d_.data, fit.fit.residual);
        for (std::size_t t = 0; t < setup_.trials.size() && row.chosen; ++t) {
            row.after_m[t] = score_of(d_.after, setup_.trials[t].name, row.after_m[t]);
            if (!row.predicted_m[t].empty() || !is_predicted(d_.before, t) || !is_predicted(d_.after, t)) continue;
            for (std::size_t m = 0; m < setup_.marker_names.size(); ++m)
                row.predicted_m[t].push_back(d_.after.predictions[t].residual_m[m] -
                                             d_.before.predictions[t].residual_m[m]);
        }
        row.settings = source_.settings;
        row.settings.youngs_modulus_Pa = last.fit.values.youngs_modulus_Pa;
        row.settings.damping_s = last.fit.values.damping_s;
        set_law_values(last.fit.values.law, row.settings);
        // Added effects that are switched off stay so.
        std::erase_if(row.settings.effects, [](const ui::commands::AddedEffect& effect) { return !effect.off; });
        // Effects of the file stay in the file; only the additional ones become settings.
        for (std::size_t e = source_.file_effects; e < last.fit.values.effects.size(); ++e)
            row.settings.effects.push_back(added_effect(last.fit.values.effects[e]));
        return row;
    }

    /// Row of a candidate of the catalogue: fitted, or with its linear prediction only.
    ui::commands::DiagnosisRow candidate_row(const diagnosis::Candidate& candidate) const {
        const std::string& id = candidate.score.id;
        ui::commands::DiagnosisRow row;
        if (candidate.judged)
            row = fitted_row(id, results::effect_name(id), *candidate.judged);
        else {
            row.key = id;
            row.name = results::effect_name(id);
            row.value = "not fitted";
            // Linear prediction, without a fit.
            row.predicted_m = on_samples(setup_, d_.data, -candidate.score.predicted.cwiseProduct(d_.data.noise_m));
        }
        row.explained = candidate.score.usable() ? candidate.score.test.explained : no_number;
        for (const std::string& like : candidate.confounded_with)
            row.like += (row.like.empty() ? "" : ", ") + diagnosis::name_in_sentence(like);
        return row;
    }

    /// Rows in order: declared model, missing force, fitted candidates by criterion, unfitted ones.
    void add_rows() {
        ui::commands::DiagnosisRow declared = fitted_row(declared_key, "Declared model", d_.declared);
        declared.kind = ui::commands::DiagnosisRow::Kind::declared;
        declared.value = "no effect added";
        declared.predicted_m.clear();
        declared.after_m.clear();
        const bool alone = d_.sets.empty() && std::none_of(d_.candidates.begin(), d_.candidates.end(),
                                                           [](const auto& candidate) { return candidate.judged; });
        if (alone) declared.weight = no_number;  // there is nothing to share the evidence with
        view_.rows.push_back(std::move(declared));
        if (chosen_ == missing_force_key) view_.rows.push_back(missing_force_row());
        std::vector<std::pair<double, ui::commands::DiagnosisRow>> fitted;
        for (const diagnosis::Candidate& candidate : d_.candidates)
            if (candidate.judged) fitted.emplace_back(candidate.judged->criterion, candidate_row(candidate));
        for (const diagnosis::JudgedFit& set : d_.sets)
            fitted.emplace_back(
                set.criterion,
                fitted_row(key_of(set.fit.effects), results::effect_name(diagnosis::names_of(set.fit.effects)), set));
        std::stable_sort(fitted.begin(), fitted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        // The verdict omits unnecessary effects: among equivalent fits it names the simplest, which is displayed first.
        std::stable_partition(fitted.begin(), fitted.end(), [](const auto& row) { return row.second.chosen; });
        for (auto& [criterion, row] : fitted) view_.rows.push_back(std::move(row));
        for (const diagnosis::Candidate& candidate : d_.candidates)
            if (!candidate.judged && candidate.score.usable() &&
                candidate.score.predicted.size() == d_.data.layout.size())
                view_.rows.push_back(candidate_row(candidate));
    }

    /// Row of the force that would explain the residual, by its modes.
    ui::commands::DiagnosisRow missing_force_row() {
        const diagnosis::MissingForce& force = *d_.missing_force;
        ui::commands::DiagnosisRow row;
        row.kind = ui::commands::DiagnosisRow::Kind::missing_force;
        row.key = missing_force_key;
        row.name = "Missing force";
        row.chosen = row.fitted = true;
        row.explained = force.removed();
        row.value = "up to " + format_number(1e3 * force.modes.front().peak_N(), 3) + " mN " +
                    force.modes.front().where;
        view_.missing_force.trial = force.trial;
        view_.missing_force.time_s = force.time_s;
        for (std::size_t k = 0; k < force.modes.size(); ++k) {
            view_.missing_force.names.push_back(std::to_string(k + 1) + ": " + force.modes[k].where);
            view_.missing_force.amplitude_N.push_back(force.modes[k].amplitude_N);
        }
        return row;
    }

    const DiagnosisSource& source_;
    const setup::Setup& setup_;
    const diagnosis::Diagnosis& d_;
    std::string chosen_;
    ui::commands::DiagnosisView view_;
};

/// Resultant forces per patch over time.
ui::commands::PatchForces in_patches(const diagnosis::BodyPatches& patches, const std::vector<double>& times,
                                     const std::vector<Matrix3Xd>& forces) {
    ui::commands::PatchForces result;
    result.time_s = Eigen::Map<const VectorXd>(times.data(), static_cast<Index>(times.size()));
    for (const Matrix3Xd& force : forces) {
        result.force_N.push_back(patches.sums(force));
        result.largest_N = std::max(result.largest_N, result.force_N.back().colwise().norm().maxCoeff());
    }
    return result;
}

/// Superposes the modes of the missing force at each time; only the trial in which it was determined has one.
void add_missing_force(const setup::Setup& setup, const diagnosis::MissingForce& force,
                       const diagnosis::BodyPatches& patches, ui::commands::DiagnosisRow& row) {
    std::vector<Matrix3Xd> forces;
    for (Index k = 0; k < force.time_s.size(); ++k) {
        forces.push_back(Matrix3Xd::Zero(3, patches.patch_of_node.size()));
        for (const diagnosis::ForceMode& mode : force.modes) forces.back() += mode.amplitude_N(k) * mode.pattern;
    }
    row.force.resize(setup.trials.size());
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (setup.trials[t].name == force.trial)
            row.force[t] = std::make_shared<const ui::commands::PatchForces>(
                in_patches(patches, {force.time_s.begin(), force.time_s.end()}, forces));
}

}  // namespace

ui::commands::DiagnosisView diagnosis_view(const DiagnosisSource& source, const diagnosis::Diagnosis& diagnosis) {
    return View(source, diagnosis).take();
}

void add_forces(const DiagnosisSource& source, const diagnosis::Diagnosis& d, ui::commands::DiagnosisView& view) {
    assert(d.complete());
    const setup::Setup setup = diagnosis::as_diagnosed(d, source.setup);
    const model::Body& shown_body = *source.setup.body;
    const diagnosis::BodyPatches shown_patches = diagnosis::body_patches(shown_body, about_patches);
    view.patch_of_node = shown_patches.patch_of_node;
    view.patches = shown_patches.count;
    // The fits may have coarser cells than the body that is shown.
    const diagnosis::BodyPatches patches = diagnosis::patches_on(*setup.body, shown_body, shown_patches);
    std::vector<ui::commands::DiagnosisRow*> rows;
    for (ui::commands::DiagnosisRow& row : view.rows) {
        if (row.kind == ui::commands::DiagnosisRow::Kind::missing_force)
            add_missing_force(setup, *d.missing_force, patches, row);
        if (row.kind == ui::commands::DiagnosisRow::Kind::effects && row.fitted && rows.size() < max_with_forces)
            rows.push_back(&row);
    }
    for (ui::commands::DiagnosisRow* row : rows) row->force.resize(setup.trials.size());
    // One task per row and trial; reasons are collected separately because rows are shared between tasks.
    std::vector<std::string> why(rows.size() * setup.trials.size());
    parallel_tasks(static_cast<int>(why.size()), setup.settings.threads, [&](int task) {
        const std::size_t t = static_cast<std::size_t>(task) % setup.trials.size();
        ui::commands::DiagnosisRow& row = *rows[static_cast<std::size_t>(task) / setup.trials.size()];
        const bool own = row.chosen && is_predicted(d.after, t);
        const diagnosis::JudgedFit* const fit = own ? &d.augmented : fit_of(d, row.key);
        if (!fit || !is_predicted(d.before, t)) return;
        const prediction::ParameterValues values = prediction::with_predicted_levels(setup, fit->fit.values);
        const std::size_t first = values.effects.size() - fit->fit.effects.size();
        const diagnosis::NodalForces forces = diagnosis::effect_forces(
            setup, t, values, first, (own ? d.after : d.before).predictions[t].trace, about_moments);
        ui::commands::PatchForces shown = in_patches(patches, forces.times_s, forces.force_N);
        if (!forces.failure.empty())
            why[static_cast<std::size_t>(task)] = "No force is drawn: " + forces.failure + ".";
        else if (!(shown.largest_N > 0.0))
            why[static_cast<std::size_t>(
                task)] = "No force is drawn: it changes where the body is held, how it starts or how it is seen.";
        else
            row.force[t] = std::make_shared<const ui::commands::PatchForces>(std::move(shown));
    });
    for (std::size_t i = 0; i < why.size(); ++i)
        if (!why[i].empty()) rows[i / setup.trials.size()]->no_force = why[i];
}

}  // namespace myo::backend
