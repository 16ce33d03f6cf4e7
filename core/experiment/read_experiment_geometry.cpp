#include <Eigen/LU>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "material/polar.hpp"

namespace myo::experiment {
namespace {

BoxGeometry read_box(const toml::TomlReader& geometry) {
    for (const char* key : {"file", "unit", "rotation"})
        geometry.reject(key, "belongs to kind = \"stl\", not to \"box\"");
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
    const double deviation = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(deviation < 1e-3)) geometry.fail("rotation", "is not a rotation: its rows are not orthogonal unit vectors");
    // A reflection satisfies the orthogonality check but would turn the triangles inward.
    if (R.determinant() < 0.0) geometry.fail("rotation", "is left-handed: it mirrors the body");
    // Matrices of zeros and ones keep their exact values, so the vertices do not change in the last bit.
    return deviation < 1e-15 ? R : material::polar_rotation(R);
}

StlGeometry read_stl_declaration(const toml::TomlReader& geometry, const std::filesystem::path& folder) {
    for (const char* key : {"size_m", "origin_m"}) geometry.reject(key, "belongs to kind = \"box\", not to \"stl\"");
    StlGeometry stl;
    // STL files carry no unit; a default could be wrong by a factor of 1000.
    if (!geometry.has("unit"))
        geometry.fail("unit", "required for kind = \"stl\": \"m\" or \"mm\"; there is no default");
    stl.metres_per_unit = geometry.choice<double>("unit", {{"m", 1.0}, {"mm", 1e-3}});
    stl.file = geometry.file("file", folder);
    if (geometry.has("rotation")) stl.rotation = read_rotation(geometry);
    return stl;
}

}  // namespace

std::variant<BoxGeometry, StlGeometry> read_geometry(const toml::TomlReader& document,
                                                     const std::filesystem::path& folder) {
    const toml::TomlReader geometry = document.table("geometry",
                                                     {"kind", "size_m", "origin_m", "file", "unit", "rotation"});
    const bool is_box = geometry.choice<bool>("kind", {{"box", true}, {"stl", false}});
    if (is_box) return read_box(geometry);
    return read_stl_declaration(geometry, folder);
}

}  // namespace myo::experiment
