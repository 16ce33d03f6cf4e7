#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <memory>

#include "base/overwrites.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_parts.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/volume_reader.hpp"
#include "mesh/vtk_writer.hpp"
#include "options.hpp"
#include "report/json.hpp"
#include "setup/body_mesh.hpp"
#include "setup/tetrahedra_surface.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop mesh`.
struct MeshCall {
    std::filesystem::path file;
    std::filesystem::path out;  // VTU file; empty: none
    std::optional<mesh::CellType> type;
    std::optional<double> resolution_m;     // edge length
    std::optional<double> max_volume_m3;    // of a tetrahedron
    std::optional<double> quality;          // largest circumradius over shortest edge, tetrahedra
    std::optional<double> metres_per_unit;  // unit of the file
    bool json = false;
    WorkOptions work;
};

/// Mesh made or checked, nodes [m], with its quality.
struct MeshOutcome {
    mesh::VolumeMesh mesh;
    mesh::QualityReport quality;
    std::vector<std::string> warnings;
};

/// Extension with its point, in lower case: files from other systems are often in capitals.
std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

// Formats of the window as well, see app/backend/core_scene.cpp.
const std::vector<std::string> surface_extensions{".stl", ".obj", ".ply", ".vtp"};
const std::vector<std::string> volume_extensions{".vtu", ".vtk", ".msh", ".node", ".ele"};

bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Surface in metres with merged vertices, outward and of plausible size; corrections are reported as warnings.
///
/// Errors: no unit, those of the reader, an implausible size, a surface that is open or not manifold, parts that cannot
/// be turned.
Result<mesh::SurfaceMesh> open_surface(const MeshCall& call, std::vector<std::string>& warnings) {
    if (!call.metres_per_unit) return Error{"a surface file does not say its unit; state m or mm", "--unit"};
    const Result<mesh::SurfaceMesh> read = mesh::read_surface(call.file, *call.metres_per_unit,
                                                              Eigen::Matrix3d::Identity(), &warnings);
    if (!read) return read.error();
    mesh::SurfaceMesh surface = mesh::weld(*read);
    const mesh::SurfaceReport report = mesh::check_surface(surface);
    // Size before topology: a wrong unit is named as such.
    if (const Result<void> size = mesh::check_plausible_size(report.size); !size)
        return Error{size.error().what, call.file.string()};
    if (!report.closed || !report.manifold)
        return Error{"cannot be meshed: " +
                         (report.messages.empty() ? "the surface is not closed" : join(report.messages, "; ")),
                     call.file.string()};
    // A surface whose normals all point inward is turned, not refused.
    if (report.oriented && !report.outward) surface = mesh::flipped(std::move(surface));
    Result<mesh::FacingParts> parts = mesh::facing_parts(surface);
    if (!parts) return Error{parts.error().what, call.file.string()};
    warnings.insert(warnings.end(), report.messages.begin(), report.messages.end());
    warnings.insert(warnings.end(), parts->notes.begin(), parts->notes.end());
    return std::move(parts->surface);
}

/// Checks that the options suit the element and that the number of elements is within the limit.
Result<void> check_surface_call(const MeshCall& call, const mesh::SurfaceMesh& surface) {
    if (!call.type) return Error{"choose the element of the mesh: hex8, tet4 or tet10", "--type"};
    const bool hexahedra = *call.type == mesh::CellType::hex8;
    if (hexahedra && call.max_volume_m3)
        return Error{"only tetrahedra take a largest volume; hexahedra have --resolution", "--max-volume"};
    if (hexahedra && call.quality) return Error{"only tetrahedra take a quality", "--quality"};
    if (call.quality && *call.quality < 1.2)
        return Error{"a radius-edge ratio below 1.2 may never be reached", "--quality"};
    if (!call.resolution_m && !call.max_volume_m3) return Error{"state the edge length in metres", "--resolution"};
    // Without --resolution, the edge of a regular tetrahedron of the largest volume.
    const double edge = call.resolution_m.value_or(mesh::tet_edge_for_volume(call.max_volume_m3.value_or(1.0)));
    const double cells = mesh::estimate_counts(surface, *call.type, edge).cells;
    if (cells > mesh::box_mesh_policy.max_grid_cells)
        return Error{"this would make about " + format_number(cells, 2) + " elements; the limit is 2 million",
                     call.resolution_m ? "--resolution" : "--max-volume"};
    return {};
}

/// Meshes a surface file with the requested element. Errors: those of the call, the surface and the mesher; cancelled.
Result<MeshOutcome> mesh_surface(const MeshCall& call, const Progress& progress) {
    MeshOutcome outcome;
    const Result<mesh::SurfaceMesh> surface = open_surface(call, outcome.warnings);
    if (!surface) return surface.error();
    if (const Result<void> fine = check_surface_call(call, *surface); !fine) return fine.error();
    if (*call.type == mesh::CellType::hex8) {
        Result<setup::BodyMesh> mesh = setup::mesh_body(
            *surface, {fem::default_element(mesh::CellType::hex8), call.resolution_m}, {}, progress);
        if (!mesh) return mesh.error();
        outcome.mesh = std::move(mesh->mesh);
    } else {
        mesh::TetOptions options;
        options.type = *call.type;
        options.edge = call.resolution_m;
        options.max_volume = call.max_volume_m3;
        if (call.quality) options.radius_edge_ratio = *call.quality;
        // TetGen keeps the triangles of the surface, so those are brought to the size of the tetrahedra first.
        const double edge = call.max_volume_m3 ? mesh::tet_edge_for_volume(*call.max_volume_m3) : *call.resolution_m;
        const mesh::SizedSurface sized = setup::surface_for_tetrahedra(*surface, edge, progress);
        outcome.warnings.insert(outcome.warnings.end(), sized.notes.begin(), sized.notes.end());
        Result<mesh::VolumeMesh> mesh = mesh::tetrahedralize(sized.surface, options, progress);
        if (!mesh) return mesh.error();
        outcome.mesh = std::move(*mesh);
    }
    // Volume error against the surface of the file, not against the resized one.
    outcome.quality = mesh::mesh_quality(outcome.mesh, &*surface);
    return outcome;
}

/// Reads a volume mesh and converts it if possible; tet4 to tet10 is the only conversion. Without --unit the lengths
/// are metres, with a warning.
///
/// Errors: an option of meshing; those of the reader; another conversion; an implausible size.
Result<MeshOutcome> check_volume(const MeshCall& call) {
    if (call.resolution_m || call.max_volume_m3 || call.quality)
        return Error{"is a volume mesh already: its elements can be checked and converted, not remeshed",
                     call.file.string()};
    Result<mesh::VolumeMesh> mesh = mesh::read_volume(call.file, call.metres_per_unit.value_or(1.0));
    if (!mesh) return mesh.error();
    MeshOutcome outcome;
    if (!call.metres_per_unit)
        outcome.warnings.push_back("the file's lengths are taken as metres; if they are not, state --unit");
    // Without --type the mesh stays as it is.
    const mesh::CellType type = call.type.value_or(mesh->type);
    if (type == mesh::CellType::tet10 && mesh->type == mesh::CellType::tet4) *mesh = mesh::to_tet10(*mesh);
    if (mesh->type != type)
        return Error{"a mesh of " + to_string(mesh->type) + " cannot become one of " + to_string(type), "--type"};
    if (const Result<void> size = mesh::check_plausible_size(mesh::bounding_box(mesh->nodes).size()); !size)
        return Error{size.error().what, call.file.string()};
    outcome.mesh = std::move(*mesh);
    outcome.quality = mesh::mesh_quality(outcome.mesh);
    return outcome;
}

/// What --json prints (schema mesh/1), SI units, angles in degrees.
report::Json outcome_json(const MeshCall& call, const MeshOutcome& outcome) {
    const mesh::QualityReport& q = outcome.quality;
    report::Json json{{"schema", "mesh/1"},
                      {"file", call.file.string()},
                      {"element", to_string(outcome.mesh.type)},
                      {"nodes", q.nodes},
                      {"elements", q.cells},
                      {"dofs", q.dofs},
                      {"mean_edge_m", report::json_number(q.mean_edge)},
                      {"volume_m3", report::json_number(q.volume)}};
    if (q.volume_error) json["volume_error"] = report::json_number(*q.volume_error);
    json["quality"] = {{"measure", q.measure},
                       {"least", report::json_number(q.least)},
                       {"mean", report::json_number(q.mean)},
                       {"worst_element", q.worst_cell},
                       {"histogram", q.histogram},
                       {"least_dihedral_deg", report::json_number(q.min_dihedral_deg)},
                       {"largest_dihedral_deg", report::json_number(q.largest_dihedral_deg)}};
    json["components"] = q.components;
    json["warnings"] = outcome.warnings;
    if (!call.out.empty()) json["out"] = call.out.string();
    return json;
}

/// Counts, volume, angles and a histogram of the element quality.
std::string outcome_text(const MeshOutcome& outcome) {
    const mesh::QualityReport& q = outcome.quality;
    std::string text = std::to_string(q.cells) + " " + to_string(outcome.mesh.type) + " elements, " +
                       std::to_string(q.nodes) + " nodes, " + std::to_string(q.dofs) + " degrees of freedom\nedges " +
                       format_number(1e3 * q.mean_edge, 3) + " mm on average, volume " +
                       format_number(1e6 * q.volume, 5) + " cm3";
    char line[128];
    if (q.volume_error) {
        std::snprintf(line, sizeof line, " (%+.3g %% from the surface's)", 100.0 * *q.volume_error);
        // An exact fill leaves rounding only, which is not worth a number.
        text += std::abs(*q.volume_error) < 1e-8 ? " (that of the surface)" : line;
    }
    std::snprintf(line, sizeof line, "\ndihedral angles %.1f to %.1f degrees\n\n", q.min_dihedral_deg,
                  q.largest_dihedral_deg);
    text += line + q.measure + " (1 is perfect): least " + format_number(q.least, 3) + ", mean " +
            format_number(q.mean, 3);
    // Bins of a tenth; the longest bar has 40 characters.
    const int most = *std::max_element(q.histogram.begin(), q.histogram.end());
    for (std::size_t i = 0; i < q.histogram.size(); ++i) {
        const int count = q.histogram[i];
        // A single element among many still gets a bar of length 1.
        const int length = count == 0 ? 0 : std::max(1, static_cast<int>(std::lround(40.0 * count / most)));
        std::snprintf(line, sizeof line, "\n%.1f-%.1f %8d  ", 0.1 * static_cast<double>(i),
                      0.1 * static_cast<double>(i + 1), count);
        text += line + std::string(static_cast<std::size_t>(length), '#');
    }
    return text;
}

/// Errors of the call that are known before the file is read.
Result<void> check_mesh_call(const MeshCall& call) {
    if (call.file.empty()) return Error{"name a surface or a volume mesh", ""};
    if (!call.out.empty() && extension_of(call.out) != ".vtu")
        return Error{"'" + call.out.string() + "' does not end in .vtu", "--out"};
    const std::string extension = extension_of(call.file);
    if (!contains(surface_extensions, extension) && !contains(volume_extensions, extension))
        return Error{"no mesh format is known by this extension; surfaces: " + join(surface_extensions, " ") +
                         ", volumes: " + join(volume_extensions, " "),
                     call.file.string()};
    if (const Result<void> kept = check_overwrites("--out", {call.out}, {call.file}); !kept) return kept.error();
    return {};
}

/// Meshes a surface or checks a volume mesh, by the extension of the file.
int mesh_command(const MeshCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    if (const Result<void> checked = check_mesh_call(call); !checked) return console.refuse(checked.error());
    const bool is_surface = contains(surface_extensions, extension_of(call.file));
    const Progress progress = console.progress();
    Result<MeshOutcome> outcome = is_surface ? mesh_surface(call, progress) : check_volume(call);
    if (progress.cancelled()) {
        console.complain("stopped; nothing was written");
        return status_stopped;
    }
    if (!outcome) return console.refuse(outcome.error());
    outcome->warnings.insert(outcome->warnings.end(), outcome->quality.messages.begin(),
                             outcome->quality.messages.end());
    for (const std::string& warning : outcome->warnings) console.warn(warning);
    if (call.json)
        print_text(report::json_text(outcome_json(call, *outcome)));
    else
        console.print(outcome_text(*outcome));
    if (!call.out.empty()) {
        // Quality per cell, so that a viewer shows where bad elements lie.
        const Eigen::MatrixXd shapes = mesh::cell_shapes(outcome->mesh).transpose();
        if (const Result<void> written = mesh::write_vtu(call.out, outcome->mesh, {}, {{"quality", shapes}}); !written)
            return console.fail(written.error());
        if (!call.json) console.print("\nwritten to " + call.out.string());
    }
    return status_done;
}

}  // namespace

std::function<int()> declare_mesh(CLI::App& app) {
    // Options of one kind of file only are declared for both; mesh_surface() and check_volume() refuse the others.
    const auto call = std::make_shared<MeshCall>();
    app.add_option("FILE", call->file, "surface (stl, obj, ply, vtp) or volume mesh (vtu, vtk, msh, node, ele)")
        ->type_name("");
    app.add_option_function<std::string>(
           "--type,--element",
           [call](const std::string& name) {
               call->type = mesh::find_cell_type(name);
               if (!call->type) throw CLI::ValidationError("--type", unknown_word(name, mesh::cell_type_names()));
           },
           "element: " + join(mesh::cell_type_names()))
        ->type_name("NAME");
    add_positive_number(app, "--resolution", call->resolution_m, "edge length [m]")->type_name("METRES");
    add_unit(app, call->metres_per_unit);
    add_positive_number(app, "--max-volume", call->max_volume_m3, "largest volume of a tetrahedron [m3]")
        ->type_name("M3");
    add_positive_number(app, "--quality", call->quality,
                        "largest circumradius over shortest edge of a tetrahedron, from 1.2 on (default 1.414)")
        ->type_name("RATIO");
    app.add_option("--out", call->out, "volume mesh to write")->type_name("X.vtu");
    app.add_flag("--json", call->json, "print the figures as JSON");
    add_work_options(app, call->work);
    return [call] { return mesh_command(*call); };
}

}  // namespace myo::app
