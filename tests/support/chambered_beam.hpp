#pragma once

#include <string>
#include <vector>

#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"
#include "support/experiment_folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::test {

/// ASCII STL of a box with boxes inside, which are cavities. Axis-aligned; lengths in m.
inline std::string hollow_box_stl(const Box& outer, const std::vector<Box>& cavities) {
    std::string text = "solid body\n";
    const auto add = [&](const Box& box, bool inward) {
        const mesh::SurfaceMesh surface = mesh::box_surface(box);
        for (const auto& corners : surface.triangles.colwise()) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int k : {0, inward ? 2 : 1, inward ? 1 : 2}) {
                char line[96];
                const Eigen::Vector3d at = surface.vertices.col(corners(k));
                std::snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", at.x(), at.y(), at.z());
                text += line;
            }
            text += "endloop\nendfacet\n";
        }
    };
    add(outer, false);
    for (const Box& cavity : cavities) add(cavity, true);
    return text + "endsolid body\n";
}

/// Tendon "upper" above the axis of the swung beam, with four guides; the first stands still in the clamp.
///
/// @param height_m  of the guides
inline experiment::TendonDeclaration upper_tendon(
    const Eigen::RowVector4d& height_m = Eigen::RowVector4d::Constant(0.028)) {
    experiment::TendonDeclaration tendon;
    tendon.name = "upper";
    tendon.path_m.resize(3, 4);
    tendon.path_m.row(0) << 0.0, 0.03, 0.06, 0.095;
    tendon.path_m.row(1).setConstant(0.015);
    tendon.path_m.row(2) = height_m;
    return tendon;
}

/// The swung beam with a chamber "upper" of 70 x 18 x 8 mm above its middle. Its pressure is 0 until a trial names it.
/// Not read from a file: `change` may alter the experiment before it is prepared.
template <class Change>
setup::Setup chambered_beam(const Folder& folder, double end_s, const Change& change) {
    swung_beam(folder, end_s);  // writes the traces
    folder.write("body.stl",
                 hollow_box_stl({{0, 0, 0}, {0.1, 0.03, 0.03}}, {{{0.015, 0.006, 0.017}, {0.085, 0.024, 0.025}}}));
    folder.write("experiment.toml",
                 testing_support::replaced(swung_beam_toml(), "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]",
                                           "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"m\""));
    Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    experiment->chambers.push_back({"upper", {0.05, 0.015, 0.02}});
    change(*experiment);
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.02;
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings);
    EXPECT_TRUE(setup) << setup.error().text();
    return std::move(*setup);
}

}  // namespace myo::test
