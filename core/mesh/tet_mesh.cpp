#include "mesh/tet_mesh.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include <Eigen/Geometry>

#include "base/child_process.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/mesh_repair.hpp"
#include "mesh/quality.hpp"
#include "mesh/region_facets.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/tetgen_exchange.hpp"

namespace myo::mesh {
namespace {
namespace fs = std::filesystem;

// Temporary folder, removed with its content on scope exit.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code code;
        std::string name = (fs::temp_directory_path(code) / "myoloop_XXXXXX").string();
        if (!code && ::mkdtemp(name.data()) != nullptr) path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code code;
        if (!path_.empty()) fs::remove_all(path_, code);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Path of the worker: environment variable MYOLOOP_TETGEN, otherwise the folder of the program.
Result<fs::path> find_worker() {
    std::error_code code;
    // An explicitly named worker takes precedence over the one next to the program.
    if (const char* named = std::getenv("MYOLOOP_TETGEN"); named != nullptr && *named != '\0') {
        if (fs::is_regular_file(named, code)) return fs::path(named);
        return Error{"the tetrahedral mesher named by MYOLOOP_TETGEN does not exist", named};
    }
    // Next to the program itself, wherever it was started from.
    const fs::path beside = fs::read_symlink("/proc/self/exe", code).parent_path() / "myoloop-tetgen";
    if (fs::is_regular_file(beside, code)) return beside;
    return Error{"the tetrahedral mesher myoloop-tetgen is not next to the program; set MYOLOOP_TETGEN to its path",
                 ""};
}

// A point inside each cavity: from the centre of one of its triangles half way to the opposite surface.
std::vector<double> cavity_points(const SurfaceMesh& surface, const SurfaceTopology& topology) {
    std::vector<double> holes;
    for (int part = 0; part < topology.parts; ++part) {
        // A part with negative volume is oriented inward, that is, a cavity.
        SurfaceMesh alone{surface.vertices, {}};
        std::vector<Eigen::Index> own;
        for (std::size_t t = 0; t < topology.part.size(); ++t) {
            if (topology.part[t] == part) own.push_back(static_cast<Eigen::Index>(t));
        }
        alone.triangles = surface.triangles(Eigen::all, own);
        if (enclosed_volume(alone) >= 0.0) continue;

        // The largest triangle has the most accurate normal.
        double largest = -1.0;
        Eigen::Vector3d start, direction;
        for (Eigen::Index t = 0; t < alone.triangles.cols(); ++t) {
            const Eigen::Vector3d a = alone.vertices.col(alone.triangles(0, t)),
                                  b = alone.vertices.col(alone.triangles(1, t)),
                                  c = alone.vertices.col(alone.triangles(2, t));
            const Eigen::Vector3d normal = (b - a).cross(c - a);
            if (normal.norm() > largest)
                largest = normal.norm(), start = (a + b + c) / 3.0, direction = normal.normalized();
        }
        double nearest = std::numeric_limits<double>::infinity();
        const double skip = 1e-9 * bounding_box(surface.vertices).size().norm();
        for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
            Eigen::Matrix3d M;
            const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t));
            // Ray-triangle intersection: start + t direction = a + u e1 + v e2, solved for (u, v, t).
            M << surface.vertices.col(surface.triangles(1, t)) - a, surface.vertices.col(surface.triangles(2, t)) - a,
                -direction;
            const Eigen::Vector3d uvs = M.fullPivLu().solve(start - a);
            if (!uvs.allFinite() || uvs[2] <= skip || uvs[0] < 0.0 || uvs[1] < 0.0 || uvs[0] + uvs[1] > 1.0) continue;
            if ((M * uvs - (start - a)).norm() > skip) continue;
            nearest = std::min(nearest, uvs[2]);
        }
        if (!std::isfinite(nearest)) continue;
        const Eigen::Vector3d middle = start + 0.5 * nearest * direction;
        holes.insert(holes.end(), middle.data(), middle.data() + 3);
    }
    return holes;
}

// TetGen may merge flat facets and re-triangulate them: better cells, but it occasionally fails.
enum class FlatFacets { joined, kept };

struct AnglePolicy {
    double radius_edge_ratio = 1.414;  // circumradius over shortest edge, where nothing is asked for
    // Weaker bounds of a crowded mesh. TetGen's own are 2.0 and none (Si 2015, ACM TOMS 41(2), 11:1).
    double crowded = 0.7;  // mean edge over the one asked for, below which angles set the number of cells
    double crowded_radius_edge = 2.0;
    double crowded_dihedral_deg = 5.0;
    double least_quality = 0.1;  // mean ratio of every cell, unless the first ones are worse
};
constexpr AnglePolicy angle_policy;

/// Command line of TetGen: p piecewise linear complex, q quality, S Steiner points, Q quiet, M no merging of facets, a
/// volume.
std::string switches_for(const TetOptions& options, double max_volume, FlatFacets flat) {
    char text[128];
    std::snprintf(text, sizeof text, "pq%.4g/%.4gS%dQ",
                  std::max(1.2, options.radius_edge_ratio.value_or(angle_policy.radius_edge_ratio)),
                  std::clamp(options.min_dihedral_deg, 0.0, 20.0), std::max(1, options.steiner_cap));
    std::string switches = text;
    if (flat == FlatFacets::kept) switches += "M";
    if (max_volume > 0.0) {
        // TetGen parses plain decimals only, without exponent.
        std::snprintf(text, sizeof text, "a%.18f", max_volume);
        switches += text;
    }
    return switches;
}

/// Translates the outcome of the worker into an error message.
Result<void> judge(const ChildEnd& end, const TetOptions& options) {
    switch (end.how) {
        case ChildEnd::How::cancelled: return Error{"meshing was stopped", ""};
        case ChildEnd::How::timed_out:
            return Error{"TetGen did not finish within " + format_number(options.time_limit_s, 4) +
                             " s: choose longer edges or a larger radius-edge ratio",
                         ""};
        case ChildEnd::How::not_started:
            return Error{std::string("the tetrahedral mesher could not be started: ") + std::strerror(end.code), ""};
        case ChildEnd::How::signalled: return Error{"TetGen failed: the surface intersects itself or is broken", ""};
        case ChildEnd::How::exited: break;
    }
    switch (end.code) {
        case worker_status::done: return {};
        case worker_status::out_of_memory:
            return Error{"TetGen needs more than " + format_number(options.memory_limit_bytes / 1e9, 3) +
                             " GB of memory: choose longer edges",
                         ""};
        case worker_status::bad_call:
        case worker_status::cannot_write: return Error{"the tetrahedral mesher could not read or write its files", ""};
        case worker_status::tetgen_error + 3:
        case worker_status::tetgen_error + 4:
        case worker_status::tetgen_error + 5:
            return Error{"TetGen failed: the surface intersects itself or has parts that nearly touch", ""};
        default: return Error{"TetGen failed: the surface intersects itself or is broken", ""};
    }
}

/// Welded, checked and outward surface.
Result<SurfaceMesh> prepared(const SurfaceMesh& surface) {
    if (!surface.vertices.allFinite()) return Error{"a vertex's coordinates are not finite numbers", ""};
    SurfaceMesh welded = weld(surface);
    if (welded.triangles.cols() == 0) return Error{"the surface has no triangles", ""};
    // Defects are reported here, with their place, before TetGen is started.
    const SurfaceReport report = check_surface(welded);
    if (!report.meshable()) return Error{report.messages.front(), ""};
    if (!report.oriented) return Error{"neighbouring triangles of the surface turn opposite ways", ""};
    // Only the orientation as a whole is repaired: cavities keep facing the other way.
    if (report.volume < 0.0) welded = flipped(std::move(welded));
    // Relative to the bounding box: below rounding of the volume sum.
    if (std::abs(report.volume) < 1e-12 * report.size.prod()) return Error{"the surface encloses no volume", ""};
    return welded;
}

// Expected edge length of the future cells [m].
double expected_edge(const SurfaceMesh& welded, const TetOptions& options) {
    if (options.max_volume) return tet_edge_for_volume(*options.max_volume);
    if (options.edge) return *options.edge;
    double sum = 0.0;
    for (Eigen::Index t = 0; t < welded.triangles.cols(); ++t)
        sum += (welded.vertices.col(welded.triangles(0, t)) - welded.vertices.col(welded.triangles(1, t))).norm();
    return sum / static_cast<double>(welded.triangles.cols());
}

// One run of TetGen on a prepared surface; max_volume 0: no limit.
Result<VolumeMesh> run_tetgen(const RegionFacets& facets, FlatFacets flat, double max_volume, const TetOptions& options,
                              double time_limit_s, const Progress& progress) {
    const auto worker = find_worker();
    if (!worker) return worker.error();
    const SurfaceMesh& welded = facets.surface;

    // TetGen's tolerances suit bodies of about unit size: the mesh is made in scaled coordinates.
    const Box box = bounding_box(welded.vertices);
    const double scale = box.size().maxCoeff();
    TetgenExchange request, answer;
    const Eigen::Matrix3Xd unit = (welded.vertices.colwise() - box.lowest) / scale;
    request.points.assign(unit.data(), unit.data() + unit.size());
    request.cells.assign(welded.triangles.data(), welded.triangles.data() + welded.triangles.size());
    request.cells.insert(request.cells.end(), facets.inner.data(), facets.inner.data() + facets.inner.size());
    // TetGen fills every closed region unless it contains a hole point.
    request.holes = cavity_points({unit, welded.triangles}, surface_topology(welded));

    const TemporaryFolder folder;
    const fs::path request_path = folder.path() / "request", answer_path = folder.path() / "answer";
    if (folder.path().empty() || !write_exchange(request_path, request)) {
        return Error{"no temporary file can be written for the tetrahedral mesher", ""};
    }
    const ChildEnd end = run_child(
        {.program = *worker,
         .arguments = {request_path.string(), answer_path.string(),
                       switches_for(options, max_volume / (scale * scale * scale), flat),
                       // The worker limits its own memory and processor time; the time limit is a second line of
                       // defence.
                       std::to_string(static_cast<unsigned long long>(options.memory_limit_bytes)),
                       std::to_string(static_cast<unsigned long long>(std::ceil(time_limit_s)) + 1)},
         .time_limit_s = time_limit_s},
        [&] { return progress.cancelled(); },
        // The remaining time is unknown, so only the elapsed time is reported.
        [&](double seconds) {
            progress.report({"tetrahedral mesh", seconds, 0.0, "s", ""});
        });
    if (const auto verdict = judge(end, options); !verdict) return verdict.error();
    if (!read_exchange(answer_path, answer)) return Error{"the tetrahedral mesher's answer cannot be read", ""};
    if (answer.cells.empty()) return Error{"TetGen found no inside: the surface is open or broken", ""};

    VolumeMesh mesh;
    mesh.type = CellType::tet4;
    mesh.nodes = Eigen::Map<const Eigen::Matrix3Xd>(answer.points.data(), 3,
                                                    static_cast<Eigen::Index>(answer.points.size() / 3));
    mesh.nodes = ((mesh.nodes * scale).colwise() + box.lowest).eval();
    mesh.cells = Eigen::Map<const Eigen::MatrixXi>(answer.cells.data(), 4,
                                                   static_cast<Eigen::Index>(answer.cells.size() / 4));
    if (static_cast<double>(mesh.cell_count()) > options.max_cells) {
        return Error{
            "the mesh has " + std::to_string(mesh.cell_count()).append(" cells, over the limit: choose longer edges"),
            ""};
    }
    // The limit was reached, so the requested size and quality may not be met.
    if (mesh.node_count() >= welded.vertices.cols() + options.steiner_cap) {
        return Error{"the mesh needs more than " +
                         std::to_string(options.steiner_cap).append(" added points: choose longer edges"),
                     ""};
    }
    return with_positive_cells(std::move(mesh), "TetGen");
}

/// Replaces cells that are much smaller than asked for by those of weaker bounds on their angles, if there are fewer.
///
/// Where a surface has short or uneven edges, the points that TetGen adds for angles of 15 degrees multiply the cells:
/// on a remeshed cone by three, for a mean quality of 0.75 instead of 0.71.
/// Errors: cancelled; a mesh that cannot be made with weaker bounds leaves the first.
Result<void> relax_crowded_cells(const RegionFacets& facets, FlatFacets flat, double max_volume,
                                 const TetOptions& options, const Stopwatch& watch, const Progress& progress,
                                 VolumeMesh& mesh) {
    // Bounds that somebody asks for are kept.
    if (!options.edge || options.max_volume || options.radius_edge_ratio) return {};
    if (mean_edge_length(mesh) > angle_policy.crowded * *options.edge) return {};
    TetOptions weaker = options;
    weaker.radius_edge_ratio = angle_policy.crowded_radius_edge;
    weaker.min_dihedral_deg = std::min(options.min_dihedral_deg, angle_policy.crowded_dihedral_deg);
    Result<VolumeMesh> eased = run_tetgen(facets, flat, max_volume, weaker, options.time_limit_s - watch.seconds(),
                                          progress);
    if (!eased && progress.cancelled()) return eased.error();
    if (eased && eased->cell_count() < mesh.cell_count() &&
        cell_shapes(*eased).minCoeff() >= std::min(angle_policy.least_quality, cell_shapes(mesh).minCoeff()))
        mesh = std::move(*eased);
    return {};
}

}  // namespace

// Measured on a cube, a cylinder and a 10:3:3 beam with q = 1.414/15 and edges of an eighth to a third of the width:
// the mean edge is 1.42 to 1.6 times the cube root of the largest volume. tetrahedralize() corrects the remaining error
// by further runs.
double tet_volume_for_edge(double edge) { return std::pow(edge / 1.5, 3); }
double tet_edge_for_volume(double max_volume) { return 1.5 * std::cbrt(max_volume); }

Result<VolumeMesh> tetrahedralize(const SurfaceMesh& surface, const TetOptions& options, const Progress& progress) {
    const Stopwatch watch;
    if (options.type == CellType::hex8) return Error{"TetGen makes tetrahedra, not hexahedra", ""};
    if ((options.edge && !(*options.edge > 0.0)) || (options.max_volume && !(*options.max_volume > 0.0))) {
        return Error{"edge length and cell volume must be positive", ""};
    }
    const auto welded = prepared(surface);
    if (!welded) return welded.error();
    const auto facets = region_facets(*welded, options.regions, expected_edge(*welded, options));
    if (!facets) return facets.error();
    // The surface after cutting counts: it may differ from the given one by the tolerances of region_facets().
    const double volume = enclosed_volume(facets->surface);
    double max_volume = options.max_volume ? *options.max_volume
                        : options.edge     ? tet_volume_for_edge(*options.edge)
                                           : 0.0;

    FlatFacets flat = FlatFacets::joined;
    std::optional<VolumeMesh> best;
    double best_miss = std::numeric_limits<double>::infinity();
    // The mean edge depends on the shape and on the edges of the surface itself: the volume limit is corrected by the
    // result at most twice.
    for (int run = 0; run < 3; ++run) {
        // Cells are at most max_volume large, which gives a lower bound of their number.
        if (max_volume > 0.0 && volume / max_volume > options.max_cells) {
            if (best) break;
            return Error{
                "the mesh would have over " + format_number(options.max_cells, 3) + " cells: choose longer edges", ""};
        }
        const double used = watch.seconds();
        auto mesh = run_tetgen(*facets, flat, max_volume, options, options.time_limit_s - used, progress);
        // First failure with inner facets: second attempt without merging of flat facets.
        if (!mesh && !best && facets->inner.cols() > 0 && flat == FlatFacets::joined && !progress.cancelled()) {
            flat = FlatFacets::kept;
            mesh = run_tetgen(*facets, flat, max_volume, options, options.time_limit_s - watch.seconds(), progress);
        }
        if (!mesh && best && !progress.cancelled()) break;
        if (!mesh) return mesh.error();
        // Without a wanted edge length there is nothing to correct.
        if (!options.edge || options.max_volume) {
            best = std::move(*mesh);
            break;
        }
        // The mean edge scales with the cube root of the volume limit. The best of the runs is kept.
        const double ratio = mean_edge_length(*mesh) / *options.edge;
        if (std::abs(std::log(ratio)) < best_miss) {
            best_miss = std::abs(std::log(ratio));
            best = std::move(*mesh);
        }
        if (best_miss < 0.05 || (ratio < 1.0 && run > 0)) break;  // still shorter: limited by the edges of the surface
        max_volume /= std::pow(ratio, 3);
    }
    if (Result<void> eased = relax_crowded_cells(*facets, flat, max_volume, options, watch, progress, *best); !eased)
        return eased.error();
    // Final check of the volume: TetGen can miss regions of a defective surface.
    const double filled = cell_volumes(*best).sum();
    if (std::abs(filled - volume) > 1e-3 * volume) {
        return Error{"TetGen filled " + format_number(filled * 1e6, 4) + " ml of " + format_number(volume * 1e6, 4) +
                         " ml: the surface is broken",
                     ""};
    }
    return options.type == CellType::tet10 ? to_tet10(*best) : std::move(*best);
}

}  // namespace myo::mesh
