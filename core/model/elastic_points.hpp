#pragma once

#include "base/pack.hpp"
#include "material/material.hpp"
#include "model/packed_cells.hpp"
#include "model/point_bulk.hpp"
#include "model/point_kinematics.hpp"

namespace myo::model {

/// Entry i of a per-cell field. `field` points to the start of a pack's data.
inline Pack entry(const double* field, int i) { return load_pack(field + i * pack_width); }

/// Law and elastic moduli of a pack of cells.
struct PackElasticity {
    const material::Material* law = nullptr;  // required
    Pack mu = 0.0, kappa = 0.0;               // [Pa] moduli
    PointBulk point_bulk;                     // bulk modulus at the points of cells with a mean volume
    const double* factors = nullptr;          // scale mu and kappa, per point; null: 1

    /// Factor of the moduli at point q.
    Pack factor(int q) const { return factors ? entry(factors, q) : Pack(1.0); }
};

/// One quadrature point of a pack with the response of its law.
struct PointState {
    int q;
    Pack weight;  // [m3]
    Pack share;   // weight over the volume of the cell; unset without a mean volume
    Pack factor;  // of the moduli
    material::Matrix3<Pack> F;
    const material::LawResponse<Pack>& law;  // distortion for the moduli times the factor
};

/// The law at the points of a pack, and the split of its bulk modulus: between the volume measure theta of each point
/// and, in elements with a mean volume, the average of theta over the cell (mean dilatation).
///
/// Forces, stiffness, work, pressures and mean stresses differ only in what they sum over the points.
template <class Geometry>
class ElasticPoints {
public:
    /// @param in  must outlive the object
    ElasticPoints(const PackedCells<Geometry>& cells, int pack, const PackElasticity& in) : in_(in) {
        // Laws without a split cannot exchange their volume measure; they are evaluated as a whole.
        split_ = in.law->has_split();
        // Cells with assumed strain have no volumetric locking, hence no mean volume.
        if constexpr (requires(const Geometry& g) { g.weight; }) mean_ = cells.mean_volume && split_;
        at_points_ = split_ && (!mean_ || !cells.point_bulk_over_mu.empty());
        point_kappa_ = in.kappa;
        if (!mean_) return;
        point_kappa_ = in.point_bulk.of(in.mu, in.kappa);
        inverse_volume_ = 1.0 / cells.geometry(pack).volume;
    }

    /// True if the law has a volume measure.
    bool split() const { return split_; }
    /// True if the average of theta carries a part of the bulk modulus.
    bool mean() const { return mean_; }
    /// True if theta of each point carries a part of the bulk modulus.
    bool at_points() const { return at_points_; }

    /// Evaluates the law at a point and adds the point to the averages of its cell.
    PointState respond(int q, const Pack& weight, const material::Matrix3<Pack>& F, bool with_hessian,
                       material::LawResponse<Pack>& law) {
        const Pack factor = in_.factor(q), share = weight * inverse_volume_;
        in_.law->respond(F, in_.mu * factor, in_.kappa * factor, with_hessian, law);
        if (mean_) {
            theta_ += share * law.volume.value;
            factor_ += share * factor;
        }
        return {q, weight, share, factor, F, law};
    }
    /// Calls visit(PointState) for each point. The averages are complete afterwards.
    template <class Visit>
    void visit(const PointKinematics<Geometry>& points, const Visit& visit) {
        material::LawResponse<Pack> law;
        for (int q = 0; q < Geometry::points; ++q) visit(respond(q, points.weight(q), points.gradient(q), false, law));
    }

    /// U(theta) of the part at a point [J/m3].
    material::ScalarFunctionOf<Pack> bulk_at(const PointState& point) const {
        return in_.law->bulk(point.law.volume.value, point_kappa_ * point.factor);
    }
    /// First Piola-Kirchhoff stress at a point [Pa], without the pressure of the mean volume.
    material::Matrix3<Pack> stress_at(const PointState& point) const {
        if (!at_points_) return point.law.distortion.gradient;
        return point.law.distortion.gradient + point.law.volume.gradient * bulk_at(point).first;
    }
    /// U of the mean volume [J/m3] for the average of the factors, after all points.
    material::ScalarFunctionOf<Pack> bulk_of_mean() const { return bulk_of_mean(factor_); }
    /// U of the mean volume for another factor of its bulk modulus.
    material::ScalarFunctionOf<Pack> bulk_of_mean(const Pack& factor) const {
        return in_.law->bulk(theta_, (in_.kappa - point_kappa_) * factor);
    }
    /// U of the mean volume for a bulk modulus of 1.
    material::ScalarFunctionOf<Pack> unit_bulk_of_mean() const { return in_.law->bulk(theta_, factor_); }

private:
    const PackElasticity& in_;
    // See split(), mean() and at_points().
    bool split_ = false, mean_ = false, at_points_ = false;
    Pack inverse_volume_ = 0.0, point_kappa_ = 0.0;
    Pack theta_ = 0.0, factor_ = 0.0;  // averages over the points of each cell
};

}  // namespace myo::model
