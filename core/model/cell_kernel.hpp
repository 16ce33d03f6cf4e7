#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>

#include "base/pack.hpp"
#include "material/material.hpp"
#include "material/tensors.hpp"
#include "model/assumed_strain_points.hpp"
#include "model/assumed_strain_stiffness.hpp"
#include "model/elastic_points.hpp"
#include "model/point_kinematics.hpp"

namespace myo::model {

/// Input of add_response(). A null pointer means a factor of 1, or an absent part.
struct PackInput {
    bool elastic = false, viscous = false;    // parts to evaluate
    PackElasticity elasticity;                // required if elastic
    Pack poissons_ratio = 0.0;                // for the bending of cells with assumed strain
    Pack viscous_mu = 0.0;                    // damping times mu [Pa s]; requires `rate_history`
    const double* viscous_factors = nullptr;  // scale viscous_mu, per point; null: 1
    double rate_factor = 0.0;                 // [1/s] strain rate = rate_factor * strain + rate_history
    const double* rate_history = nullptr;     // [1/s] strains_per_cell packs
    const double* pressure = nullptr;         // U' for the geometric stiffness, volumes_per_cell packs; null: current

    /// Factor of viscous_mu at point q.
    Pack viscous_factor(int q) const { return viscous_factors ? entry(viscous_factors, q) : Pack(1.0); }
};

/// Result of add_response().
template <int N>
struct PackOutput {
    Pack energy = 0.0;                // [J]
    PackNodes<N> gradient;            // dW/dx [N]
    PackMatrix<N> hessian;            // d2W/dx2 [N/m]; unchanged unless requested
    material::LawResponse<Pack> law;  // workspace: of the last point. Kept here to avoid clearing one per pack
};

/// Strain rate at point q: rate_factor E(F) + history. E(F) is skipped if rate_factor is 0.
inline PackSymmetric strain_rate(const material::Matrix3<Pack>& F, double rate_factor, const double* rate_history,
                                 int q) {
    PackSymmetric rate;
    if (rate_factor == 0.0) {
        for (int i = 0; i < 6; ++i) rate[static_cast<std::size_t>(i)] = entry(rate_history, 6 * q + i);
        return rate;
    }
    rate = green_strain(F);
    for (int i = 0; i < 6; ++i) {
        Pack& r = rate[static_cast<std::size_t>(i)];
        r = rate_factor * r + entry(rate_history, 6 * q + i);
    }
    return rate;
}

/// Viscous second Piola-Kirchhoff stress 2 mu_v dev(rate), as in the project file.
inline material::Matrix3<Pack> viscous_stress(const Pack& viscous_mu, const PackSymmetric& rate_deviator) {
    PackSymmetric S = rate_deviator;
    for (Pack& s : S) s *= 2.0 * viscous_mu;
    return full(S);
}

/// Adds the Kelvin-Voigt response of one point, with potential mu_v / rate_factor |dev Edot|^2 and Edot = rate_factor
/// E(F) + history.
///
/// The gradient is F S with S = 2 mu_v dev Edot, and the Hessian is symmetric. Differencing the strain rate like the
/// velocity keeps each time step a minimisation.
/// @param value, P, A  energy density [J/m3], dW/dF and d2W/dF2; increased
template <bool WithHessian>
void add_viscous_response(const material::Matrix3<Pack>& F, const Pack& viscous_mu, double rate_factor,
                          const double* history, int q, Pack& value, material::Matrix3<Pack>& P,
                          material::Matrix9<Pack>& A) {
    const PackSymmetric D = deviator(strain_rate(F, rate_factor, history, q));
    const material::Matrix3<Pack> S = viscous_stress(viscous_mu, D);
    // At a rate factor of 0 the potential has no finite value; callers then use the force alone.
    if (rate_factor > 0.0) value += (1.0 / rate_factor) * viscous_mu * double_dot(D, D);
    P += product(F, S);
    if constexpr (WithHessian) {
        material::Matrix3<Pack> B;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) B(i, j) = F(i, 0) * F(j, 0) + F(i, 1) * F(j, 1) + F(i, 2) * F(j, 2);
        const Pack scale = 2.0 * viscous_mu * rate_factor;
        // d2W/dF2 = scale * (dE/dF)' dev (dE/dF) + I x S, with B = F F' from the symmetrised products.
        material::for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            Pack value_ikjl = F(i, l) * F(k, j);
            if (j == l) value_ikjl += B(i, k);
            A(row, column) += scale * (0.5 * value_ikjl - (1.0 / 3.0) * F(i, j) * F(k, l));
            if (i == k) A(row, column) += S(j, l);
        });
    }
}

/// Forces and stiffness of the mean volume of a pack's cells: W = V U(theta) with theta the average over the points,
/// see ElasticPoints.
template <bool WithHessian, class Geometry>
class MeanVolume {
public:
    static constexpr int N = Geometry::nodes, Q = Geometry::points;

    explicit MeanVolume(const PointKinematics<Geometry>& points) : gradient_(points) {}

    /// Adds the derivatives of theta with respect to F at a point.
    void add(const PointState& point) {
        gradient_.add(point.q, point.law.volume.gradient * point.weight);
        if constexpr (WithHessian) hessian_[static_cast<std::size_t>(point.q)] = point.law.volume.hessian;
    }

    /// Adds energy, gradient and Hessian to the output. Call after the last add().
    /// @param U         energy density at the average of theta
    /// @param pressure  U' in the geometric part of the Hessian
    void finish(const PointKinematics<Geometry>& points, const material::ScalarFunctionOf<Pack>& U,
                const Pack& pressure, PackOutput<N>& out) const {
        const Pack volume = points.geometry().volume;
        out.energy += volume * U.value;
        PackNodes<N> gradient = PackNodes<N>::Constant(Pack(0.0));
        gradient_.add_to(gradient);
        out.gradient += gradient * U.first;
        if constexpr (WithHessian) {
            // Hessian of V U(theta): U' times the second derivative of theta, plus a rank-one term U'' d theta x d
            // theta.
            for (std::size_t q = 0; q < Q; ++q)
                add_pulled_back<N>(hessian_[q], points.geometry().gradient[q],
                                   pressure * points.weight(static_cast<int>(q)), out.hessian);
            // The rank-one part couples all nodes of a cell, so it is added after the loop over points.
            const Pack stiffness = U.second * (1.0 / volume);
            for (int b = 0; b < N; ++b)
                for (int a = b; a < N; ++a) {
                    material::Matrix3<Pack>& block = out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))];
                    for (int j = 0; j < 3; ++j)
                        for (int i = 0; i < 3; ++i) block(i, j) += stiffness * gradient(i, a) * gradient(j, b);
                }
        }
    }

private:
    StressSum<Geometry> gradient_;
    std::array<material::Matrix9<Pack>, WithHessian ? Q : 1> hessian_;
};

/// Adds the volumetric response U(theta(F)) of one point.
/// @param p  replaces U' in the geometric part of the Hessian
template <bool WithHessian>
void add_bulk_response(const material::ScalarFunctionOf<Pack>& U, const Pack& p,
                       const material::TensorFunctionOf<Pack>& theta, Pack& value, material::Matrix3<Pack>& P,
                       material::Matrix9<Pack>& A) {
    value += U.value;
    P += theta.gradient * U.first;
    if constexpr (WithHessian)
        material::for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            A(row, column) += U.second * theta.gradient(i, j) * theta.gradient(k, l) + p * theta.hessian(row, column);
        });
}

/// Adds energy, gradient and optionally Hessian of one pack of cells.
///
/// An inverted cell gives non-finite values where the law is undefined.
template <bool WithHessian, class Geometry>
void add_response(const PackedCells<Geometry>& cells, int pack, const PointKinematics<Geometry>& points,
                  const PackInput& in, PackOutput<Geometry::nodes>& out) {
    // Geometry with weights per point may have a mean volume; that of assumed strains has none.
    constexpr bool has_mean_volume = requires(const Geometry& g) { g.weight; };
    StressSum<Geometry> stress(points);
    std::optional<StiffnessSum<Geometry>> stiffness;
    if constexpr (WithHessian) stiffness.emplace(points, out.hessian);
    std::optional<ElasticPoints<Geometry>> elastic;
    if (in.elastic) elastic.emplace(cells, pack, in.elasticity);
    const bool mean = elastic && elastic->mean();
    std::optional<MeanVolume<WithHessian, Geometry>> volume;
    if (mean) volume.emplace(points);

    material::LawResponse<Pack>& law = out.law;
    for (int q = 0; q < Geometry::points; ++q) {
        const Pack weight = points.weight(q);
        const material::Matrix3<Pack> F = points.gradient(q);
        material::Matrix3<Pack> P = zero_tensor();
        Pack pressure_change = 0.0;  // of the geometric stiffness, relative to the current pressure
        material::Matrix9<Pack> A;
        Pack density = 0.0;
        if (elastic && !WithHessian && !mean) {
            // Fast path: the law evaluates energy and stress in one call if no split is needed.
            const Pack factor = in.elasticity.factor(q);
            in.elasticity.law->respond_whole(F, in.elasticity.mu * factor, in.elasticity.kappa * factor, density, P);
        } else if (elastic) {
            const PointState point = elastic->respond(q, weight, F, WithHessian, law);
            density = law.distortion.value;
            P = law.distortion.gradient;
            if constexpr (WithHessian) A = law.distortion.hessian;
            if constexpr (has_mean_volume)
                if (mean) volume->add(point);
            if (elastic->at_points()) {
                const material::ScalarFunctionOf<Pack> U = elastic->bulk_at(point);
                const Pack p = in.pressure && !mean ? entry(in.pressure, q) : U.first;
                pressure_change = p - U.first;
                add_bulk_response<WithHessian>(U, p, law.volume, density, P, A);
            }
        } else if constexpr (WithHessian) {
            A.setConstant(Pack(0.0));
        }
        if (in.viscous)
            add_viscous_response<WithHessian>(F, in.viscous_mu * in.viscous_factor(q), in.rate_factor, in.rate_history,
                                              q, density, P, A);
        out.energy += weight * density;
        stress.add(q, P * weight);
        // P enters the curvature of F(x). It must contain the same pressure as the geometric part of A.
        if constexpr (WithHessian) {
            if (elastic && elastic->split()) P += law.volume.gradient * pressure_change;
            stiffness->add(q, A * weight, P * weight);
        }
    }
    stress.add_to(out.gradient);
    if constexpr (WithHessian) stiffness->finish();
    if constexpr (has_mean_volume)
        if (mean) {
            const material::ScalarFunctionOf<Pack> U = elastic->bulk_of_mean();
            volume->finish(points, U, in.pressure ? load_pack(in.pressure) : U.first, out);
        }
}

/// Energy, gradient and optionally Hessian of one pack of cells at the nodal positions x [m].
template <bool WithHessian, class Geometry>
void evaluate_pack(const PackedCells<Geometry>& cells, int pack, const PackNodes<Geometry::nodes>& x,
                   const PackInput& in, PackOutput<Geometry::nodes>& out) {
    const PointKinematics<Geometry> points(cells.geometry(pack), cells.surroundings_of(pack), x, in.poissons_ratio);
    out.energy = 0.0;
    out.gradient.setConstant(Pack(0.0));
    if constexpr (WithHessian)
        for (material::Matrix3<Pack>& block : out.hessian) block.setConstant(Pack(0.0));
    add_response<WithHessian>(cells, pack, points, in, out);
}

}  // namespace myo::model
