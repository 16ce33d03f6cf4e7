#include <utility>

#include "base/text.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/declared_fit.hpp"
#include "diagnosis/fit/store_words.hpp"
#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/search/beginning_context.hpp"
#include "diagnosis/search/search_beginnings.hpp"
#include "diagnosis/search/search_decisions.hpp"
#include "diagnosis/search/search_effects.hpp"
#include "diagnosis/search/search_sets.hpp"
#include "diagnosis/verdict/deviations.hpp"
#include "diagnosis/verdict/final_fit.hpp"
#include "diagnosis/verdict/twins.hpp"
#include "diagnosis/verdict/verdict.hpp"
#include "statistics/residual_spot.hpp"

namespace myo::diagnosis {
namespace {

/// Note on where and when most of an unexplained residual occurs, if that is a small part of a recording.
std::vector<std::string> spot_notes(const setup::Setup& setup, const FitData& data, const Decision& decision) {
    if (decision.verdict.kind != VerdictKind::unknown) return {};
    const std::optional<statistics::ResidualSpot> spot = statistics::residual_spot(decision.fit.fit.residual,
                                                                                   data.layout);
    if (!spot) return {};
    std::vector<std::string> markers;
    for (const int marker : spot->markers) markers.push_back(setup.marker_names[static_cast<std::size_t>(marker)]);
    return {format_number(100.0 * spot->share, 2) + " % of the squared residual lies between " +
            format_number(spot->from_s, 3) + " and " + format_number(spot->to_s, 3) + " s of " +
            setup.trials[static_cast<std::size_t>(spot->trial)].name + ", in " + join(markers) +
            ": look there for a fault of the recording, or for what acted once"};
}

/// Note that compares the residual with that between repeated trials, or advises to repeat one if none was.
std::string remainder_note(const setup::Setup& setup, const Diagnosis& d) {
    const Repeatability& floor = d.repeatability;
    const auto mm = [](double length_m) { return format_number(1e3 * length_m, 3) + " mm"; };
    if (!floor.known())
        return "no trial was repeated: what a second recording of the same trial leaves is a floor for every model, "
               "and "
               "is not known here";
    std::vector<std::string> pairs;
    for (const auto& [a, b] : floor.repeats) pairs.push_back(setup.trials[a].name + " and " + setup.trials[b].name);
    return mm(d.augmented.rms_m) + " remain in the fit trials, of which " + mm(floor.rms_m) +
           " lie between repeated trials (" + join(pairs) + ")";
}

/// Context of the later phases. From here on the shift and the modulus factor of the corrected declared fit apply.
DiagnosisContext context_of(DeclaredFit declared, CorrectedDeclaredFit corrected, const DiagnoseSettings& settings) {
    NumericalError numerics = *corrected.fit.numerics;
    declared.data.shift = numerics.shift;
    declared.setup.modulus_factor = corrected.modulus_factor;
    return {std::move(declared.setup), settings,
            std::move(declared.data),  std::move(corrected.fit),
            std::move(numerics),       std::move(corrected.refinement)};
}

/// The fit without its predictions, which need the memory of many runs.
/// The predictions are moved out for the copy and back: copying them first would need their memory once more.
JudgedFit without_predictions(JudgedFit& fit) {
    std::vector<prediction::TrialPrediction> predictions;
    predictions.swap(fit.fit.predictions);
    JudgedFit copy = fit;
    predictions.swap(fit.fit.predictions);
    return copy;
}

/// The result as it grows. Only this class writes to it: each phase returns a value, which is entered here.
class Record {
public:
    Record(const DiagnoseSettings& settings, const PhaseLog& log, const std::function<void(const Diagnosis&)>& live)
        : log_(log), live_(live) {
        d_.settings = settings;
    }

    /// The overloads enter the value of one phase each, in the order of diagnose(); most of them show the result.
    void enter(DeclaredFit& declared) {
        d_.data = declared.data;
        d_.noise_m = mean_noise_m(declared.data);
        d_.step_factors = declared.step_factors;
        d_.coarser = declared.coarser;
        d_.repeatability = declared.repeatability;
        d_.notes = declared.notes;
        d_.failure = declared.failure;
        d_.declared = without_predictions(declared.fit);
        show();
    }
    void enter(DiagnosisContext& context) {
        d_.data.shift = context.data.shift;
        d_.modulus_factor = context.setup.modulus_factor;
        d_.declared = without_predictions(context.declared);
        d_.numerics = context.numerics;
        log_.progress().report({"significance", 1.0, 1.0, "phase", {}});
        show();
    }
    void enter(const RankedFits& fits) {
        d_.declared.criterion = fits.declared.criterion;
        d_.declared.weight = fits.declared.weight;
        d_.candidates = fits.candidates;
        d_.sets = fits.sets;
        show();
    }
    void enter(std::vector<Confusion> confusions) {
        d_.candidates = with_confusions(std::move(d_.candidates), confusions);
        d_.confusions = std::move(confusions);
        show();
    }
    /// The error of the declared fit with that of the trials that were not fitted.
    void enter_declared_error(const NumericalError& error) { d_.declared.numerics = d_.numerics = error; }
    void enter(const Decision& decision, const std::vector<std::string>& notes) {
        d_.verdict = decision.verdict;
        d_.notes.insert(d_.notes.end(), decision.notes.begin(), decision.notes.end());
        d_.notes.insert(d_.notes.end(), notes.begin(), notes.end());
        d_.augmented = decision.fit;
    }
    void enter(FinalFit last) {
        if (last.complete) d_.data.shift = last.fit.numerics->shift;
        d_.notes.insert(d_.notes.end(), last.notes.begin(), last.notes.end());
        d_.augmented = std::move(last.fit);
        d_.before = std::move(last.before);
        d_.after = std::move(last.after);
        show();
    }

    void enter_unfinished_search() { d_.search_complete = false; }
    void enter_note(std::string note) { d_.notes.push_back(std::move(note)); }

    const Diagnosis& so_far() const { return d_; }
    /// Moment at which the diagnosis has lasted so long.
    Progress::Moment at(double seconds) const { return watch_.at(seconds); }
    bool shows() const { return live_ != nullptr; }
    void show() {
        d_.cost = log_.costs();
        if (live_) live_(d_);
    }
    /// The result with times, deviations, and, unless it was stopped, tested confidence and twins. The last call: the
    /// record is moved from.
    Diagnosis finished() {
        d_.stopped = log_.cancelled();
        d_.seconds = watch_.seconds();
        d_.cost = log_.costs();
        // Paths serve to start further runs only, and need as much memory as the runs.
        forget_paths(d_.augmented.fit.predictions);
        if (!d_.stopped && d_.declared.usable()) enter_deviations();
        return d_.stopped ? std::move(d_) : with_twins(with_tested_confidence(with_final_fit(std::move(d_))));
    }

private:
    /// Deviations for the errors that are left, of what is reported.
    /// Entered at the end, as the numerical error of the verdict's own fit is known only there.
    void enter_deviations() {
        const NumericsPolicy& policy = d_.settings.policy.numerics;
        d_.declared = with_deviations(std::move(d_.declared), d_.data, d_.numerics, policy);
        if (!d_.augmented.usable()) return;
        const NumericalError& numerics = d_.augmented.numerics ? *d_.augmented.numerics : d_.numerics;
        d_.augmented = with_deviations(std::move(d_.augmented), d_.data, numerics, policy);
    }

    const PhaseLog& log_;
    const std::function<void(const Diagnosis&)>& live_;
    Stopwatch watch_;
    Diagnosis d_;
};

/// Whether a set explains the residual, and no single effect does.
bool is_explained_by_set(const RankedFits& fits, const Baseline& baseline) {
    return !explained(fits.candidates, baseline) && is_explained(fits, baseline);
}

/// Search on beginnings of the recordings, screening and search of one effect, and search of a set; of a set first,
/// where no single effect comes near. Returns the shift with which the last fits were made.
PredictionShift search(const DiagnosisContext& context, FitStore& store, PhaseLog& log, Record& record) {
    // Without someone to show it to, the result is not copied at every step of the search.
    SearchObserver show;
    if (record.shows()) show = [&](const RankedFits& fits) { record.enter(fits); };
    const Baseline& baseline = context.baseline();
    // A faint residual is not worth sets: two effects explain almost any small residual.
    const bool faint = is_faint(baseline);
    BeginningSearch beginnings = search_beginnings(context, store, log);
    RankedFits fits = std::move(beginnings.fits);
    PredictionShift shift = context.data.shift;
    const auto search_larger = [&] {
        if (log.cancelled() || faint) return;
        SetSearch sets = search_sets(context, std::move(fits), store, log, show);
        fits = std::move(sets.fits);
        shift = std::move(sets.shift);
    };
    const auto search_whole = [&](const Screening& screening) {
        const SingleSearchInput in{context, screening, show};
        // A fit from the beginnings may be that of a mimic: it must not prune the others.
        const std::vector<Candidate> from_beginnings = std::move(fits.candidates);
        fits = {{}, listed_candidates(screening.scores), std::move(fits.sets)};
        fits = search_likely_effects(in, std::move(fits), store, log);
        for (const Candidate& candidate : from_beginnings)
            if (candidate.judged) enter_fit(fits, *candidate.judged);
        fits = with_ranked_candidates(std::move(fits), baseline);
        // If every single effect leaves much, more of them are not fitted before sets were tried; and a set is searched
        // again if one of the later single effects leaves clearly less than those from which it was searched before.
        const bool far = is_far_from_explained(fits.candidates, baseline);
        if (far) search_larger();
        if (!log.cancelled() && !(far && is_explained(fits, baseline))) {
            const double left = min_left(fits.candidates);
            fits = search_all_effects(in, std::move(fits), store, log);
            if (!far || min_left(fits.candidates) < context.policy().sets.new_start * left) search_larger();
        }
    };
    // A set found on the beginnings is continued on the whole recordings before single effects are scored; so is what
    // was found until the time for them was over, as the scores of so large a residual would tell less.
    if ((!fits.sets.empty() || beginnings.cut) && !explained(fits.candidates, baseline)) search_larger();
    const bool found = explained(fits.candidates, baseline, Leniency::strict) || is_explained_by_set(fits, baseline);
    const Screening screening = found ? Screening() : screen_effects(context, store, log);
    if (!found && !log.cancelled())
        search_whole(screening);
    else if (!fits.candidates.empty())
        // Screening would take scores at the declared fit, whose residual is too large for its derivatives.
        record.enter_note("effects are scored on " + beginning_words(context, beginnings.share) +
                          ", where so large a residual still follows their derivatives");
    // Single effects that were fitted after the sets are among them, too: all weights are shares of one sum.
    if (!fits.sets.empty()) fits = with_ranked_sets(std::move(fits), baseline);
    record.enter(fits);
    record.enter(find_confusions(fits.candidates, context.declared.fit, context.policy().confusion));
    return shift;
}

}  // namespace

setup::Setup as_diagnosed(const Diagnosis& diagnosis, const setup::Setup& setup) {
    setup::Setup diagnosed = diagnosis.coarser ? *diagnosis.coarser : for_candidates(setup, diagnosis.settings);
    for (std::size_t t = 0; t < diagnosis.step_factors.size(); ++t)
        diagnosed.trials[t].options.h_s = setup.trials[t].options.h_s * diagnosis.step_factors[t];
    diagnosed.modulus_factor = diagnosis.modulus_factor;
    return diagnosed;
}

Diagnosis diagnose(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress,
                   const std::function<void(const Diagnosis&)>& live) {
    PhaseLog log(progress);
    Record record(settings, log, live);
    const setup::Setup prepared = prepared_setup(setup, settings);
    // The store belongs to the prepared setup, with its element: fits with another element are not read.
    FitStore store = settings.fits ? FitStore(*settings.fits, store_words(prepared)) : FitStore();

    DeclaredFit declared = fit_declared(prepared, settings, store, log);
    if (std::string note = store.unused_note(); !note.empty()) declared.notes.push_back(std::move(note));
    record.enter(declared);
    if (!declared.usable() || log.cancelled()) return record.finished();
    // All comparisons refer to the corrected fit: mesh and step errors would otherwise be explained by effects.
    std::optional<CorrectedDeclaredFit> corrected = correct_declared_fit(
        {declared.setup, declared.data, settings, {}, "declared fit", settings.policy.declared.correction},
        std::move(declared.fit), store, log);
    if (!corrected) return record.finished();
    DiagnosisContext made = context_of(std::move(declared), std::move(*corrected), settings);
    record.enter(made);

    const DiagnosisContext& context = made;
    PredictionShift shift = context.data.shift;
    // A residual within noise and numerical error needs no search, and the verdict will be `none`.
    if (needs_explanation(context.baseline())) {
        const PhaseLimit limit(log,
                               settings.search_limit_s ? record.at(*settings.search_limit_s) : Progress::Moment::max());
        shift = search(context, store, log, record);
        if (limit.passed()) record.enter_unfinished_search();
    }
    if (log.cancelled()) return record.finished();

    // Only now: trials with role `validate` take part in no decision, and their refined runs are needed for the last
    // prediction alone.
    const NumericalError declared_error = with_error_of_other_trials(context, context.declared, log);
    record.enter_declared_error(declared_error);
    const Decision decision = decide(record.so_far());
    record.enter(decision, spot_notes(context.setup, context.data, decision));
    record.enter(final_fit({context, declared_error, decision, shift, record.so_far().search_complete}, store, log));
    record.enter_note(remainder_note(context.setup, record.so_far()));
    return record.finished();
}

}  // namespace myo::diagnosis
