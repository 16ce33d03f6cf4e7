#include "bench/published_beam.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "base/files.hpp"
#include "base/text.hpp"
#include "bench/beam_statics.hpp"
#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"

namespace myo::bench {

model::DeadForce force_on_upper_tip_edge(const mesh::VolumeMesh& mesh, double force_N) {
    const Box box = mesh::bounding_box(mesh.nodes);
    model::DeadForce force;
    force.share = Eigen::VectorXd::Zero(mesh.node_count());
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        // Equal shares, as in the published scripts: the force does not follow from a traction.
        if (mesh.nodes(0, i) > box.highest(0) - mesh::region_tolerance(mesh) &&
            mesh.nodes(2, i) > box.highest(2) - mesh::region_tolerance(mesh))
            force.share(i) = 1.0;
    force.share /= force.share.sum();
    force.force_N = {0.0, 0.0, force_N};
    return force;
}

const std::vector<PublishedTrace>& published_traces() {
    // Edges that reproduce the published counts of cubes; the force as in the published scripts.
    static const double coarse = 0.1 / 23.5, fine = 0.1 / 32.9, newtons = -1.00062;
    static const std::vector<PublishedTrace> traces = {
        {"hexA1_4608_h0.01_tol1e-7.csv", coarse, 0.0, 0.01, 6e-6, -6.046, -4.434},
        {"hexA1_4608_h0.01.csv", coarse, 0.0, 0.01, 6e-3, -6.046, -4.434},
        {"hexA1_4608_h0.005.csv", coarse, 0.0, 0.005, 2.4e-2, -6.046, -4.434},
        {"hexD_4608_h0.01.csv", coarse, newtons, 0.01, 6e-3, -20.14, -18.54},
        {"hexE_9900_h0.01.csv", fine, newtons, 0.01, 6e-3, -27.99, -26.56},
    };
    return traces;
}

model::Model published_beam(const PublishedTrace& trace, model::MassModel mass) {
    const Box beam{{-0.1, 0.0, 0.0}, {0.0, 0.03, 0.03}};
    const Result<mesh::GridLines> grid = mesh::whole_cube_lines(beam, trace.edge_m, {true, false, false});
    assert(grid);
    mesh::VolumeMesh mesh = mesh::hex_mesh(*grid);
    // The clamped end is that of the mesh: whole cubes end before x = -0.1 m.
    Box clamp = mesh::bounding_box(mesh.nodes);
    clamp.highest(0) = clamp.lowest(0);
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, clamp);
    model::Model model;
    model.body = model::make_body(std::move(mesh), fem::ElementKind::hex8_full, clamped);
    model.material = material::find_material("projective_corotational");
    model.moduli = model::uniform_moduli(model.body->cell_count(), 263824.0, 0.499);
    model.density_kg_m3 = 1070.0;
    model.mass_model = mass;
    model.gravity_m_s2 = {0.0, 0.0, -beam_gravity_m_s2};
    if (trace.tip_force_N != 0.0) model.forces.push_back(force_on_upper_tip_edge(model.body->mesh, trace.tip_force_N));
    return model;
}

int published_node(const mesh::VolumeMesh& mesh) {
    const Box box = mesh::bounding_box(mesh.nodes);
    const Eigen::Vector3d corner(box.highest(0), box.lowest(1), box.highest(2));
    // Mean edge from volume and number of cells: all cells are cubes of one size.
    const double edge = std::cbrt(box.size().prod() / static_cast<double>(mesh.cell_count()));
    Eigen::Index node = 0;
    (mesh.nodes.colwise() - (corner - Eigen::Vector3d(0.0, 0.0, edge))).colwise().squaredNorm().minCoeff(&node);
    return static_cast<int>(node);
}

Result<NodeTrace> read_node_trace(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    std::istringstream lines(*content);
    std::string line;
    std::vector<std::array<double, 4>> rows;
    const auto four_numbers = [&](int number) {
        return Error{"four numbers are expected: time, x, y, z", path.string() + ":" + std::to_string(number)};
    };
    std::getline(lines, line);  // the heading
    // Lines are counted from 1; the heading is the first.
    for (int number = 2; std::getline(lines, line); ++number) {
        std::istringstream fields(line);
        std::string field;
        std::array<double, 4> row{};
        for (double& value : row)
            if (!std::getline(fields, field, ',') || !parse_number(field, value) || !std::isfinite(value))
                return four_numbers(number);
        if (fields.peek() != std::istringstream::traits_type::eof()) return four_numbers(number);
        rows.push_back(row);
    }
    if (rows.empty()) return Error{"the trace has no samples", path.string()};
    NodeTrace trace;
    trace.positions.resize(3, static_cast<Eigen::Index>(rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) {
        trace.times_s.push_back(rows[k][0]);
        trace.positions.col(static_cast<Eigen::Index>(k)) << rows[k][1], rows[k][2], rows[k][3];
    }
    return trace;
}

std::filesystem::path data_folder() {
    const char* const named = std::getenv("MYOLOOP_DATA");
    return named != nullptr ? std::filesystem::path(named) : std::filesystem::path("../shared");
}

double trace_deviation(const dynamics::Trace& run, int node, const NodeTrace& trace) {
    double largest = 0.0, deflection = 0.0;
    for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
        assert(k < run.times_s.size() && std::abs(run.times_s[k] - trace.times_s[k]) < 1e-6);
        const Eigen::Vector3d there = trace.positions.col(static_cast<Eigen::Index>(k));
        largest = std::max(largest, (run.positions[k].col(node) - there).norm());
        deflection = std::max(deflection, (there - trace.positions.col(0)).norm());
    }
    return largest / deflection;
}

}  // namespace myo::bench
