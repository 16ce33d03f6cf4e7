#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>

namespace myo::ui::commands {

/// Files with the body for other programs: ParaView; printing and CAD; viewers and web pages.
enum class ShapeFormat { vtu, stl, glb };

/// Request to write the shown body.
struct ShapeExport {
    std::filesystem::path path;  // its extension is that of the format; .pvd for all frames
    ShapeFormat format = ShapeFormat::vtu;
    bool all_frames = false;        // vtu only: every frame of the shown trial, with a collection (.pvd)
    double metres_per_unit = 1e-3;  // stl only, which names no unit: 1e-3 writes millimetres
};

/// The body in one frame, for a file.
struct ShapeFrame {
    Eigen::Matrix3Xd positions_m;  // of the nodes, 3 x n [m], mesh frame
    std::string field;             // name of the values, with unit; empty: none
    Eigen::VectorXd values;        // per node, in that unit; empty: none
    Eigen::Matrix3Xf colours;      // per node, red, green, blue, 0 to 1, as shown; empty: none
    double metres_per_unit = 1.0;  // stl: length of the file's unit [m]
};

}  // namespace myo::ui::commands
