#pragma once

#include <array>

#include "model/point_kinematics.hpp"

namespace myo::model {

/// Assumed strains of one pack of cells, see AssumedStrainGeometry: values at the corner points of the two parts.
struct AssumedStrains {
    std::array<PackSymmetric, 3> linear, bilinear;  // A_k (linear in one coordinate), B_k (bilinear)
};

/// Strain H at the eight corner points. The bits of q - 1 are the signs of the corner's coordinates, see
/// assumed_strain_point().
using CornerStrains = std::array<PackSymmetric, 8>;

/// Evaluates H at all corners by sums and differences of pairs (butterfly), so that common terms are added once.
inline void set_at_corners(const AssumedStrains& strains, CornerStrains& H) {
    for (std::size_t k = 0; k < 6; ++k) {
        const Pack a0 = strains.linear[0][k], a1 = strains.linear[1][k], a2 = strains.linear[2][k];
        const Pack b0 = strains.bilinear[0][k], b1 = strains.bilinear[1][k], b2 = strains.bilinear[2][k];
        // Opposite corners have opposite linear parts and equal bilinear parts. The values below are for +xi_3.
        const Pack same = a0 + a1, other = a0 - a1, b_same = b0 + b1, b_other = b0 - b1;
        const Pack odd3 = a2 - same, even3 = b2 - b_same;    // signs (-, -, +)
        const Pack odd0 = a2 + other, even0 = b1 - b0 - b2;  // (+, -, +)
        const Pack odd1 = a2 - other, even1 = b_other - b2;  // (-, +, +)
        const Pack odd2 = a2 + same, even2 = b2 + b_same;    // (+, +, +)
        H[4][k] = even3 + odd3, H[3][k] = even3 - odd3;
        H[5][k] = even0 + odd0, H[2][k] = even0 - odd0;
        H[6][k] = even1 + odd1, H[1][k] = even1 - odd1;
        H[7][k] = even2 + odd2, H[0][k] = even2 - odd2;
    }
}

/// Transpose of set_at_corners(): corner stresses to the stresses conjugate to A_k and B_k.
inline AssumedStrains from_corners(const CornerStrains& R) {
    AssumedStrains sums;
    for (std::size_t k = 0; k < 6; ++k) {
        const Pack odd3 = R[4][k] - R[3][k], even3 = R[4][k] + R[3][k], odd0 = R[5][k] - R[2][k],
                   even0 = R[5][k] + R[2][k];
        const Pack odd1 = R[6][k] - R[1][k], even1 = R[6][k] + R[1][k], odd2 = R[7][k] - R[0][k],
                   even2 = R[7][k] + R[0][k];
        sums.linear[0][k] = (odd2 - odd3) + (odd0 - odd1);
        sums.linear[1][k] = (odd2 - odd3) - (odd0 - odd1);
        sums.linear[2][k] = (odd2 + odd3) + (odd0 + odd1);
        sums.bilinear[0][k] = (even2 - even3) - (even0 - even1);
        sums.bilinear[1][k] = (even2 - even3) + (even0 - even1);
        sums.bilinear[2][k] = (even2 + even3) - (even0 + even1);
    }
    return sums;
}

/// Linear map from the amplitudes c(s, i) = edge i . F0^-1 q_s of the shapes to the assumed strains, and its transpose.
///
/// An in-plane strain of trace t keeps the share s of its equibiaxial part:
///   A = in-plane - (1 - s)/2 t (I - n n') - s t nu/(1 - nu) n n'.
struct AssumedStrainMap {
    const PackAssumedStrain& geometry;
    Pack poissons_ratio;                   // nu per cell
    std::array<Pack, 3> left_out, across;  // per plane: (1 - s)/2, and the coefficient of t on n n'

    /// @param relaxed  AssumedStrainGeometry::relaxed of each cell; 0: bending is not constrained by neighbours, s = 1
    /// @param nu       Poisson's ratio of each cell
    AssumedStrainMap(const PackAssumedStrain& g, const PackSurroundings& relaxed, const Pack& nu)
        : geometry(g), poissons_ratio(nu) {
        // s = relaxed sqrt((1 - nu)/(1 + nu)) gives the equibiaxial strain the stiffness of the others, see
        // AssumedStrainPolicy.
        const Pack thinning = nu / (1.0 - nu), even = sqrt((1.0 - nu) / (1.0 + nu));
        for (std::size_t k = 0; k < 3; ++k) {
            Pack s = relaxed[k] * even;
            set_where(relaxed[k] == 0.0, s, 1.0);
            left_out[k] = 0.5 * (1.0 - s);
            across[k] = left_out[k] - thinning * s;
        }
    }

    /// Values of the linear and the bilinear shape at a corner point, see fem::AssumedStrainRule.
    static constexpr double linear_scale = fem::AssumedStrainRule::corner;
    static constexpr double bilinear_scale = fem::AssumedStrainRule::corner * fem::AssumedStrainRule::corner *
                                             fem::AssumedStrainRule::bilinear_share;

    /// Strain of a plane per unit of its m-th measure (E_ii, E_jj, 2 E_ij) at a corner.
    PackSymmetric basis(std::size_t plane, std::size_t m) const {
        const PackAssumedStrain::Plane& p = geometry.planes[plane];
        PackSymmetric a;
        for (std::size_t k = 0; k < 6; ++k)
            a[k] = linear_scale * (p.in_plane[m][k] +
                                   p.trace[m] * (across[plane] * p.normal[k] - (k < 3 ? left_out[plane] : Pack(0.0))));
        return a;
    }
    /// Strain per unit of the amplitude along an edge, at a corner: uniaxial stress along the edge.
    PackSymmetric bilinear_basis(std::size_t edge) const {
        const PackSymmetric& t = geometry.along[edge];
        // Uniaxial stress: (1 + nu) t t' - nu tr(t t') I has strain 1 along t and -nu across it.
        const Pack sideways = poissons_ratio * (t[0] + t[1] + t[2]);
        PackSymmetric b;
        for (std::size_t k = 0; k < 6; ++k)
            b[k] = bilinear_scale * ((1.0 + poissons_ratio) * t[k] - (k < 3 ? sideways : Pack(0.0)));
        return b;
    }

    /// Strains A_k, B_k from h = F0^-1 q, 3 x 4.
    AssumedStrains apply(const Eigen::Matrix<Pack, 3, 4>& h) const {
        Eigen::Matrix<Pack, 4, 3> c;
        for (int i = 0; i < 3; ++i)
            for (int s = 0; s < 4; ++s)
                c(s, i) = geometry.edges(0, i) * h(0, s) + geometry.edges(1, i) * h(1, s) +
                          geometry.edges(2, i) * h(2, s);
        AssumedStrains strains;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            const auto plane = static_cast<std::size_t>(k);
            const PackAssumedStrain::Plane& p = geometry.planes[plane];
            // Covariant measures E_ii, E_jj and 2 E_ij of the plane at a corner.
            const Pack e0 = linear_scale * c(j, i), e1 = linear_scale * c(i, j),
                       e2 = linear_scale * (c(i, i) + c(j, j));
            const Pack trace = p.trace[0] * e0 + p.trace[1] * e1 + p.trace[2] * e2, normal = across[plane] * trace,
                       even = left_out[plane] * trace;
            for (std::size_t m = 0; m < 6; ++m)
                strains.linear[plane][m] = p.in_plane[0][m] * e0 + p.in_plane[1][m] * e1 + p.in_plane[2][m] * e2 +
                                           normal * p.normal[m];
            for (std::size_t m = 0; m < 3; ++m) strains.linear[plane][m] -= even;
            const PackSymmetric& t = geometry.along[plane];
            const Pack e = bilinear_scale * c(3, k), more = (1.0 + poissons_ratio) * e,
                       less = poissons_ratio * e * (t[0] + t[1] + t[2]);
            for (std::size_t m = 0; m < 6; ++m) strains.bilinear[plane][m] = more * t[m];
            for (std::size_t m = 0; m < 3; ++m) strains.bilinear[plane][m] -= less;
        }
        return strains;
    }

    /// Transpose of apply(): dW/dh from dW/d(A_k, B_k).
    Eigen::Matrix<Pack, 3, 4> transposed(const AssumedStrains& stress) const {
        Eigen::Matrix<Pack, 4, 3> c;
        c.setConstant(Pack(0.0));
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            const auto plane = static_cast<std::size_t>(k);
            const PackAssumedStrain::Plane& p = geometry.planes[plane];
            const PackSymmetric& r = stress.linear[plane];
            // Transposed operations in reverse order: the trace collects the normal and the isotropic part.
            const Pack of_trace = across[plane] * double_dot(p.normal, r) - left_out[plane] * (r[0] + r[1] + r[2]);
            const auto measure = [&](std::size_t m) {
                return linear_scale * (double_dot(p.in_plane[m], r) + of_trace * p.trace[m]);
            };
            const Pack twist = measure(2);
            c(j, i) += measure(0);
            c(i, j) += measure(1);
            c(i, i) += twist;
            c(j, j) += twist;
            const PackSymmetric &t = geometry.along[plane], &b = stress.bilinear[plane];
            c(3, k) += bilinear_scale * ((1.0 + poissons_ratio) * double_dot(t, b) -
                                         poissons_ratio * (t[0] + t[1] + t[2]) * (b[0] + b[1] + b[2]));
        }
        Eigen::Matrix<Pack, 3, 4> S;
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i)
                S(i, s) = geometry.edges(i, 0) * c(s, 0) + geometry.edges(i, 1) * c(s, 1) +
                          geometry.edges(i, 2) * c(s, 2);
        return S;
    }
};

/// Cell with assumed strains: F = F0 at the centre point (q = 0) and F = F0 (I + H + H^2/2) at the corners q = 1 ... 8.
template <>
class PointKinematics<PackAssumedStrain> {
public:
    /// Variation of F along a nodal motion: dF0, and dH at the corners.
    struct Motion {
        material::Matrix3<Pack> mean;
        CornerStrains strains;
    };

    /// @param x  nodal positions of the pack [m]
    PointKinematics(const PackAssumedStrain& geometry, const PackSurroundings& surroundings, const PackNodes<8>& x,
                    const Pack& poissons_ratio)
        : map_(geometry, surroundings, poissons_ratio),
          mean_(nodal_product(x, geometry.gradient)),
          inverse_(inverse(mean_)) {
        shapes_ = through_inverse(nodal_product(x, geometry.gamma));
        set_at_corners(map_.apply(shapes_), strain_);
        // Second-order truncation of exp H: never singular, and its determinant equals exp(tr H) up to third order.
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const PackSymmetric& H = strain_[corner];
            PackSymmetric& M = stretch_[corner];
            const Pack xy = H[3] * H[3], yz = H[4] * H[4], zx = H[5] * H[5];
            M[0] = 1.0 + H[0] + 0.5 * (H[0] * H[0] + xy + zx);
            M[1] = 1.0 + H[1] + 0.5 * (H[1] * H[1] + xy + yz);
            M[2] = 1.0 + H[2] + 0.5 * (H[2] * H[2] + yz + zx);
            M[3] = H[3] + 0.5 * ((H[0] + H[1]) * H[3] + H[4] * H[5]);
            M[4] = H[4] + 0.5 * ((H[1] + H[2]) * H[4] + H[5] * H[3]);
            M[5] = H[5] + 0.5 * ((H[2] + H[0]) * H[5] + H[3] * H[4]);
        }
    }

    /// Deformation gradient at point q, 0 ... 8.
    material::Matrix3<Pack> gradient(int q) const { return q == 0 ? mean_ : times_symmetric(mean_, stretch(q)); }
    /// Quadrature weight of point q [m3].
    Pack weight(int q) const {
        return (q == 0 ? fem::AssumedStrainRule::middle_weight : fem::AssumedStrainRule::corner_weight) *
               map_.geometry.volume;
    }

    /// Variation along nodal displacements dx.
    Motion along(const PackNodes<8>& dx) const {
        // Product rule for the inverse: d(F0^-1 q) = F0^-1 (dq - dF0 F0^-1 q).
        const material::Matrix3<Pack> dF = nodal_product(dx, map_.geometry.gradient);
        Eigen::Matrix<Pack, 3, 4> dq = nodal_product(dx, map_.geometry.gamma);
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i)
                dq(i, s) -= dF(i, 0) * shapes_(0, s) + dF(i, 1) * shapes_(1, s) + dF(i, 2) * shapes_(2, s);
        Motion motion;
        motion.mean = dF;
        set_at_corners(map_.apply(through_inverse(dq)), motion.strains);
        return motion;
    }
    /// dF at point q for a motion from along().
    material::Matrix3<Pack> tangent(int q, const Motion& motion) const {
        if (q == 0) return motion.mean;
        const PackSymmetric& dH = motion.strains[static_cast<std::size_t>(q - 1)];
        PackSymmetric dM = anticommutator_half(dH, strain(q));
        for (std::size_t k = 0; k < 6; ++k) dM[k] += dH[k];
        return times_symmetric(motion.mean, stretch(q)) + times_symmetric(mean_, dM);
    }

    /// Map from nodal shapes to strains of this pack.
    const AssumedStrainMap& map() const { return map_; }
    /// F0, mean deformation gradient.
    const material::Matrix3<Pack>& mean() const { return mean_; }
    /// F0^-1.
    const material::Matrix3<Pack>& mean_inverse() const { return inverse_; }
    /// H at corner q = 1 ... 8.
    const PackSymmetric& strain(int q) const { return strain_[static_cast<std::size_t>(q - 1)]; }
    /// I + H + H^2/2 at corner q = 1 ... 8.
    const PackSymmetric& stretch(int q) const { return stretch_[static_cast<std::size_t>(q - 1)]; }

    /// Gamma = gamma - G F0^-1 q, the nodal map of the shapes in the current configuration: d(F0^-1 q) = F0^-1 dx
    /// Gamma.
    Eigen::Matrix<Pack, 8, 4> gamma() const {
        Eigen::Matrix<Pack, 8, 4> result;
        const PackAssumedStrain& g = map_.geometry;
        for (int s = 0; s < 4; ++s)
            for (int a = 0; a < 8; ++a)
                result(a, s) = g.gamma(a, s) - (g.gradient(a, 0) * shapes_(0, s) + g.gradient(a, 1) * shapes_(1, s) +
                                                g.gradient(a, 2) * shapes_(2, s));
        return result;
    }

private:
    /// F0^-1 q.
    Eigen::Matrix<Pack, 3, 4> through_inverse(const Eigen::Matrix<Pack, 3, 4>& q) const {
        Eigen::Matrix<Pack, 3, 4> h;
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i)
                h(i, s) = inverse_(i, 0) * q(0, s) + inverse_(i, 1) * q(1, s) + inverse_(i, 2) * q(2, s);
        return h;
    }

    AssumedStrainMap map_;
    material::Matrix3<Pack> mean_, inverse_;  // F0, F0^-1
    Eigen::Matrix<Pack, 3, 4> shapes_;        // F0^-1 q
    std::array<PackSymmetric, 8> strain_;     // H at the corners
    std::array<PackSymmetric, 8> stretch_;    // I + H + H^2/2
};

/// Accumulates dW/dF of the points and maps it to nodal forces.
template <>
class StressSum<PackAssumedStrain> {
public:
    /// @param points  must outlive the sum
    explicit StressSum(const PointKinematics<PackAssumedStrain>& points) : points_(points), mean_(zero_tensor()) {
        for (PackSymmetric& s : corners_) s.fill(Pack(0.0));
    }

    /// Adds point q with P = dW/dF [J].
    void add(int q, const material::Matrix3<Pack>& P) {
        if (q == 0) {
            mean_ += P;
            return;
        }
        // F = F0 M: the derivative with respect to F0 at fixed M is P M.
        mean_ += times_symmetric(P, points_.stretch(q));
        // dW = F0'P : dM with dM = dH + (dH H + H dH) / 2.
        const PackSymmetric Y = symmetric_part(transposed_product(points_.mean(), P));
        const PackSymmetric R = anticommutator_half(Y, points_.strain(q));
        PackSymmetric& sum = corners_[static_cast<std::size_t>(q - 1)];
        for (std::size_t k = 0; k < 6; ++k) sum[k] += Y[k] + R[k];
    }

    /// dW/dq = F0^-T dW/d(F0^-1 q).
    Eigen::Matrix<Pack, 3, 4> of_shapes() const {
        const Eigen::Matrix<Pack, 3, 4> S = points_.map().transposed(from_corners(corners_));
        const material::Matrix3<Pack>& inverse = points_.mean_inverse();
        Eigen::Matrix<Pack, 3, 4> T;
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i)
                T(i, s) = inverse(0, i) * S(0, s) + inverse(1, i) * S(1, s) + inverse(2, i) * S(2, s);
        return T;
    }

    /// Adds dW/dx to the nodal forces [N].
    void add_to(PackNodes<8>& forces) const {
        add_nodal(mean_, points_.map().geometry.gradient, forces);
        add_nodal(of_shapes(), points_.gamma(), forces);
    }

private:
    const PointKinematics<PackAssumedStrain>& points_;
    material::Matrix3<Pack> mean_;  // dW/dF0 at fixed strains
    CornerStrains corners_;         // dW/dH
};

}  // namespace myo::model
