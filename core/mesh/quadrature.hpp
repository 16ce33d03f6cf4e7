#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace myo::mesh {

/// Point of a quadrature rule on the reference cell.
struct QuadraturePoint {
    Eigen::Vector3d xi;   // reference coordinates
    double weight = 0.0;  // sums to the reference volume: 8 (hexahedron), 1/6 (tetrahedron)
};

/// Gauss-Legendre rule with n points per axis, n = 1, 2, 3. Exact to degree 2 n - 1 per axis.
inline std::vector<QuadraturePoint> hex_gauss(int n) {
    std::vector<double> x{0.0}, w{2.0};
    if (n == 2) x = {-1.0 / std::sqrt(3.0), 1.0 / std::sqrt(3.0)}, w = {1.0, 1.0};
    if (n == 3) x = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, w = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    std::vector<QuadraturePoint> points;
    for (std::size_t k = 0; k < x.size(); ++k)
        for (std::size_t j = 0; j < x.size(); ++j)
            for (std::size_t i = 0; i < x.size(); ++i) points.push_back({{x[i], x[j], x[k]}, w[i] * w[j] * w[k]});
    return points;
}

/// Adds the orbit of four points with three barycentric coordinates a: on the lines from corners to opposite faces.
inline void add_towards_corners(double a, double w, std::vector<QuadraturePoint>& points) {
    const double b = 1.0 - 3.0 * a;
    points.insert(points.end(), {{{a, a, a}, w}, {{b, a, a}, w}, {{a, b, a}, w}, {{a, a, b}, w}});
}

/// Adds the orbit of six points with barycentric coordinates a, a, 1/2 - a, 1/2 - a: on the lines between midpoints of
/// opposite edges.
inline void add_towards_edges(double a, double w, std::vector<QuadraturePoint>& points) {
    const double b = 0.5 - a;
    points.insert(points.end(),
                  {{{a, a, b}, w}, {{a, b, a}, w}, {{b, a, a}, w}, {{b, b, a}, w}, {{b, a, b}, w}, {{a, b, b}, w}});
}

/// One point, degree 1.
inline std::vector<QuadraturePoint> tet_centroid() { return {{{0.25, 0.25, 0.25}, 1.0 / 6.0}}; }

/// Four points, degree 2 (Hammer & Stroud 1956).
inline std::vector<QuadraturePoint> tet_degree2() {
    std::vector<QuadraturePoint> points;
    add_towards_corners((5.0 - std::sqrt(5.0)) / 20.0, 1.0 / 24.0, points);
    return points;
}

/// Five points, degree 3 (Keast 1986, no. 2), with a negative weight: for volumes of tet10 only.
inline std::vector<QuadraturePoint> tet_five_points() {
    std::vector<QuadraturePoint> points{{{0.25, 0.25, 0.25}, -0.8 / 6.0}};
    add_towards_corners(1.0 / 6.0, 0.45 / 6.0, points);
    return points;
}

/// Ten points, degree 3, positive weights (Shunn & Ham 2012). The integral of the fourth power of a linear function
/// with mean zero has an error of at most 3 %, with the four points 20 to 53 %.
inline std::vector<QuadraturePoint> tet_degree3() {
    std::vector<QuadraturePoint> points;
    add_towards_corners(0.0738349017262234, 0.0476331348432089 / 6.0, points);
    add_towards_edges(0.0937556561159491, 0.1349112434378610 / 6.0, points);
    return points;
}

/// Fifteen points, degree 5 (Keast 1986, no. 6): for the consistent mass of tet10, whose integrand has degree 4.
inline std::vector<QuadraturePoint> tet_degree5() {
    std::vector<QuadraturePoint> points{{{0.25, 0.25, 0.25}, 0.030283678097089}};
    add_towards_corners(1.0 / 3.0, 0.006026785714286, points);
    add_towards_corners(1.0 / 11.0, 0.011645249086029, points);
    add_towards_edges(0.066550153573664, 0.010949141561386, points);
    return points;
}

}  // namespace myo::mesh
