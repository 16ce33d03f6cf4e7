#pragma once

#include <cstddef>

namespace myo::diagnosis {

/// How far a fit goes.
struct Effort {
    int evaluations = 0;
    /// The search ends when an iteration lowers the squares by less. Of thousands of squares 1e-4 is a quarter of a
    /// standard deviation, and the step before was larger.
    double relative_decrease = 1e-4;
    int most_jacobians = 1000;  // beside those known where the fit starts
};

/// How a fit is repeated with the numerical error of its own motion taken off.
struct ErrorCorrection {
    Effort effort;
    double most_change = 0.0;  // of predictions [noise levels, rms]: beyond it the error is computed again
};

// Every number of the diagnosis. "seeds" in a source: of the records in assets/validation the one on whose cases the
// number was chosen; the other seeds tested it.

/// Numerical error of the runs, and how it is taken off. Source: Richardson 1911 (extrapolation); Roache 1998, ch. 5.
struct NumericsPolicy {
    /// Relative residual of nodal forces in the stages of all runs: motions are exact to 1 % of usual noises.
    double solver_tolerance = 1e-6;
    /// Relative residual of the linear systems of derivatives: a fit needs the direction, not all digits.
    double tangent_tolerance = 1e-4;

    /// Relative distance to a bound within which a value counts as at the bound.
    double at_bound = 1e-6;

    /// Steps are lengthened while predictions change by at most this [noise levels, rms]: so small an error follows its
    /// order and is taken off. Or by this share of what the declared fit leaves, if that is more: a law of another form
    /// than an effect's leaves a twentieth.
    double most_step_change = 1.0;
    double step_change_of_left = 0.03;

    /// Orders of displacements in the edge length without locking. hex8: 2.5 by a manufactured solution. tet10_fine:
    /// measured 3.6 at nu 0.3 and 3.1 at 0.499; other elements converge with the square.
    double order_hex8 = 2.5;
    double order_tet10_fine = 3.0;
    double order_other = 2.0;
    /// The refined mesh has this many unknowns, its edges between these shares of the setup's: a run takes seconds.
    double fine_unknowns = 8000.0;
    double finest_ratio = 0.5;
    double coarsest_ratio = 0.75;
    /// The refined run in time: half the step, with an integrator of second order.
    double step_ratio = 0.5;
    double step_order = 2.0;
    /// Share of the extrapolated error that remains: orders between 1.5 and 2.5 change the factor by as much.
    double extrapolation_doubt = 0.35;
    /// Changes below this many noise levels are taken to follow their order.
    double asymptotic_change = 3.0;
    /// A step that changes predictions by less [noise levels] is not examined again.
    double negligible_step_error = 0.3;

    /// The effective modulus of the mesh is computed where the numerical error exceeds this [noise levels, rms]; below,
    /// the shift of predictions corrects it.
    double least_error_for_modulus = 0.5;
    double modulus_step = 0.003;       // relative, of its difference quotient
    double most_modulus_change = 0.3;  // relative; more is not the mesh

    /// The error is computed again while taking it off moves predictions by more than this share of the residual.
    double converged_share = 0.3;
    int most_rounds = 3;
    /// A corrected fit is discarded if its squares exceed those of the fit before by this factor.
    double most_growth = 1.2;
    /// Parameters are matched between the coarse and the refined run if the error exceeds the first, until it falls
    /// below the second [noise levels, or the residual's rms if that is larger].
    double least_matched_error = 1.0;
    double matched_error = 0.2;
    int most_matching_steps = 6;
    double least_matching_gain = 0.9;  // a step that leaves a larger share of the error is the last
    /// Directions of parameters whose singular value is below this share of the largest are left alone in matching.
    double least_singular_value = 1e-2;
};

/// Fit of the declared parameters, with which everything is compared.
struct DeclaredFitPolicy {
    Effort effort{30};
    ErrorCorrection correction{{12}, 1.0};
    /// A run that needs this many times the iterations of the declared fit is stopped: its parameters are absurd.
    int most_iteration_ratio = 4;
    /// A fitted damping this many times the expected one compensates for something else.
    double most_damping_ratio = 3.0;
    /// Width of the prior of an effect's vectors, in their scales: data determine a place on a surface in two
    /// directions only.
    double prior_widths = 10.0;
    /// An undeclared mass is at most this many times the body's.
    double most_mass_ratio = 3.0;
};

/// Score tests of all candidates. Source: Rao 1948.
struct ScreeningPolicy {
    /// Scores may be computed with steps so long that predictions change by this share of the residual.
    double step_error_share = 0.3;
    /// A probe that explains less of the residual's squares is not fitted.
    double least_explained = 0.02;
    /// Other places of an effect are fitted if their predicted reduction is at least this share of the best place's.
    double comparable_place = 0.5;
    int most_places = 2;                 // of one effect
    std::size_t most_places_of_all = 6;  // of all effects together

    /// Largest amount of a probe: its part that other parameters do not compensate, and all of it, over the residual.
    /// A softer material with a higher modulus compensates most.
    double most_outside = 2.0;
    double most_over_residual = 30.0;
    /// A probe this many times the residual says nothing about amounts between.
    double nonlinear_ratio = 2.0;
    /// A second start is used where its amount differs from the first by this factor.
    double distinct_start = 2.0;
    /// Exchanged names and slipped markers are scored if undoing them removes this share of the squares. Markers are
    /// centimetres apart: an exchange that happened makes most of the residual.
    double least_swap_gain = 0.2;
    double least_slip_gain = 0.05;
    /// Columns of a probe below this share of its largest do not limit the amount.
    double negligible_column = 0.05;
};

/// Fits of candidates, side by side.
struct CandidateFitPolicy {
    Effort amount{4, 1e-3, 0};      // the amount alone, with the derivatives of the score
    Effort nonlinear{10, 1e-3, 1};  // the same where the way to the amount is nonlinear
    Effort repeated{8, 1e-3, 1};    // the same where the first attempt missed its predicted reduction
    Effort leader{20, 3e-4};        // all parameters of the best, and of those with a large predicted reduction
    Effort other{20, 1e-3, 1};      // of the others
    double relative_step = 1e-5;    // of the parameters, below which a search has converged
    /// The first step of a parameter of unknown order of magnitude changes it by at most this factor, e squared.
    double most_factor = 7.38905609893065;
    /// Secant updates do not serve a candidate with a larger predicted reduction.
    double large_reduction = 0.3;
    /// Candidates whose predicted reduction is at least this share of the leader's are pruned later.
    double comparable_reduction = 0.9;
    /// A fit is repeated if its squares exceed the predicted ones by the first factor, are below the second share of
    /// the base's, and its predicted reduction is at least the third share of the largest.
    double missed_reduction = 1.5;
    double least_progress = 0.95;
    double worth_repeating = 0.8;
};

/// Search for one effect.
struct SearchPolicy {
    /// A score this high, from the fit with its distorted parameters restored, makes that fit the base.
    double sure_base = 0.8;
    std::size_t first_fits = 3;  // before anything is concluded
    /// A fit is pruned when its squares exceed the best by this factor.
    double pruning_factor = 4.0;
    /// Once the best explains the residual, or leaves at most this share of the squares and systematic residuals below
    /// the noise, candidates with less than this share of its predicted reduction are not fitted. The declared fit's
    /// distortion hides up to two thirds of a right one's.
    double least_reduction_beside = 0.25;
    double most_left = 0.5;
    double noise_like = 1.0;  // [noise levels]
    /// A fit with less than this share of the declared excess is nearer to the truth: its numerical error is computed.
    double much_better = 0.3;
    /// A candidate that leaves more than this share of the squares is started again elsewhere.
    double hardly_better = 0.9;
    std::size_t corrected_candidates = 2;  // with numerical errors of their own, before the verdict
    /// Rivals: squares up to this factor of the best.
    double rival_factor = 1.5;
    std::size_t polished_candidates = 3;  // where nothing explains the residual
    std::size_t polished_rivals = 5;
    Effort polish{20, 3e-4};
    ErrorCorrection correction{{20}, 3.0};
    Effort unexplained{4, 1e-3};  // of the best attempt where nothing explains the residual
};

/// Search for a second effect.
struct PairPolicy {
    /// Only if the best effect leaves at most this share of the declared excess.
    double most_left = 0.6;
    double pruning_factor = 1.5;  // lower than for single effects: one of the two is already fitted
};

/// Effects that the experiment cannot distinguish.
struct ConfusionPolicy {
    double least_cosine = 0.97;  // of what two effects do to the residual
    /// An effect with less than this share of the best's predicted reduction is no rival, unless it fits as well.
    double least_reduction = 0.3;
    double comparable_weight = 0.05;  // share of the evidence of fits that are as good as each other
};

/// When a residual needs an explanation, and when a fit is one.
struct JudgementPolicy {
    /// Smallest systematic residual of interest [noise levels]: two simulators of one model differ by as much.
    double least_systematic = 0.3;
    /// Up to here [noise levels] simulators of thin bodies differ; such a residual is faint.
    double faint = 0.5;
    /// A residual below this share of the mesh's error is faint, too, up to a limit [noise levels].
    double faint_share_of_mesh = 2.0 / 3.0;
    double most_faint = 0.8;
    /// Where little of the mesh's error remains after extrapolation, it may be this many times as much, up to a limit
    /// [noise levels].
    double rough_extrapolation = 2.0;
    double most_rough = 0.8;
    /// A mesh with a larger remaining error [noise levels] excuses nothing: it has to be refined.
    double most_allowed = 1.0;
    /// A fit may leave this many times the mesh's remaining error, which was extrapolated.
    double generous = 1.5;
    /// Largest share of the systematic residual that an explanation leaves: of any, and of a faint one.
    double most_of_residual = 0.6;
    double most_of_faint = 0.5;
    /// Another program's form of the same effect leaves this share.
    double share_of_form = 0.05;
    /// The mesh's extrapolation may be wrong by this share, up to a limit [noise levels]; this excuses what a fit
    /// leaves if that is at most the third share of what was there.
    double share_of_mesh = 1.0 / 3.0;
    double most_of_mesh = 0.5;
    double little_left = 0.4;
    /// One-sided 95 % quantile of the normal distribution: a residual exceeds a limit beyond chance.
    double chance_deviations = 1.64;
    /// An effect differs from zero when its amount is this many standard deviations.
    double significant_deviations = 3.0;
    /// An effect leaves at most this share of the excess squares on held-out data; the second is left to chance.
    double most_held_out = 0.5;
    double chance_held_out = 0.05;
    /// Information criteria of dynamic fits exaggerate, as residuals share errors of the model's form: differences are
    /// divided by this before they become weights. The likeliest for pairs of effects of seed 1 that both explained
    /// their case is 15 to 30. See evidence_weights().
    double temperature = 16.0;
    /// Odds against an effect at its bound beside one within its bounds that fits as well.
    double odds_against_bounds = 4.0;
    /// Guard between blocks of time in cross-validation [s]: the longest memory of a residual.
    double guard_s = 0.05;
    /// Largest drift of a measurement [noise levels].
    double most_drift = 3.0;
};

/// The verdict and its confidence.
struct VerdictPolicy {
    /// Confidence in a verdict without any doubt: 153 of 161 such verdicts of seed 1 were right (91 to 98 %), where a
    /// sixth of the effects was not in the catalogue.
    double undoubted = 0.93;
    /// Where the noise was not declared, cameras at rest are far better than any model of a real body: an effect is
    /// named that leaves at most this share of the rms, and this on held-out samples (of the squares 1/4 and 1/2).
    double most_left = 0.5;
    double most_left_held_out = 0.7;
    /// The confidence then falls by this times the share of the rms that is left.
    double discount_of_left = 0.5;
    /// An effect that leaves less of the systematic part is named though a test is still significant: its law may have
    /// another form than ours.
    double nearly_all = 0.125;
    /// Factor of the confidence in it, and in two effects that explain the residual: they may replace one of another
    /// form.
    double other_form = 0.6;
    /// An effect that acts needs this probability in all fits that contain it.
    double present = 0.5;
    /// A second effect is named at this weight: small remainders, of the mesh for instance, are explained by many.
    double second_effect = 0.8;
    /// Factor of the confidence in `unknown` where the best attempt nearly explains the residual, and its growth with
    /// the share that is left. All such answers of seed 1 were right.
    double nearly_explained = 0.8;
    double unexplained_growth = 0.4;
    /// A prediction of trials that took no part is worse if its rms grows by this factor and exceeds this many noise
    /// levels; the confidence is then multiplied by the third.
    double worse_prediction = 1.1;
    double good_prediction = 1.3;
    double contradicted = 0.5;
    /// Factor of the confidence in `none` where the residual is drift of the measurement: no record tells how often
    /// that is right.
    double drift = 0.7;
    /// Factor of the confidence where the effect's amount, or the modulus beside it, ends at its bound.
    double at_bound = 0.5;
    /// Confidence in `none` of a faint residual: this less its share of the allowance, at least the second.
    double faint_allowance = 1.5;
    double least_faint = 0.3;
};

/// The missing force. Source: Morozov 1984 (discrepancy principle); Hansen 1998, ch. 5 (Tikhonov regularisation).
struct MissingForcePolicy {
    int stations = 3;               // of its fields along the body: clamp, middle, far end
    double knot_spacing_s = 0.025;  // of its course
    int least_knots = 12, most_knots = 60;
    int path_samples = 101;      // along the body's axis
    int curve_points = 201;      // of a course, for correlations
    double smoothing_s = 0.025;  // of courses
    /// A step reduces the residual by this share, then by shares that grow by this factor where the run does not
    /// follow.
    double first_share = 0.1;
    double share_factor = 2.0;
    int most_runs = 8;
    double noise_margin = 1.02;  // squares of the residual over those of noise, where the search ends
    double least_gain = 0.97;    // a run that leaves a larger share of the squares is the last
    /// The last percents of what linear forces cannot reach cost the most force: this factor of the least is asked for.
    double reachable = 1.1;
    double lowest_lambda = 1e-9, highest_lambda = 1e3;  // regularisation, over the largest diagonal entry
    int bisections = 80;                                // of its logarithm
    /// A force that explains less of the residual's squares is not reported: its place would be chance.
    double least_explained = 0.05;
    int most_modes = 3;
    /// Modes are reported until they hold this share of the force.
    double reported_share = 0.97;
    double least_mode = 0.01;  // share of a mode that is reported
    // Words for a mode. A uniform force has its middle at 0.5 of the length and a spread of 0.29.
    double least_aligned = 0.3;    // below: opposite directions, like a moment
    double along_axis = 0.9;       // component of the direction
    double least_component = 0.3;  // that is named between axes
    double at_end = 0.75, near_end = 0.6, near_clamp = 0.4, at_clamp = 0.25;  // of the length
    double concentrated = 0.24;  // spread below which a force acts at the middle
};

struct DiagnosisPolicy {
    NumericsPolicy numerics;
    DeclaredFitPolicy declared;
    ScreeningPolicy screening;
    CandidateFitPolicy fits;
    SearchPolicy search;
    PairPolicy pairs;
    ConfusionPolicy confusion;
    JudgementPolicy judgement;
    VerdictPolicy verdict;
    MissingForcePolicy force;
};
inline constexpr DiagnosisPolicy diagnosis_policy;

}  // namespace myo::diagnosis
