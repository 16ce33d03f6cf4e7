#include <Eigen/LU>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "material/polar.hpp"
#include "measurement/units.hpp"

namespace myo::experiment {
namespace {

/// Block of kind = "box", whose lengths are in m already.
BoxGeometry read_box(const toml::TomlReader& geometry) {
    // A box is in m and along the axes; these keys would have no effect.
    for (const char* key : {"file", "unit", "rotation"})
        geometry.reject(key, "belongs to kind = \"stl\" or \"volume\", not to \"box\"");
    BoxGeometry box;
    box.size_m = geometry.vector3("size_m");
    if (geometry.has("origin_m")) box.origin_m = geometry.vector3("origin_m");
    if ((box.size_m.array() <= 0.0).any()) geometry.fail("size_m", "all three lengths must be positive");
    // A body outside 1 mm ... 10 m is almost certainly declared in the wrong unit.
    const double extent = box.size_m.maxCoeff();
    if (extent > 10.0 || extent < 1e-3)
        geometry.fail("size_m",
                      "the body is " + format_number(extent) +
                          " m long; one larger than 10 m or smaller than 1 mm is almost certainly in the wrong unit");
    return box;
}

// A matrix typed with a few digits is replaced by the nearest rotation (polar decomposition); a larger deviation from
// orthogonality is an error.
Eigen::Matrix3d read_rotation(const toml::TomlReader& geometry) {
    const Eigen::Matrix3d R = geometry.matrix3("rotation");
    // Largest entry of R'R - I: three digits per entry give about 1e-3.
    const double deviation = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(deviation < 1e-3)) geometry.fail("rotation", "is not a rotation: its rows are not orthogonal unit vectors");
    // A reflection satisfies the orthogonality check but would turn the triangles inward.
    if (R.determinant() < 0.0) geometry.fail("rotation", "is left-handed: it mirrors the body");
    // Matrices of zeros and ones keep their exact values, so the vertices do not change in the last bit.
    return deviation < 1e-15 ? R : material::polar_rotation(R);
}

/// File, unit and rotation of a surface or a volume mesh.
template <class FileGeometry>
FileGeometry read_file_geometry(const toml::TomlReader& geometry, const std::filesystem::path& folder) {
    const std::string kind = geometry.text("kind");
    for (const char* key : {"size_m", "origin_m"})
        geometry.reject(key, "belongs to kind = \"box\", not to \"" + kind + "\"");
    FileGeometry declared;
    // The files carry no unit; a default could be wrong by a factor of 1000.
    if (!geometry.has("unit"))
        geometry.fail("unit", "required for kind = \"" + kind +
                                  "\": \"m\", \"dm\", \"cm\", \"mm\" or \"um\"; there is no default");
    declared.metres_per_unit = geometry.choice<double>(
        "unit", {measurement::length_units.begin(), measurement::length_units.end()});
    declared.file = geometry.file("file", folder);
    if (geometry.has("rotation")) declared.rotation = read_rotation(geometry);
    return declared;
}

}  // namespace

Geometry read_geometry(const toml::TomlReader& document, const std::filesystem::path& folder) {
    enum class Kind { box, stl, volume };
    const toml::TomlReader geometry = document.table("geometry",
                                                     {"kind", "size_m", "origin_m", "file", "unit", "rotation"});
    switch (geometry.choice<Kind>("kind", {{"box", Kind::box}, {"stl", Kind::stl}, {"volume", Kind::volume}})) {
        case Kind::stl: return read_file_geometry<StlGeometry>(geometry, folder);
        case Kind::volume: return read_file_geometry<VolumeGeometry>(geometry, folder);
        case Kind::box: break;
    }
    return read_box(geometry);
}

}  // namespace myo::experiment
