#include "model/cavity_pressure.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/cross_matrix.hpp"
#include "base/text.hpp"
#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"
#include "model/command.hpp"
#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Share of one face in the cavity volume: 1/3 of the integral of x . (x_u x x_v) with the normal out of the cavity.
/// The outward normal of the body points into the cavity, hence the negative sign below.
struct WallVolume {
    double value = 0.0;             // [m3]
    Matrix3Xd gradient;             // dV/dx, 3 x nodes [m2]
    std::vector<Matrix3d> hessian;  // d2V / dx_a dx_b at a + nodes * b [m]; empty unless requested
};

/// Volume share of a face with nodes at x, its gradient and, if asked for, its Hessian.
WallVolume wall_volume(const Matrix3Xd& x, bool with_hessian) {
    const auto count = x.cols();
    WallVolume V;
    V.gradient = Matrix3Xd::Zero(3, count);
    if (with_hessian) V.hessian.assign(static_cast<std::size_t>(count * count), Matrix3d::Zero());
    for (const mesh::FacePoint& point : mesh::face_quadrature(static_cast<int>(count))) {
        const VectorXd N = mesh::face_shape(static_cast<int>(count), point.uv);
        const Eigen::MatrixX2d D = mesh::face_shape_gradient(static_cast<int>(count), point.uv);
        const Vector3d at = x * N, u = x * D.col(0), v = x * D.col(1);
        const double w = -point.weight / 3.0;  // the cavity's outward normal points into the body
        V.value += w * at.dot(u.cross(v));
        const Vector3d uv = u.cross(v), vx = v.cross(at), xu = at.cross(u);
        for (Eigen::Index a = 0; a < count; ++a) V.gradient.col(a) += w * (N(a) * uv + D(a, 0) * vx + D(a, 1) * xu);
        if (!with_hessian) continue;
        const Matrix3d X = cross_matrix(at), U = cross_matrix(u), W = cross_matrix(v);
        // Derivative of the triple product det(x, x_u, x_v); each variation is a cross-product matrix.
        for (Eigen::Index b = 0; b < count; ++b)
            for (Eigen::Index a = 0; a < count; ++a)
                V.hessian[static_cast<std::size_t>(a + count * b)] += w * ((N(a) * D(b, 1) - D(a, 1) * N(b)) * U +
                                                                           (D(a, 0) * N(b) - N(a) * D(b, 0)) * W +
                                                                           (D(a, 1) * D(b, 0) - D(a, 0) * D(b, 1)) * X);
    }
    return V;
}

/// See cavity_pressure().
class CavityPressure : public ForceElement {
public:
    CavityPressure(std::shared_ptr<const std::vector<LoadedFace>> walls, fibre::Signal pressure, std::string words,
                   double factor)
        : walls_(std::move(walls)), pressure_(std::move(pressure)), words_(std::move(words)), factor_(factor) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const double p = factor_ * command_value(pressure_, at);
        if (p == 0.0) return;
        for (const LoadedFace& wall : *walls_) {
            const WallVolume V = wall_volume(at.x(Eigen::all, wall.nodes), kind == HessianKind::exact);
            out.energy -= p * V.value;
            for (std::size_t a = 0; a < wall.nodes.size(); ++a)
                out.gradient.col(wall.nodes[a]) -= p * V.gradient.col(static_cast<Eigen::Index>(a));
            if (kind != HessianKind::exact)
                continue;  // indefinite with zero diagonal blocks: its positive part is not used
            add_face_hessian(body, wall, out.hessian, [&](std::size_t a, std::size_t b) {
                return Matrix3d(-p * V.hessian[a + wall.nodes.size() * b]);
            });
        }
    }

    const fibre::Signal* command() const override { return &pressure_; }
    ForceElementPointer with_command(const fibre::Signal& pressure_Pa) const override {
        return std::make_shared<CavityPressure>(walls_, pressure_Pa, words_, factor_);
    }
    std::string command_words(double time_s, bool before) const override {
        const double p = before ? pressure_.value_before(time_s) : pressure_.value(time_s);
        // Four digits, and whole pascals beyond: the pressures of chambers have no exponent.
        const bool is_large = std::abs(p) >= 1e3;
        return format_number(is_large ? std::round(p) : p, is_large ? 9 : 4) + " Pa in " + words_;
    }

    std::vector<ForceParameter> parameters() const override {
        return command_parameters(pressure_, "pressure_Pa", 1e3);
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return with_command(with_values(pressure_, values));
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        const double dp = command_change(pressure_, at, change);
        if (dp != 0.0) add_unit_pressure(at.x, factor_ * dp, gradient);
    }
    void add_work(const Body&, const ForceState& at, const Matrix3Xd& p, VectorXd& by_parameter) const override {
        Matrix3Xd unit = Matrix3Xd::Zero(3, p.cols());
        add_unit_pressure(at.x, factor_, unit);
        add_command_work(pressure_, at, unit.cwiseProduct(p).sum(), by_parameter);
    }

    bool steady(double from_s, double to_s) const override { return constant_between(pressure_, from_s, to_s); }
    std::vector<double> jumps() const override { return pressure_.jumps(); }

private:
    /// Adds the gradient of -dp V, which is the derivative of the gradient along a pressure dp [Pa].
    void add_unit_pressure(const Matrix3Xd& x, double dp, Matrix3Xd& gradient) const {
        for (const LoadedFace& wall : *walls_) {
            const WallVolume V = wall_volume(x(Eigen::all, wall.nodes), false);
            for (std::size_t a = 0; a < wall.nodes.size(); ++a)
                gradient.col(wall.nodes[a]) -= dp * V.gradient.col(static_cast<Eigen::Index>(a));
        }
    }

    std::shared_ptr<const std::vector<LoadedFace>> walls_;
    fibre::Signal pressure_;
    std::string words_;  // for messages
    double factor_;      // of the pressure on the walls
};

/// Corners of a face in cyclic order: 3 for straight and curved triangles, otherwise 4.
Eigen::Index corner_count(const Body& body) { return body.boundary.nodes.rows() == 4 ? 4 : 3; }

using Edge = std::pair<int, int>;

/// Calls visit(edge) for the edges of a face between its corners, lower node first.
template <class Visit>
void for_each_edge(const Body& body, int face, const Visit& visit) {
    const Eigen::Index corners = corner_count(body);
    for (Eigen::Index k = 0; k < corners; ++k) {
        const int a = body.boundary.nodes(k, face), b = body.boundary.nodes((k + 1) % corners, face);
        visit(Edge{std::min(a, b), std::max(a, b)});
    }
}

}  // namespace

ForceElementPointer cavity_pressure(const Body& body, const std::vector<int>& faces, fibre::Signal pressure_Pa,
                                    std::string words, double factor) {
    return std::make_shared<CavityPressure>(std::make_shared<const std::vector<LoadedFace>>(loaded_faces(body, faces)),
                                            std::move(pressure_Pa), std::move(words), factor);
}

double cavity_volume(const Body& body, const std::vector<int>& faces, const Matrix3Xd& x) {
    double volume = 0.0;
    for (const LoadedFace& wall : loaded_faces(body, faces))
        volume += wall_volume(x(Eigen::all, wall.nodes), false).value;
    return volume;
}

double wall_area(const Body& body, const std::vector<int>& faces, const Matrix3Xd& x) {
    double area = 0.0;
    for (const int face : faces) {
        const Matrix3Xd at = x(Eigen::all, body.boundary.nodes.col(face));
        const int count = static_cast<int>(at.cols());
        for (const mesh::FacePoint& point : mesh::face_quadrature(count)) {
            const Eigen::MatrixX2d D = mesh::face_shape_gradient(count, point.uv);
            const Vector3d u = at * D.col(0), v = at * D.col(1);
            area += point.weight * u.cross(v).norm();
        }
    }
    return area;
}

int open_edges(const Body& body, const std::vector<int>& faces) {
    // Quadratic faces are matched by the corners of their edges.
    std::map<Edge, int> shared;
    for (const int face : faces) for_each_edge(body, face, [&](const Edge& edge) { ++shared[edge]; });
    int open = 0;
    // Odd count: the edge lies on the rim. Fully clamped edges do no work.
    for (const auto& [edge, count] : shared)
        if (count % 2 == 1 && !(body.clamped[static_cast<std::size_t>(edge.first)] &&
                                body.clamped[static_cast<std::size_t>(edge.second)]))
            ++open;
    return open;
}

std::vector<std::vector<int>> closed_cavities(const Body& body) {
    const int count = static_cast<int>(body.boundary.count());
    std::vector<int> part(static_cast<std::size_t>(count));
    std::iota(part.begin(), part.end(), 0);
    // Union-find over faces that share an edge, with path compression.
    const auto root = [&](int face) {
        while (part[static_cast<std::size_t>(face)] != face)
            face = part[static_cast<std::size_t>(face)] = part[static_cast<std::size_t>(
                part[static_cast<std::size_t>(face)])];
        return face;
    };
    std::map<Edge, int> first;
    for (int face = 0; face < count; ++face)
        for_each_edge(body, face, [&](const Edge& edge) {
            const auto [at, is_new] = first.emplace(edge, face);
            if (!is_new) part[static_cast<std::size_t>(root(face))] = root(at->second);
        });
    std::map<int, std::vector<int>> parts;
    for (int face = 0; face < count; ++face) parts[root(face)].push_back(face);
    std::vector<std::vector<int>> cavities;
    for (auto& [number, faces] : parts)
        if (cavity_volume(body, faces, body.mesh.nodes) > 0.0)
            cavities.push_back(std::move(faces));  // the outer surface encloses minus the volume of the body
    return cavities;
}

}  // namespace myo::model
