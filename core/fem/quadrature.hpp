#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace myo {

struct QuadraturePoint {
    Eigen::Vector3d xi;
    double weight = 0.0;   // sums to the reference volume: 8 (hexahedron), 1/6 (tetrahedron)
};

/// Gauss-Legendre, n per axis, n = 1, 2, 3. Exact to degree 2 n - 1 per axis.
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

inline std::vector<QuadraturePoint> tet_centroid() { return {{{0.25, 0.25, 0.25}, 1.0 / 6.0}}; }

/// Four points, degree 2 (Hammer & Stroud 1956).
inline std::vector<QuadraturePoint> tet_degree2() {
    const double a = (5.0 - std::sqrt(5.0)) / 20.0, b = 1.0 - 3.0 * a, w = 1.0 / 24.0;
    return {{{a, a, a}, w}, {{b, a, a}, w}, {{a, b, a}, w}, {{a, a, b}, w}};
}

/// Fifteen points, degree 5 (Keast 1986, no. 6): for the consistent mass of tet10, whose integrand has degree 4.
inline std::vector<QuadraturePoint> tet_degree5() {
    std::vector<QuadraturePoint> points{{{0.25, 0.25, 0.25}, 0.030283678097089}};
    const auto corners = [&](double a, double w) {
        const double b = 1.0 - 3.0 * a;
        points.push_back({{a, a, a}, w});
        points.push_back({{b, a, a}, w});
        points.push_back({{a, b, a}, w});
        points.push_back({{a, a, b}, w});
    };
    corners(1.0 / 3.0, 0.006026785714286);
    corners(1.0 / 11.0, 0.011645249086029);
    const double a = 0.066550153573664, b = 0.5 - a, w = 0.010949141561386;
    points.push_back({{a, a, b}, w});
    points.push_back({{a, b, a}, w});
    points.push_back({{b, a, a}, w});
    points.push_back({{b, b, a}, w});
    points.push_back({{b, a, b}, w});
    points.push_back({{a, b, b}, w});
    return points;
}

}  // namespace myo
