#include "mesh/face_quadrature.hpp"

#include <array>
#include <cmath>

namespace myo::mesh {
namespace {

/// Gauss-Legendre rule with 2 x 2 points on the unit square.
std::vector<FacePoint> square_rule() {
    const double low = 0.5 - 0.5 / std::sqrt(3.0), high = 1.0 - low;
    std::vector<FacePoint> points;
    for (const double v : {low, high})
        for (const double u : {low, high}) points.push_back({{u, v}, 0.25});
    return points;
}

/// Six-point rule of degree 4 on the triangle: two orbits of three points.
std::vector<FacePoint> triangle_rule() {
    std::vector<FacePoint> points;
    const auto add = [&](double at_corner, double elsewhere, double weight) {
        for (const auto& [u, v] :
             {std::array{elsewhere, elsewhere}, std::array{at_corner, elsewhere}, std::array{elsewhere, at_corner}})
            points.push_back({{u, v}, 0.5 * weight});
    };
    // Barycentric coordinates and weights relative to the area.
    add(0.108103018168070, 0.445948490915965, 0.223381589678011);
    add(0.816847572980458, 0.091576213509771, 0.109951743655322);
    return points;
}

}  // namespace

const std::vector<FacePoint>& face_quadrature(int nodes) {
    static const std::vector<FacePoint> square = square_rule(), triangle = triangle_rule();
    return nodes == 4 ? square : triangle;
}

}  // namespace myo::mesh
