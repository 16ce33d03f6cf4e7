#include "setup/parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/winding_number.hpp"
#include "setup/mask_on_mesh.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Key of a part in messages: "part[1].box_m".
std::string part_key(std::size_t part, const std::string& key) { return "part[" + std::to_string(part) + "]." + key; }

/// Points in a cell that stand for equal parts of its volume, to first order: the middles of a grid of the reference
/// cell.
///
/// @param n  points per direction
Matrix3Xd sample_points(const mesh::VolumeMesh& mesh, Index cell, int n) {
    const Matrix3Xd x = mesh.nodes(Eigen::all, mesh.cells.col(cell));
    std::vector<Vector3d> points;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const Vector3d at = Vector3d(i + 0.5, j + 0.5, k + 0.5) / n;
                if (mesh.type == mesh::CellType::hex8) {
                    Vector3d point = Vector3d::Zero();
                    // VTK order: corners of the lower face counter-clockwise, then those of the upper face.
                    constexpr int bits[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
                    for (int corner = 0; corner < 8; ++corner) {
                        double weight = 1.0;
                        for (int axis = 0; axis < 3; ++axis) weight *= bits[corner][axis] ? at[axis] : 1.0 - at[axis];
                        point += weight * x.col(corner);
                    }
                    points.push_back(point);
                } else {
                    // The unit cube folds to the tetrahedron by sorting: six equal tetrahedra, all mapped to one.
                    Vector3d sorted = at;
                    std::sort(sorted.data(), sorted.data() + 3);
                    points.push_back(sorted[0] * x.col(0) + (sorted[1] - sorted[0]) * x.col(1) +
                                     (sorted[2] - sorted[1]) * x.col(2) + (1.0 - sorted[2]) * x.col(3));
                }
            }
    Matrix3Xd result(3, static_cast<Index>(points.size()));
    for (std::size_t p = 0; p < points.size(); ++p) result.col(static_cast<Index>(p)) = points[p];
    return result;
}

/// Share of one cell within a closed surface, from points per direction.
double share_of_points(const mesh::VolumeMesh& mesh, Index cell, const mesh::SurfaceMesh& surface, int per_direction) {
    const Matrix3Xd points = sample_points(mesh, cell, per_direction);
    int inside = 0;
    for (Index p = 0; p < points.cols(); ++p)
        if (mesh::winding_number(surface, points.col(p)) > 0.5) ++inside;
    return static_cast<double>(inside) / static_cast<double>(points.cols());
}

/// Share of each cell within a closed surface.
VectorXd shares_in_surface(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& surface) {
    const Box bounds = mesh::bounding_box(surface.vertices);
    VectorXd shares = VectorXd::Zero(mesh.cell_count());
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const Matrix3Xd x = mesh.nodes(Eigen::all, mesh.cells.col(c));
        // Winding numbers cost a pass over the surface per point; most cells are outside its bounds.
        if ((x.rowwise().maxCoeff().array() <= bounds.lowest.array()).any() ||
            (x.rowwise().minCoeff().array() >= bounds.highest.array()).any())
            continue;
        shares[c] = share_of_points(mesh, c, surface, part_policy.first_points);
        if (shares[c] > 0.0 && shares[c] < 1.0) shares[c] = share_of_points(mesh, c, surface, part_policy.points);
    }
    return shares;
}

/// Surface of a part in the frame of the mesh; it has unit and rotation of the geometry.
Result<mesh::SurfaceMesh> part_surface(const experiment::Experiment& experiment, std::size_t part,
                                       const std::filesystem::path& file) {
    double metres_per_unit = 1.0;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    const auto take = [&](const auto& geometry) {
        metres_per_unit = geometry.metres_per_unit;
        rotation = geometry.rotation;
    };
    if (const auto* stl = std::get_if<experiment::StlGeometry>(&experiment.geometry)) take(*stl);
    if (const auto* volume = std::get_if<experiment::VolumeGeometry>(&experiment.geometry)) take(*volume);
    const Result<mesh::SurfaceMesh> raw = mesh::read_surface(file, metres_per_unit, rotation);
    if (!raw) return Error{part_key(part, "file") + ": " + raw.error().what, raw.error().where};
    mesh::SurfaceMesh surface = mesh::weld(*raw);
    if (const mesh::SurfaceReport report = mesh::check_surface(surface); !report.closed)
        return experiment::declaration_error(
            experiment, part_key(part, "file"),
            file.filename().string() + " is not closed: " + std::to_string(report.open_edges) + " open edges");
    // A part has an inside whichever way its triangles face.
    if (mesh::enclosed_volume(surface) < 0.0) surface.triangles.row(1).swap(surface.triangles.row(2));
    return surface;
}

/// Share of each cell that is painted. `warnings` receives contradictions of the mask.
Result<VectorXd> painted_shares(const experiment::Experiment& experiment, std::size_t part,
                                const experiment::PartDeclaration::Painted& painted, const BodyMesh& mesh,
                                std::vector<std::string>& warnings) {
    const std::string key = part_key(part, "mask");
    std::error_code code;
    const auto* const file = std::get_if<std::filesystem::path>(&painted.mask);
    if (file && !std::filesystem::is_regular_file(*file, code))
        return experiment::declaration_error(experiment, key, "file not found: " + file->string());
    const Result<fibre::PaintedMask> mask = mask_on_mesh(painted.mask, mesh);
    if (!mask) return Error{key + ": " + mask.error().what, mask.error().where};
    for (const std::string& doubt : mask_doubts(*mask, mesh)) warnings.push_back(key + ": " + doubt);
    return VectorXd(fibre::paint_of_mask(mesh.mesh, *mask).weights);
}

/// Share of each cell that a part holds, without regard to the others.
Result<VectorXd> shares_of(const experiment::Experiment& experiment, std::size_t part, const BodyMesh& mesh,
                           std::vector<std::string>& warnings) {
    const experiment::PartDeclaration& declared = experiment.parts[part];
    if (const Box* box = std::get_if<Box>(&declared.place))
        return VectorXd(mesh::volume_fractions(mesh.mesh, box_on_mesh(mesh, *box)));
    if (const auto* file = std::get_if<std::filesystem::path>(&declared.place)) {
        const Result<mesh::SurfaceMesh> surface = part_surface(experiment, part, *file);
        if (!surface) return surface.error();
        return shares_in_surface(mesh.mesh, *surface);
    }
    if (const auto* painted = std::get_if<experiment::PartDeclaration::Painted>(&declared.place))
        return painted_shares(experiment, part, *painted, mesh, warnings);
    const int number = std::get<experiment::PartDeclaration::Region>(declared.place).number;
    if (mesh.mesh.regions.empty())
        return experiment::declaration_error(experiment, part_key(part, "region"),
                                             "the file of the body gives its cells no numbers of regions");
    VectorXd shares(mesh.mesh.cell_count());
    for (Index c = 0; c < shares.size(); ++c)
        shares[c] = mesh.mesh.regions[static_cast<std::size_t>(c)] == number ? 1.0 : 0.0;
    return shares;
}

/// Key that says where a part is.
std::string place_key(const experiment::PartDeclaration& part) {
    constexpr const char* keys[] = {"box_m", "file", "region", "mask"};
    return keys[part.place.index()];
}

/// Moduli of the materials: the body's, then those of the parts.
std::vector<material::Moduli> material_moduli(const experiment::Experiment& experiment, const MaterialValues& values) {
    std::vector<material::Moduli> moduli{
        material::moduli_from_young(values.youngs_modulus_Pa, experiment.material.poissons_ratio)};
    for (std::size_t k = 0; k < experiment.parts.size(); ++k)
        moduli.push_back(material::moduli_from_young(values.part_modulus_Pa[k], experiment.parts[k].poissons_ratio));
    return moduli;
}

}  // namespace

Result<MatrixXd> part_shares(const experiment::Experiment& experiment, const BodyMesh& mesh,
                             std::vector<std::string>& warnings) {
    if (experiment.parts.empty()) return MatrixXd();
    const VectorXd volumes = mesh::cell_volumes(mesh.mesh);
    MatrixXd shares = MatrixXd::Zero(mesh.mesh.cell_count(), 1 + static_cast<Index>(experiment.parts.size()));
    shares.col(0).setOnes();
    for (std::size_t k = 0; k < experiment.parts.size(); ++k) {
        const Result<VectorXd> own = shares_of(experiment, k, mesh, warnings);
        if (!own) return own.error();
        if (own->dot(volumes) < part_policy.least_share * volumes.sum())
            return experiment::declaration_error(experiment, part_key(k, place_key(experiment.parts[k])),
                                                 "holds no material of the body");
        // What lay there before keeps its proportions in the rest of the cell.
        for (Index column = 0; column < shares.cols(); ++column) shares.col(column).array() *= 1.0 - own->array();
        shares.col(1 + static_cast<Index>(k)) += *own;
    }
    // Cells of which no material holds all; rounding of exact cuts does not count.
    const VectorXd mixed = (shares.rowwise().maxCoeff().array() < 1.0 - 1e-9).cast<double>();
    if (const double share = mixed.dot(volumes) / volumes.sum(); share > part_policy.told_mixed)
        warnings.push_back(format_number(100.0 * share, 2) +
                           " % of the body is in cells that an interface of parts crosses; they have the mean modulus "
                           "by volume wherever the interface lies in the cell; choose shorter edges (--resolution), or "
                           "give the part by a box, whose faces the mesh meets");
    return shares;
}

MaterialValues declared_materials(const experiment::Experiment& experiment, double damping_s) {
    MaterialValues values{experiment.material.youngs_modulus_Pa, damping_s};
    for (const experiment::PartDeclaration& part : experiment.parts) {
        values.part_modulus_Pa.push_back(part.youngs_modulus_Pa);
        // A part whose damping is sought has one of its own, which starts at the body's.
        const bool sought = std::find(part.calibrate.begin(), part.calibrate.end(), "damping") != part.calibrate.end();
        values.part_damping_s.push_back(
            part.damping_s.value_or(sought ? damping_s : std::numeric_limits<double>::quiet_NaN()));
    }
    return values;
}

std::vector<material::Moduli> mixed_moduli(const experiment::Experiment& experiment, const MatrixXd& shares,
                                           const MaterialValues& values, double factor) {
    const std::vector<material::Moduli> materials = material_moduli(experiment, values);
    std::vector<material::Moduli> cells(static_cast<std::size_t>(shares.rows()), material::Moduli{0.0, 0.0});
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::size_t k = 0; k < materials.size(); ++k) {
            const double share = factor * shares(static_cast<Index>(c), static_cast<Index>(k));
            cells[c].mu += share * materials[k].mu;
            cells[c].kappa += share * materials[k].kappa;
        }
    return cells;
}

std::vector<double> damping_excess(const experiment::Experiment& experiment, const MatrixXd& shares,
                                   const MaterialValues& values) {
    bool any = false;
    for (const double damping : values.part_damping_s) any = any || !std::isnan(damping);
    if (!any) return {};
    const std::vector<material::Moduli> materials = material_moduli(experiment, values);
    std::vector<double> excess(static_cast<std::size_t>(shares.rows()), 0.0);
    for (std::size_t c = 0; c < excess.size(); ++c) {
        double stiffness = 0.0, viscosity = 0.0;
        for (std::size_t k = 0; k < materials.size(); ++k) {
            const double own = shares(static_cast<Index>(c), static_cast<Index>(k)) * materials[k].mu;
            stiffness += own;
            if (k > 0 && !std::isnan(values.part_damping_s[k - 1]))
                viscosity += own * (values.part_damping_s[k - 1] - values.damping_s);
        }
        // Viscous moduli are damping time times shear modulus, and only these are averaged.
        excess[c] = viscosity / stiffness;
    }
    return excess;
}

std::vector<double> density_factors(const experiment::Experiment& experiment, const MatrixXd& shares) {
    VectorXd factors = VectorXd::Ones(shares.rows());
    for (std::size_t k = 0; k < experiment.parts.size(); ++k)
        // Shares sum to 1, so only the difference from the body's density counts.
        factors += (experiment.parts[k].density_kg_m3 / experiment.material.density_kg_m3 - 1.0) *
                   shares.col(1 + static_cast<Index>(k));
    if (shares.rows() == 0 || (factors.array() == 1.0).all()) return {};
    return {factors.data(), factors.data() + factors.size()};
}

std::vector<Box> part_boxes(const experiment::Experiment& experiment) {
    std::vector<Box> boxes;
    for (const experiment::PartDeclaration& part : experiment.parts)
        if (const Box* box = std::get_if<Box>(&part.place)) boxes.push_back(*box);
    return boxes;
}

}  // namespace myo::setup
