#pragma once

#include <array>

namespace myo::diagnosis {

/// Numerical error of the runs and its removal. Source: Richardson 1911 (extrapolation); Roache 1998, ch. 5.
struct NumericsPolicy {
    /// Relative residual of nodal forces in the implicit stages of all runs: motions are exact to 1 % of usual noises.
    double solver_tolerance = 1e-6;
    /// Relative residual of the linear systems of derivatives: a fit needs the direction of a step, not all digits.
    double tangent_tolerance = 1e-4;

    /// Steps are lengthened while predictions change by at most this [noise levels, rms]: so small an error follows
    /// its order and can be removed. The limit is this share of the residual of the declared fit if that is more: a law
    /// of another form than an effect's leaves a twentieth.
    double max_step_change = 1.0;
    double step_change_of_left = 0.03;

    /// Edges of coarser cells over those of the setup, from the coarsest on: the first is taken whose cells change
    /// predictions by at most this [noise levels, rms], or by this share of the residual of the declared fit, apart
    /// from what another modulus makes up for. At 0.5 noise levels the predicted trial of a synthetic beam was left
    /// with 1.8; half the layers of example_viscoelastic change it by 1.8, with a second effect that is not there.
    std::array<double, 2> cell_ratios{2.0, 1.5};
    double max_cell_change = 0.25;
    double cell_change_of_left = 0.05;
    double max_share_of_unknowns = 0.7;  // of the setup's; coarser cells that keep more save too little

    /// Orders of convergence of displacements with the edge length, without locking. hex8: 2.5 by a manufactured
    /// solution. tet10_fine: measured 3.6 at nu 0.3 and 3.1 at 0.499. Other elements: second order.
    double order_hex8 = 2.5;
    double order_tet10_fine = 3.0;
    double order_other = 2.0;
    /// Unknowns of the refined mesh, and limits of its edge length over that of the setup: a run takes seconds.
    double fine_unknowns = 8000.0;
    double finest_ratio = 0.5;
    double coarsest_ratio = 0.75;
    /// The refined run in time: half the step, with an integrator of second order.
    double step_ratio = 0.5;
    double step_order = 2.0;
    /// Relative error of the extrapolation: orders between 1.5 and 2.5 change its factor by as much.
    double extrapolation_doubt = 0.35;
    double doubt_of_corners = 1.0;  // of the errors of a force with a corner, which follow no order
    /// A change by the finer mesh below this many noise levels is assumed to follow its order.
    double asymptotic_change = 3.0;
    /// The step error is not computed again if the change by half the step is below this [noise levels].
    double negligible_step_error = 0.3;

    /// The effective modulus is computed if the numerical error exceeds this [noise levels, rms]; a smaller error is
    /// corrected by the shift of predictions alone.
    double min_error_for_modulus = 0.5;
    double modulus_step = 0.003;      // relative step of its difference quotient
    double max_modulus_change = 0.3;  // relative; a larger change is not due to the mesh

    /// The error is computed again while its removal changes predictions by more than this share of the residual.
    double converged_share = 0.3;
    int max_rounds = 3;
    /// A corrected fit is discarded if its squared residual exceeds that of the previous fit by this factor.
    double max_growth = 1.2;
    /// Parameters are matched between the coarse and the refined runs if the error exceeds the first value, until it
    /// falls below the second [noise levels, or the rms of the residual if that is larger].
    double min_matched_error = 1.0;
    double matched_error = 0.2;
    int max_matching_steps = 6;
    /// An iteration that leaves a larger share of the error is the last: one takes as long as fifteen evaluations of a
    /// fit (10 s and 0.7 s in example_two_effects).
    double min_matching_gain = 0.6;
    /// Matching does not change directions of parameters whose singular value is below this share of the largest.
    double min_singular_value = 1e-2;
};

}  // namespace myo::diagnosis
