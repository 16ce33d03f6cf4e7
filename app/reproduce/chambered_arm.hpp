#pragma once

#include <filesystem>
#include <vector>

#include "model/cavity_pressure.hpp"
#include "reproduce/muscle_body.hpp"

namespace myo::reproduce {

/// An arm with pressure chambers: the paper's fine mesh of its arm was not published, so this one is plain and our own.
/// Outside 44.4 x 44.4 x 100 mm, walls of 6 mm, a cross of webs 6 mm thick between four chambers of square section;
/// hangs from z = 0.1 m. Without ribs, flat walls of 3 mm balloon below 200 mbar.
struct ChamberedArm {
    model::Model model;             // chambers without pressure
    measurement::MarkerSet points;  // middles of the lower face's sides
    std::vector<int> walls;         // of the chambers at +x
    int chambers = 0;               // all of them
};

/// The file of a geometry of one's own, in mm, standing as the plain arm does: closed cavities are its chambers.
std::filesystem::path chamber_geometry_file(const ReproduceSettings& settings);

/// From that file where it is there, otherwise the plain arm. Errors: those of the file and of the mesher; no chamber
/// at +x.
Result<ChamberedArm> make_chambered_arm(const ReproduceSettings& settings, double edge_m);

/// The plain arm with its chambers filled, muscles along z in place of those at +x (the first) and at -x.
MuscleBody filled_arm(double edge_m, int muscles);

}  // namespace myo::reproduce
