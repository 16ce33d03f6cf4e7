#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/repeatability.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

/// First phase of a diagnosis: data, time steps and fit of the declared model.
struct DeclaredFit {
    setup::Setup setup;                           // with the cells, steps and iteration limits of all later fits
    std::shared_ptr<const setup::Setup> coarser;  // the given setup on these cells; null: they are its own
    FitData data;                                 // of the fit trials, without a shift
    double cell_change_m = 0.0;                   // of predictions by them [m, rms]
    std::vector<double> step_factors;             // per trial: steps over those of the given setup; empty: 1
    JudgedFit fit;                                // its numerical error is not known yet
    Repeatability repeatability;                  // of all trials
    std::vector<std::string> notes;
    std::string failure;  // reason why the declared model could not be fitted; empty also if cancelled

    /// False if the fit failed or was cancelled.
    bool usable() const { return fit.usable(); }
};

/// Chooses data and time steps, and fits the declared model.
///
/// Cells are coarsened and steps lengthened while predictions change by less than NumericsPolicy allows, and further if
/// the fit leaves much. Explicit edges and steps (setup.settings) are kept. Later runs are stopped at a multiple of the
/// iterations of this fit (DeclaredFitPolicy).
/// @param setup  see prepared_setup()
DeclaredFit fit_declared(const setup::Setup& setup, const DiagnoseSettings& settings, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
