#pragma once

#include <cstddef>

#include "diagnosis/numerics_policy.hpp"

namespace myo::diagnosis {

/// Limits of a fit.
struct Effort {
    int evaluations = 0;  // at most
    /// A fit has converged if an iteration is predicted to reduce the squared residual by a smaller share. For squared
    /// residuals in the thousands, 1e-4 is a quarter of a standard deviation; the iteration before was larger.
    double relative_decrease = 1e-4;
    int max_jacobians = 1000;  // in addition to the Jacobian known at the start
};

/// Repetition of a fit with the numerical error of its own motion removed.
struct ErrorCorrection {
    Effort effort;
    double max_change = 0.0;  // of predictions [noise levels, rms]; above it the error is computed again
};

// All tuning numbers of the diagnosis. "Seed" in a source: number of the record in assets/validation on whose cases the
// value was chosen; the other seeds tested it.

/// Repeated trials.
struct RepeatPolicy {
    double same_motion = 0.1;  // largest difference of the predictions of repeats [noise levels]
    int min_samples = 10;      // of all markers, below which two recordings are not compared
};

/// Fit of the declared parameters, the reference of all comparisons.
struct DeclaredFitPolicy {
    /// Possible error of a sensor's prediction by mesh and step, over the reading: one layer of quadratic cells bends
    /// up to 5 % too far (test SmallLoad.LayersOfQuadraticCells).
    double numerical_share_of_readings = 0.05;
    Effort effort{30};
    ErrorCorrection correction{{12}, 1.0};
    /// A run with this many times the iterations of the declared fit is stopped: its parameters are implausible. Where
    /// an effect is missing the declared fit may be overdamped: 4 stopped runs of the right effect in
    /// example_clamp_compliance.
    int max_iteration_ratio = 8;
    /// A fitted damping this many times the expected one compensates for something else.
    double max_damping_ratio = 3.0;
    /// Width of the prior of an effect's vectors, in units of their scales: the data determine a place on a surface in
    /// two directions only.
    double prior_widths = 10.0;
    /// An undeclared mass is at most this many times the body's.
    double max_mass_ratio = 3.0;
};

/// Responses to effects from tangents of the run without them.
struct FirstOrderPolicy {
    /// Largest response in a trial, over the motion of its markers (both rms): the second order is then about this
    /// share of it, and scores need responses to a few percent only.
    double max_response = 0.05;
    /// Effects whose tangents follow one run: more share its stiffness, and need as many models at once.
    std::size_t effects_of_a_run = 32;
};

/// Score tests of all candidates. Source: Rao 1948.
struct ScreeningPolicy {
    /// Scores may be computed with longer steps if that changes predictions by less than this share of the residual.
    double step_error_share = 0.3;
    FirstOrderPolicy first_order;  // of small probes
    /// A probe that explains less of the residual's squares is not fitted.
    double min_explained = 0.02;
    /// Other places of an effect are fitted if their predicted reduction is at least this share of the best place's.
    double comparable_place = 0.5;
    int max_places = 2;                 // of one effect
    std::size_t max_places_of_all = 6;  // of all effects together

    /// Largest amount of a probe, by the norm of its response over that of the residual: of the part that other
    /// parameters do not compensate, and of the whole. A softer material with a higher modulus compensates most.
    double max_outside = 2.0;
    double max_over_residual = 30.0;
    /// A probe whose response is more than this many times the residual is not in the linear range of smaller amounts.
    double nonlinear_ratio = 2.0;
    /// A second start is used if its amount differs from the first by this factor.
    double distinct_start = 2.0;
    /// Exchanged names and slipped markers are scored if undoing them removes this share of the squared residual.
    /// Markers are centimetres apart: an exchange that happened causes most of the residual.
    double min_swap_gain = 0.2;
    double min_slip_gain = 0.05;
    /// Damping of the columns of a probe, over its largest column: a column far below it gets hardly any amount.
    double negligible_column = 0.05;
    std::size_t residual_lines = 3;  // frequencies of the residual that probes are offered
};

/// Fits of candidates, in parallel.
struct CandidateFitPolicy {
    Effort amount{4, 1e-3, 0};      // declared parameters and amounts, with the Jacobian known at the start
    Effort nonlinear{10, 1e-3, 1};  // as above, for starts beyond the linear range
    Effort repeated{8, 1e-3, 1};    // as above, if the first attempt missed its predicted reduction
    Effort leader{20, 3e-4};        // all parameters of the best candidate
    Effort rival{20, 1e-3, 3};      // all parameters of those with a large predicted reduction
    Effort other{20, 1e-3, 1};      // all parameters of the others
    Effort stuck{4, 1e-3, 1};       // all parameters of those without progress, to see whether they can make some
    double relative_step = 1e-5;    // relative change of the parameters below which a fit has converged
    /// The first step of a parameter of unknown order of magnitude changes it by at most this factor, e squared.
    double max_factor = 7.38905609893065;
    /// Candidates with a larger predicted reduction get new derivatives again: secant updates are too inaccurate for
    /// them.
    double large_reduction = 0.3;
    /// Candidates whose predicted reduction is at least this share of the leader's are pruned later.
    double comparable_reduction = 0.9;
    /// An unfinished one of them that leaves less than this share of the base's squares is not pruned while the
    /// smallest exceeds the noise by the second factor, a systematic part as large as the noise. The derivatives of the
    /// base mislead: those of the right effect left 0.08 where they predicted 0.05, a mimic's 0.001
    /// (beginnings of example_clamp_compliance).
    double promising = 0.3;
    double noise_like = 2.0;
    /// Fits that are continued between two looks at what they may prune: as many on every machine, since the result
    /// must not depend on the number of threads.
    std::size_t fitted_together = 2;
    /// A fit is repeated if its squared residual exceeds the predicted one by the first factor and is below the second
    /// share of the base's, and if its predicted reduction is at least the third share of the largest. A fit above the
    /// second share has made no progress.
    double missed_reduction = 1.5;
    double min_progress = 0.95;
    double worth_repeating = 0.8;
};

/// Search for one effect.
struct SearchPolicy {
    /// A score this high, from the fit with its distorted parameters reset, makes that fit the base without comparison.
    double conclusive_score = 0.8;
    std::size_t first_fits = 3;  // candidates fitted before any conclusion
    /// A fit is pruned if its squared residual exceeds the smallest by this factor.
    double pruning_factor = 4.0;
    /// As above where even the best leaves more than corrected_share: a set is then searched from the best alone.
    double far_pruning_factor = 1.0;
    /// Once the best fit explains the residual, or leaves at most this share of its squares and a systematic part below
    /// the noise, candidates with less than this share of its predicted reduction are not fitted. Distortion of the
    /// declared fit hides up to two thirds of the reduction by the right effect.
    double min_relative_reduction = 0.25;
    double max_left = 0.5;
    double noise_like = 1.0;  // [noise levels]
    /// A fit with less than this share of the declared excess has a motion nearer to the truth: its numerical error is
    /// computed.
    double corrected_share = 0.3;
    /// A candidate that leaves more than this share of the squared residual is fitted from its nonlinear starts, too.
    double restart_share = 0.9;
    std::size_t corrected_candidates = 2;  // whose own numerical error is computed before the verdict
    /// Rivals: squares up to this factor of the best.
    double rival_factor = 1.5;
    std::size_t polished_candidates = 3;  // if nothing explains the residual
    std::size_t polished_rivals = 5;
    Effort polish{20, 3e-4};
    ErrorCorrection correction{{20}, 3.0};
    Effort unexplained{4, 1e-3};  // of the best attempt if nothing explains the residual
};

/// Fits of the named effects from places in neighbouring cells.
struct PlacePolicy {
    /// Only along directions in which a cell is at most this many standard deviations of the place: a force on the
    /// nodes of one cell moves them more or less, depending on where in the cell it acts, which raises the squares
    /// between cells by some tens (by 15 in example_dry_friction, of 8,700).
    double max_deviations = 10.0;
    double min_deviations = 0.1;  // below, the place along this direction changes nothing, as across the surface
    double min_step = 0.5;        // of a cell, after the bounds: a smaller step leads to the same cell
    int max_steps = 3;            // from cell to cell
    Effort effort{12};
};

/// Search for sets of effects.
struct SetPolicy {
    /// Only if the best effect leaves at most this share of the declared excess: where two act, each alone may take
    /// little.
    double max_left = 0.9;
    double pruning_factor = 1.2;      // lower than for single effects: all but one are already fitted
    std::size_t max_effects = 4;      // of a set; its numbers are then as many as a few trials determine
    int max_rounds = 6;               // larger sets and exchanges together
    double min_evidence_ratio = 4.0;  // of a set over the one before it: weights of 0.8 and 0.2
    Effort glance{4, 1e-2, 0};        // of a set without one of its effects, with the derivatives of the whole set
    Effort drop{8, 1e-3};             // of such a set, if it is no worse than the search's pruning factor then
    /// The search is repeated from a single effect that is found later if it leaves at most this share of the squares
    /// of the one before.
    double new_start = 0.9;
};

/// Search on the beginnings of the recordings, before that on the whole of them. A wrong frequency shifts the phase the
/// more the longer a trial lasts; after half a period the residual no longer follows the derivatives at the declared
/// fit, by which effects are chosen.
struct BeginningPolicy {
    /// Only for systematic residuals of the declared fit above this [noise levels]: smaller ones follow the
    /// derivatives.
    double min_residual = 10.0;
    /// The first beginning, a share of every recording; doubled while the declared fit leaves less than min_residual
    /// in it, and after each search.
    double first_share = 0.25;
    double growth = 2.0;
    int min_samples = 8;  // of a trial
    /// Poses of the first beginning: a modulus and an effect are told apart by two of different size.
    std::size_t min_poses = 2;
    /// Largest share of the time that is left for a limited search: the rest is for fits of the whole recordings.
    double share_of_time = 0.5;
    std::size_t kept = 3;      // best fits of a beginning, from which the longer one is fitted
    double kept_factor = 4.0;  // of their squared residual over the smallest
    Effort refit{15, 1e-3};    // on the longer one
};

/// Effects that the experiment cannot separate.
struct ConfusionPolicy {
    double min_cosine = 0.97;  // of the changes of the residual by two effects
    /// An effect with less than this share of the largest predicted reduction is no rival, unless it fits as well.
    double min_reduction = 0.3;
    double comparable_weight = 0.05;  // share of the evidence, above which two fits are comparable
    /// Twins: what they leave between each other is a twentieth of what each does, as laws of other forms do.
    double twin_cosine = 0.999;
};

/// Criteria for a residual that needs an explanation, and for a fit that is one.
struct JudgementPolicy {
    /// Smallest systematic residual of interest [noise levels]: two simulators of the same model differ by as much.
    double min_systematic = 0.3;
    /// Largest faint residual [noise levels]: simulators of thin bodies differ by as much.
    double faint = 0.5;
    /// A residual below this share of the mesh error is also faint, up to a limit [noise levels].
    double faint_share_of_mesh = 2.0 / 3.0;
    double max_faint = 0.8;
    /// If little of the mesh error remains after extrapolation, it may be this many times as large, up to a limit
    /// [noise levels].
    double rough_extrapolation = 2.0;
    double max_rough = 0.8;
    /// Largest remaining numerical error that is tolerated [noise levels]; beyond it the mesh has to be refined.
    double max_allowed = 1.0;
    /// A fit may leave this many times the remaining mesh error, which is itself extrapolated.
    double mesh_error_factor = 1.5;
    /// Largest share of the systematic residual that an explanation leaves: in general, and of a faint one.
    double most_of_residual = 0.6;
    double most_of_faint = 0.5;
    /// Share that the same effect leaves in the form of another program.
    double share_of_form = 0.05;
    /// The extrapolation over meshes may be wrong by this share, up to a limit [noise levels]. It is tolerated only if
    /// a fit leaves at most the third share of the systematic residual.
    double share_of_mesh = 1.0 / 3.0;
    double most_of_mesh = 0.5;
    double little_left = 0.4;
    /// One-sided 95 % quantile of the normal distribution, beyond which an excess is not chance.
    double chance_deviations = 1.64;
    /// An effect differs from zero if its amount is at least this many standard deviations.
    double significant_deviations = 3.0;
    /// Largest share of the excess squares on held-out data that an effect leaves, and excess that is attributed to
    /// chance.
    double max_held_out = 0.5;
    double chance_held_out = 0.05;
    /// Information criteria of dynamic fits exaggerate, because residuals share errors of the model's form: their
    /// differences are divided by this for the weights. The most likely value for pairs of effects of seed 1 that both
    /// explained their case is 15 to 30. See evidence_weights().
    double temperature = 16.0;
    /// Relative distance to a bound within which a value counts as at the bound.
    double at_bound = 1e-6;
    /// Odds against an effect at its bound, compared with one within its bounds that fits equally well.
    double odds_against_bounds = 4.0;
    /// Guard between blocks of time in cross-validation [s]: the longest correlation time of a residual.
    double guard_s = 0.05;
    /// Largest drift of a measurement [noise levels].
    double max_drift = 3.0;
};

/// The verdict and its confidence.
struct VerdictPolicy {
    /// Confidence in a verdict without doubt: 153 of 161 such verdicts of seed 1 were right (91 to 98 %), with a sixth
    /// of the effects not in the catalogue.
    double undoubted = 0.93;
    /// If the noise was not declared, that of cameras at rest is far below the error of any model of a real body: an
    /// effect is named if it leaves at most this share of the rms, and this share on held-out samples (of the squares
    /// 1/4 and 1/2).
    double max_left = 0.5;
    double max_left_held_out = 0.7;
    /// The confidence then falls by this times the share of the rms that is left.
    double discount_of_left = 0.5;
    /// An effect that leaves less than this share of the systematic part is named although a test is still significant:
    /// its law may have another form than that of the catalogue.
    double nearly_all = 0.125;
    /// Factor of the confidence in that effect, and in two effects that explain the residual: they may replace one
    /// effect of another form.
    double other_form = 0.6;
    /// An effect is present if all fits that contain it have more than this weight.
    double present = 0.5;
    /// Weight from which a second effect is named: small remainders, of the mesh for instance, are explained by many.
    double second_effect = 0.8;
    /// Factor of the confidence in `unknown` if the best attempt nearly explains the residual, and its growth with the
    /// remaining share. All such answers of seed 1 were right.
    double nearly_explained = 0.8;
    double unexplained_growth = 0.4;
    double least_systematic = 1e-9;  // of the declared model, for that share [noise levels]: no division by zero
    /// The prediction of trials that took no part is worse if its rms grows by this factor and exceeds this many noise
    /// levels; the confidence is then multiplied by the third value.
    double worse_prediction = 1.1;
    double good_prediction = 1.3;
    double contradicted = 0.5;
    /// Factor of the confidence in `none` if the residual is measurement drift: no record shows how often that is
    /// right.
    double drift = 0.7;
    /// Factor of the confidence if the search ended at its limit of time: no record shows how often a better
    /// explanation was still to come.
    double unfinished_search = 0.7;
    /// Factor of the confidence if the effect's amount, or the modulus fitted with it, ends at its bound.
    double at_bound = 0.5;
    /// Confidence in `none` for a faint residual: this minus the residual's share of the allowance, but at least the
    /// second value.
    double faint_allowance = 1.5;
    double min_faint = 0.3;
};

/// The missing force. Source: Morozov 1984 (discrepancy principle); Hansen 1998, ch. 5 (Tikhonov regularisation).
struct MissingForcePolicy {
    int stations = 3;               // of the force fields along the body: clamp, middle, far end
    double min_offset = 1e-6;       // of the body's centre from its support, over its size: below it all around
    double knot_spacing_s = 0.025;  // of the force courses
    int min_knots = 12, max_knots = 60;
    int path_samples = 101;      // of a signal, for its mean
    int curve_points = 201;      // samples of a course, for correlations
    double smoothing_s = 0.025;  // of courses
    /// An iteration aims at this share of the squared residual, and at shares larger by this factor if the run does not
    /// follow.
    double first_share = 0.1;
    double share_factor = 2.0;
    int max_runs = 8;
    /// The largest squared residual that may be noise: its expectation times the first value, because the noise is
    /// known to a few percent only, plus this many standard deviations. The search ends at the third value times that.
    double noise_doubt = 1.05;
    double noise_deviations = 2.0;
    double noise_margin = 1.02;
    double min_gain = 0.97;  // a run that leaves a larger share of the squared residual is the last
    /// Factor of the smallest squared residual that a linear response can reach, the lowest target: the last percents
    /// need the largest forces.
    double reachable = 1.1;
    double lowest_lambda = 1e-9, highest_lambda = 1e3;  // regularisation, over the largest diagonal entry
    int bisections = 80;                                // for its logarithm
    /// A force that explains less of the squared residual is not reported: its place would be chance.
    double min_explained = 0.05;
    int max_modes = 3;
    /// Modes are reported until they hold this share of the force.
    double reported_share = 0.97;
    double min_mode = 0.01;  // smallest share of a mode that is reported
    // Limits for the description of a mode. A uniform force has its centre at 0.5 of the length and a spread of 0.29.
    double min_aligned = 0.3;    // below: opposite directions, like a moment
    double along_axis = 0.9;     // component of a direction along an axis
    double min_component = 0.3;  // component that is mentioned otherwise
    double at_end = 0.75, near_end = 0.6, near_clamp = 0.4, at_clamp = 0.25;  // of the length
    double concentrated = 0.24;                                               // largest spread of a force at the middle
};

/// Policies of all phases.
struct DiagnosisPolicy {
    NumericsPolicy numerics;
    RepeatPolicy repeats;
    DeclaredFitPolicy declared;
    ScreeningPolicy screening;
    CandidateFitPolicy fits;
    SearchPolicy search;
    SetPolicy sets;
    BeginningPolicy beginnings;
    ConfusionPolicy confusion;
    JudgementPolicy judgement;
    PlacePolicy places;
    VerdictPolicy verdict;
    MissingForcePolicy force;
};

}  // namespace myo::diagnosis
