#include "model/law_force.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using law::Variable;

/// Gauss-Legendre rule of five points on [0, 1]: exact to degree 9.
constexpr std::array<double, 5> way_points = {0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415,
                                              0.9530899229693319};
constexpr std::array<double, 5> way_weights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                               0.23931433524968324, 0.11846344252809454};

/// Place where the values of one lane come from.
struct Site {
    const LawCarrier* carrier;
    const LawPoint* point;
};

/// Tangents and normal of a deformed face at a point.
struct FaceFrame {
    Vector3d t1 = Vector3d::Zero(), t2 = Vector3d::Zero(), normal = Vector3d::Zero();
    double measure = 1.0;
};

/// Nodal field at the place of a site.
Vector3d field_at(const Site& site, const Matrix3Xd& field) {
    Vector3d value = Vector3d::Zero();
    for (std::size_t a = 0; a < site.carrier->nodes.size(); ++a)
        value += site.point->shape(static_cast<Index>(a)) * field.col(site.carrier->nodes[a]);
    return value;
}

/// Derivative of a nodal field along the first or second parameter of the site's face.
Vector3d slope_at(const Site& site, const Matrix3Xd& field, Index along) {
    Vector3d value = Vector3d::Zero();
    for (std::size_t a = 0; a < site.carrier->nodes.size(); ++a)
        value += site.point->gradient(static_cast<Index>(a), along) * field.col(site.carrier->nodes[a]);
    return value;
}

/// Frame of the deformed face; that at rest for points without a face.
FaceFrame frame_at(const Site& site, const Matrix3Xd& x) {
    FaceFrame frame;
    frame.normal = site.point->normal;
    frame.measure = site.point->rest_measure;
    if (site.point->gradient.rows() == 0) return frame;
    frame.t1 = slope_at(site, x, 0);
    frame.t2 = slope_at(site, x, 1);
    const Vector3d N = frame.t1.cross(frame.t2);
    frame.measure = N.norm();
    frame.normal = N / frame.measure;
    return frame;
}

/// Distributes a force at a site to the nodes of its carrier.
void add_at_nodes(const Site& site, const Vector3d& force, Matrix3Xd& to) {
    for (std::size_t a = 0; a < site.carrier->nodes.size(); ++a)
        to.col(site.carrier->nodes[a]) += site.point->shape(static_cast<Index>(a)) * force;
}

/// Nearest positive semidefinite matrix of a symmetric one.
Matrix3d positive_part_of(const Matrix3d& H) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(H);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

/// What differs between points.
struct FieldPoint {
    Vector3d x = Vector3d::Zero(), v = Vector3d::Zero(), normal = Vector3d::Zero();
    double area_ratio = 1.0;
};

/// Registers of a program with the values of one set of points.
struct Run {
    const law::Program& program;
    law::Program::Registers registers;
    std::array<FieldPoint, law::lane_count> states{};

    void fill(int variable, double value) {
        if (law::Lanes* const lanes = program.input(registers, variable)) lanes->fill(value);
    }
    void fill(int first, const Vector3d& value) {
        for (int i = 0; i < 3; ++i) fill(first + i, value(i));
    }
    void set(int variable, std::size_t lane, double value) {
        if (law::Lanes* const lanes = program.input(registers, variable)) (*lanes)[lane] = value;
    }
    void set(int first, std::size_t lane, const Vector3d& value) {
        for (int i = 0; i < 3; ++i) set(first + i, lane, value(i));
    }
    double output(std::size_t k, std::size_t lane) const { return program.output(registers, k)[lane]; }
    Vector3d vector(std::size_t first, std::size_t lane) const {
        return {output(first, lane), output(first + 1, lane), output(first + 2, lane)};
    }
    /// Block of derivatives, rows of three; zero if there is none.
    Matrix3d matrix(std::size_t first, std::size_t lane) const {
        Matrix3d result = Matrix3d::Zero();
        if (first == 0) return result;
        for (std::size_t k = 0; k < 9; ++k)
            result(static_cast<Index>(k / 3), static_cast<Index>(k % 3)) = output(first + k, lane);
        return result;
    }
};

/// See law_force().
class LawForce : public ForceElement {
public:
    LawForce(std::shared_ptr<const LawPrograms> law, std::shared_ptr<const std::vector<LawCarrier>> carriers,
             LawConditions conditions, VectorXd numbers, VectorXd scales)
        : law_(std::move(law)),
          carriers_(std::move(carriers)),
          conditions_(std::move(conditions)),
          numbers_(std::move(numbers)),
          scales_(std::move(scales)) {
        for (const LawCarrier& carrier : *carriers_)
            for (const LawPoint& point : carrier.points) sites_.push_back({&carrier, &point});
    }

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        if (is_integrated()) out.energy -= work_from_rest(at);
        if (kind == HessianKind::none) {
            for_each_site(law_->force, at, [&](const Site& site, std::size_t lane, const Run& run) {
                out.energy += energy_at(site, lane, run, at);
                add_at_nodes(site, -site.point->weight * run.vector(0, lane), out.gradient);
            });
            return;
        }
        // The stiffness of a carrier is summed over its points, so that the matrix is searched once for each carrier.
        MatrixXd sum;
        for_each_site(law_->tangent, at, [&](const Site& site, std::size_t lane, const Run& run) {
            const double weight = site.point->weight;
            out.energy += energy_at(site, lane, run, at);
            add_at_nodes(site, -weight * run.vector(0, lane), out.gradient);
            Matrix3d H = symmetric(-weight * by_motion(at, lane, run));
            if (kind != HessianKind::exact) H = positive_part_of(H);
            const auto count = static_cast<Index>(site.carrier->nodes.size());
            if (site.point == &site.carrier->points.front()) sum = MatrixXd::Zero(3 * count, 3 * count);
            for (Index b = 0; b < count; ++b)
                for (Index a = 0; a < count; ++a)
                    sum.block<3, 3>(3 * a, 3 * b) += site.point->shape(a) * site.point->shape(b) * H;
            if (site.point != &site.carrier->points.back()) return;
            add_face_hessian(body, *site.carrier, out.hessian, [&](std::size_t a, std::size_t b) {
                return Matrix3d(sum.block<3, 3>(3 * static_cast<Index>(a), 3 * static_cast<Index>(b)));
            });
        });
    }

    bool depends_on_velocity() const override { return law_->uses_v; }
    void add_velocity_tangent(const Body&, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        if (!law_->uses_v || !at.v) return;
        for_each_site(law_->tangent, at, [&](const Site& site, std::size_t lane, const Run& run) {
            add_at_nodes(site, -site.point->weight * run.matrix(law_->by_v, lane) * field_at(site, dv), gradient);
        });
    }
    void add_velocity_pull(const Body&, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_v) const override {
        if (!law_->uses_v || !at.v) return;
        for_each_site(law_->tangent, at, [&](const Site& site, std::size_t lane, const Run& run) {
            add_at_nodes(site, -site.point->weight * run.matrix(law_->by_v, lane).transpose() * field_at(site, p),
                         by_v);
        });
    }

    bool has_potential() const override { return law_->potential != LawPotential::none; }
    void add_unsymmetric_tangent(const Body&, const ForceState& at, const Matrix3Xd& dx,
                                 Matrix3Xd& gradient) const override {
        if (has_potential()) return;
        for_each_site(law_->tangent, at, [&](const Site& site, std::size_t lane, const Run& run) {
            Vector3d change = skew(by_motion(at, lane, run)) * field_at(site, dx);
            if (site.point->gradient.rows() > 0) {
                const FaceFrame frame = frame_at(site, at.x);
                const Vector3d dN = slope_at(site, dx, 0).cross(frame.t2) + frame.t1.cross(slope_at(site, dx, 1));
                change += by_normal(site, frame, lane, run) * dN;
            }
            add_at_nodes(site, -site.point->weight * change, gradient);
        });
    }
    void add_unsymmetric_pull(const Body&, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_x) const override {
        if (has_potential()) return;
        for_each_site(law_->tangent, at, [&](const Site& site, std::size_t lane, const Run& run) {
            const double weight = site.point->weight;
            const Vector3d q = field_at(site, p);
            add_at_nodes(site, -weight * skew(by_motion(at, lane, run)).transpose() * q, by_x);
            if (site.point->gradient.rows() == 0) return;
            const FaceFrame frame = frame_at(site, at.x);
            const Vector3d g = by_normal(site, frame, lane, run).transpose() * q;
            // g . (dt1 x t2 + t1 x dt2).
            const Vector3d of_t1 = frame.t2.cross(g), of_t2 = g.cross(frame.t1);
            for (std::size_t a = 0; a < site.carrier->nodes.size(); ++a) {
                const auto row = static_cast<Index>(a);
                by_x.col(site.carrier->nodes[a]) -= weight * (site.point->gradient(row, 0) * of_t1 +
                                                              site.point->gradient(row, 1) * of_t2);
            }
        });
    }

    std::vector<ForceParameter> parameters() const override {
        std::vector<ForceParameter> list;
        for (const law::Law::Parameter& parameter : law_->law.parameters)
            for (int i = 0; i < parameter.count(); ++i) {
                const auto k = static_cast<Index>(list.size());
                const std::string axis = parameter.count() > 1 ? std::string(".") + "xyz"[i] : "";
                list.push_back({parameter.name + axis, numbers_(k), scales_(k)});
            }
        return list;
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<LawForce>(law_, carriers_, conditions_, values, scales_);
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        if (numbers_.size() == 0) return;
        for_each_site(law_->by_number, at, [&](const Site& site, std::size_t lane, const Run& run) {
            Vector3d force = Vector3d::Zero();
            for (Index k = 0; k < change.size(); ++k)
                if (change(k) != 0.0) force += change(k) * run.vector(3 * static_cast<std::size_t>(k), lane);
            add_at_nodes(site, -site.point->weight * force, gradient);
        });
    }

    // Only then does a step that gains energy show that it is too long.
    bool steady(double, double) const override { return law_->keeps_energy && !law_->uses_time; }

    const LawPrograms* law() const { return law_.get(); }
    const VectorXd& numbers() const { return numbers_; }

private:
    static Matrix3d symmetric(const Matrix3d& G) { return 0.5 * (G + G.transpose()); }
    static Matrix3d skew(const Matrix3d& G) { return 0.5 * (G - G.transpose()); }

    /// Derivative of the force by the place of its point in a time step, in which dv/dx is given.
    Matrix3d by_motion(const ForceState& at, std::size_t lane, const Run& run) const {
        Matrix3d G = run.matrix(law_->by_x, lane);
        // Within a step the velocity follows the position, so its derivative counts as well.
        if (at.v && at.velocity_factor_1_s != 0.0) G += at.velocity_factor_1_s * run.matrix(law_->by_v, lane);
        return G;
    }

    /// Derivative of the force by N = t1 x t2, of which the normal and the area are functions.
    Matrix3d by_normal(const Site& site, const FaceFrame& frame, std::size_t lane, const Run& run) const {
        const Vector3d& n = frame.normal;
        Matrix3d result = run.matrix(law_->by_n, lane) * (Matrix3d::Identity() - n * n.transpose()) / frame.measure;
        if (law_->by_area > 0) result += run.vector(law_->by_area, lane) * n.transpose() / site.point->rest_measure;
        return result;
    }

    /// What all points have in common.
    Run run_of(const law::Program& program, const ForceState& at) const {
        Run run{program, program.registers()};
        run.fill(Variable::t, at.time_s);
        run.fill(Variable::gravity, conditions_.gravity_m_s2);
        run.fill(Variable::session_time, conditions_.session_time_s);
        Index k = 0;
        for (const law::Law::Parameter& parameter : law_->law.parameters)
            for (int i = 0; i < parameter.count(); ++i) run.fill(parameter.variable + i, numbers_(k++));
        for (std::size_t c = 0; c < law_->law.conditions.size(); ++c)
            run.fill(law_->law.conditions[c].variable, conditions_.conditions[c]);
        return run;
    }

    FieldPoint state_of(const Site& site, const ForceState& at) const {
        FieldPoint state;
        state.normal = site.point->normal;
        // A constant force has a way as well.
        if (law_->uses_x || law_->potential == LawPotential::of_positions) state.x = field_at(site, at.x);
        if (at.v && law_->uses_v) state.v = field_at(site, *at.v);
        if (!law_->uses_n && !law_->uses_area) return state;
        const FaceFrame frame = frame_at(site, at.x);
        state.normal = frame.normal;
        state.area_ratio = frame.measure / site.point->rest_measure;
        return state;
    }
    static void set(const Site& site, std::size_t lane, const FieldPoint& state, Run& run) {
        run.set(Variable::x, lane, state.x);
        run.set(Variable::v, lane, state.v);
        run.set(Variable::X, lane, site.point->rest_m);
        run.set(Variable::n, lane, state.normal);
        run.set(Variable::area_ratio, lane, state.area_ratio);
    }

    std::size_t lanes_from(std::size_t first) const { return std::min(sites_.size() - first, law::lane_count); }

    /// Calls visit(site, lane, run) for all points in order, with the outputs of the program.
    template <class Visit>
    void for_each_site(const law::Program& program, const ForceState& at, const Visit& visit) const {
        Run run = run_of(program, at);
        for (std::size_t first = 0; first < sites_.size(); first += law::lane_count) {
            const std::size_t count = lanes_from(first);
            for (std::size_t l = 0; l < count; ++l) {
                run.states[l] = state_of(sites_[first + l], at);
                set(sites_[first + l], l, run.states[l], run);
            }
            program.run(run.registers);
            for (std::size_t l = 0; l < count; ++l) visit(sites_[first + l], l, run);
        }
    }

    /// Whether the potential is integrated along the ways of the points.
    bool is_integrated() const {
        return law_->degree == 0.0 && law_->potential != LawPotential::none && law_->potential != LawPotential::energy;
    }
    /// Potential of a point that its outputs give [J].
    double energy_at(const Site& site, std::size_t lane, const Run& run, const ForceState& at) const {
        if (law_->potential == LawPotential::energy) return site.point->weight * run.output(3, lane);
        if (law_->degree == 0.0) return 0.0;
        return -site.point->weight * run.vector(0, lane).dot(way_of(site, run.states[lane], at)) / (law_->degree + 1.0);
    }

    /// Way of a point since rest, or since it had no velocity.
    Vector3d way_of(const Site& site, const FieldPoint& state, const ForceState& at) const {
        if (law_->potential != LawPotential::of_velocity) return state.x - site.point->rest_m;
        // Without a time step there is no way.
        return at.v && at.velocity_factor_1_s > 0.0 ? Vector3d(state.v / at.velocity_factor_1_s) : Vector3d::Zero();
    }
    /// State after a share of the way.
    FieldPoint on_way(const Site& site, const FieldPoint& end, double share, const ForceState& at) const {
        FieldPoint state = end;
        state.x = site.point->rest_m + share * (end.x - site.point->rest_m);
        if (law_->potential == LawPotential::of_velocity) state.v = share * end.v;
        if (law_->potential == LawPotential::of_both && at.v)
            state.v -= (1.0 - share) * at.velocity_factor_1_s * (end.x - site.point->rest_m);
        return state;
    }

    /// Work of the force along the straight way of every point [J].
    double work_from_rest(const ForceState& at) const {
        double work = 0.0;
        Run run = run_of(law_->force, at);
        for (std::size_t first = 0; first < sites_.size(); first += law::lane_count) {
            const std::size_t count = lanes_from(first);
            std::array<FieldPoint, law::lane_count> ends;
            for (std::size_t l = 0; l < count; ++l) ends[l] = state_of(sites_[first + l], at);
            for (std::size_t k = 0; k < way_points.size(); ++k) {
                for (std::size_t l = 0; l < count; ++l)
                    set(sites_[first + l], l, on_way(sites_[first + l], ends[l], way_points[k], at), run);
                law_->force.run(run.registers);
                for (std::size_t l = 0; l < count; ++l)
                    work += way_weights[k] * sites_[first + l].point->weight *
                            run.vector(0, l).dot(way_of(sites_[first + l], ends[l], at));
            }
        }
        return work;
    }

    std::shared_ptr<const LawPrograms> law_;
    std::shared_ptr<const std::vector<LawCarrier>> carriers_;
    std::vector<Site> sites_;
    LawConditions conditions_;
    VectorXd numbers_, scales_;
};

}  // namespace

ForceElementPointer law_force(std::shared_ptr<const LawPrograms> law,
                              std::shared_ptr<const std::vector<LawCarrier>> carriers, LawConditions conditions,
                              const VectorXd& numbers, const VectorXd& scales) {
    assert(numbers.size() == law->law.number_count() && scales.size() == numbers.size());
    assert(conditions.conditions.size() == law->law.conditions.size());
    return std::make_shared<LawForce>(std::move(law), std::move(carriers), std::move(conditions), numbers, scales);
}

bool is_law_force(const ForceElement& element, const LawPrograms& law, const VectorXd& numbers) {
    const auto* const force = dynamic_cast<const LawForce*>(&element);
    return force != nullptr && force->law() == &law && force->numbers() == numbers;
}

}  // namespace myo::model
