#pragma once

#include <filesystem>
#include <vector>

#include "model/cavity_pressure.hpp"
#include "reproduce/muscle_body.hpp"

namespace myo::reproduce {

/// An arm with pressure chambers. The fine mesh of the paper's arm was not published; this one is a plain substitute.
///
/// Outer size 44.4 x 44.4 x 100 mm, walls of 6 mm, a cross of 6 mm webs between four chambers of square section; hangs
/// from z = 0.1 m. Without ribs, flat walls of 3 mm balloon below 200 mbar.
struct ChamberedArm {
    model::Model model;             // without pressure
    measurement::MarkerSet points;  // midpoints of the lower face's edges
    std::vector<int> walls;         // boundary faces of the chambers at +x
    int chambers = 0;               // number of closed cavities
};

/// Optional geometry of the user, in mm and in the pose of the plain arm; its closed cavities are the chambers.
std::filesystem::path chamber_geometry_file(const ReproduceSettings& settings);

/// The arm from that file if it exists, otherwise the plain arm.
///
/// @param edge_m  edge length of the cells
/// Errors: those of the file and of the mesher; no chamber at +x.
Result<ChamberedArm> make_chambered_arm(const ReproduceSettings& settings, double edge_m);

/// The plain arm with filled chambers and muscles along z in place of those at +x (first muscle) and -x. Its points are
/// those of the chambered arm, so that the two can be compared.
///
/// @param muscles  1 or 2
MuscleBody filled_arm(double edge_m, int muscles);

}  // namespace myo::reproduce
