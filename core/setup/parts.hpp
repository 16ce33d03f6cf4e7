#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "material/moduli.hpp"
#include "mesh/surface_mesh.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

struct PartPolicy {
    /// Points per direction of a cell at which a part given by a surface is sought, first, and where these differ: an
    /// error of the share of 4 % at most for a flat interface along the cell, less for an oblique one.
    int first_points = 3, points = 12;
    double least_share = 1e-6;  // of the body's volume; below it a part holds no material
    /// Share of the cells' volume that lies in cells of mixed material, above which a warning is given.
    double told_mixed = 0.02;
};
inline constexpr PartPolicy part_policy;

/// Shares of the materials in each cell by volume: column 0 is the body's own, column 1 + k that of part k. Rows sum to
/// 1. Of parts that overlap the later one counts.
///
/// Parts given by boxes are cut exactly; those given by surfaces by sample points; those given by regions hold whole
/// cells; painted ones take the weights of their mask, which is resampled if it was painted on another mesh.
/// @param warnings  contradictions of masks, and cells of mixed material, whose modulus is the mean by volume (Voigt).
///                  Measured on a bar of two layers (4 : 1) whose interface cuts the lower of two layers of cells:
///                  bends 9 % too far
/// Errors, with key and line: a file that cannot be read or is not closed; a mask that is missing or cannot be read; a
/// region that no cell has; a part without material.
Result<Eigen::MatrixXd> part_shares(const experiment::Experiment& experiment, const BodyMesh& mesh,
                                    std::vector<std::string>& warnings);

/// Values of the materials that a fit may change.
struct MaterialValues {
    double youngs_modulus_Pa = 0.0;         // of the body
    double damping_s = 0.0;                 // of the body
    std::vector<double> part_modulus_Pa{};  // per part, in the order of declaration
    std::vector<double> part_damping_s{};   // NaN: the body's
};
/// Declared values; `damping_s` for the body, whose declaration may lack it.
MaterialValues declared_materials(const experiment::Experiment& experiment, double damping_s);

/// Moduli of the cells [Pa]: means by volume.
///
/// @param factor  on all moduli
std::vector<material::Moduli> mixed_moduli(const experiment::Experiment& experiment, const Eigen::MatrixXd& shares,
                                           const MaterialValues& values, double factor);

/// Damping time of each cell beyond that of the body [s], such that the viscous moduli are means by volume. Empty if no
/// part has its own.
std::vector<double> damping_excess(const experiment::Experiment& experiment, const Eigen::MatrixXd& shares,
                                   const MaterialValues& values);

/// Density of each cell over that of the body; empty if all parts have the body's.
std::vector<double> density_factors(const experiment::Experiment& experiment, const Eigen::MatrixXd& shares);

/// Boxes of parts, whose faces the mesh should meet.
std::vector<Box> part_boxes(const experiment::Experiment& experiment);

}  // namespace myo::setup
