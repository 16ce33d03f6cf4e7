#include "model/tendon.hpp"

#include <algorithm>
#include <cassert>
#include <string>

#include "model/command.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Positive part of a stretch with a parabola between -d and d.
struct Tautness {
    double potential, value, derivative;
};
Tautness tautness(double stretch, double d) {
    if (stretch <= -d) return {0.0, 0.0, 0.0};
    if (stretch >= d) return {0.5 * stretch * stretch + d * d / 6.0, stretch, 1.0};
    const double s = stretch + d;
    return {s * s * s / (12.0 * d), s * s / (4.0 * d), s / (2.0 * d)};
}

/// Nodes that carry a guide and their weights; a fixed guide has none.
struct Carrier {
    std::vector<int> nodes;
    VectorXd weights;
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradient;
    Vector3d fixed_m = Vector3d::Zero();

    Vector3d at(const Matrix3Xd& x) const { return nodes.empty() ? fixed_m : Vector3d(x(Eigen::all, nodes) * weights); }
};

struct Group {
    std::vector<int> nodes;         // of Body::couplings
    std::vector<std::size_t> legs;  // legs of the path whose stiffness the group stores
    MatrixXd spread;                // nodes x guides: weight of each node in each guide
};

void merge(const TendonGuide& guide, std::vector<int>& nodes) {
    if (!guide.on_body) return;
    for (const int node : guide.on_body->nodes)
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
}

/// The path at one configuration: legs between neighbouring guides.
struct Path {
    std::vector<Vector3d> direction;  // unit, from the motor to the anchor
    std::vector<double> length;
    double total = 0.0;
};

class Tendon : public ForceElement {
public:
    Tendon(std::vector<TendonGuide> guides, std::size_t first_coupling, fibre::Signal command,
           std::optional<double> stiffness_N_m, double slack_m, VectorXd shifts)
        : guides_(std::move(guides)),
          first_coupling_(first_coupling),
          command_(std::move(command)),
          stiffness_(stiffness_N_m),
          slack_m_(slack_m),
          shifts_(std::move(shifts)) {
        Index row = 0;
        for (const TendonGuide& guide : guides_) {
            Carrier carrier;
            carrier.fixed_m = guide.rest_m;
            rest_.push_back(guide.rest_m);
            if (guide.on_body) {
                const Vector3d shift = shifts_.segment<3>(row);
                carrier.nodes = guide.on_body->nodes;
                carrier.gradient = guide.on_body->gradient;
                carrier.weights = guide.on_body->weights + carrier.gradient * shift;
                rest_.back() += shift;
                row += 3;
            }
            carriers_.push_back(std::move(carrier));
        }
        make_groups();
        rest_length_ = path_of(rest_).total;
    }

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const Path path = path_at(at.x);
        const double T = tension(path, at);
        if (stiffness_)
            out.energy += *stiffness_ * taut(path, at).potential;
        else
            out.energy += T * (path.total - rest_length_);
        if (T == 0.0) return;
        add_pulls(path, T, out.gradient);
        if (kind == HessianKind::none) return;
        // Positive semidefinite, because the tension is positive.
        for (std::size_t g = 0; g < groups_.size(); ++g) add_hessian(body, path, T, at, g, out.hessian);
    }

    const fibre::Signal* command() const override { return &command_; }
    ForceElementPointer with_command(fibre::Signal command) const override {
        return std::make_shared<Tendon>(guides_, first_coupling_, std::move(command), stiffness_, slack_m_, shifts_);
    }

    std::vector<ForceParameter> parameters() const override {
        std::vector<ForceParameter> list = stiffness_ ? command_parameters(command_, "shortening_m", 1e-3)
                                                      : command_parameters(command_, "tension_N", 1.0);
        if (stiffness_) list.push_back({"stiffness_N_m", *stiffness_, *stiffness_});
        Index row = 0;
        for (std::size_t i = 0; i < guides_.size(); ++i)
            for (int axis = 0; guides_[i].on_body && axis < 3; ++axis)
                list.push_back({"guide " + std::to_string(i + 1) + ", " + "xyz"[axis] + "_m", shifts_(row++), 1e-3});
        return list;
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        const std::optional<double> stiffness = stiffness_ ? std::optional(values(knots())) : std::nullopt;
        return std::make_shared<Tendon>(guides_, first_coupling_, with_values(command_, values), stiffness, slack_m_,
                                        values.tail(shifts_.size()));
    }

    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        const Path path = path_at(at.x);
        const double T = tension(path, at);
        const VectorXd shift = change.tail(shifts_.size());
        // Motion of the guides through the body, and change of the rest length.
        std::vector<Vector3d> dp(guides_.size(), Vector3d::Zero()), d_rest = dp;
        for_each_carried([&](std::size_t i, Index row) {
            d_rest[i] = shift.segment<3>(row);
            dp[i] = at.x(Eigen::all, carriers_[i].nodes) * (carriers_[i].gradient * d_rest[i]);
        });
        double dT = command_change(command_, at, change);
        if (stiffness_) {
            const Tautness r = taut(path, at);
            dT = *stiffness_ * r.derivative * (dT + lengthening(path, dp) - lengthening(path_of(rest_), d_rest)) +
                 change(knots()) * r.value;
        }
        add_pulls(path, dT, gradient);
        if (T == 0.0) return;
        const std::vector<Vector3d> pulls = pulls_on_guides(path, T);
        std::vector<Vector3d> d_pulls(guides_.size(), Vector3d::Zero());
        for (std::size_t leg = 0; leg < path.length.size(); ++leg) {
            const Vector3d turned = T * (across(path, leg) * (dp[leg + 1] - dp[leg]));
            d_pulls[leg] -= turned;
            d_pulls[leg + 1] += turned;
        }
        for_each_carried([&](std::size_t i, Index) {
            const VectorXd d_weights = carriers_[i].gradient * d_rest[i];
            for (std::size_t a = 0; a < carriers_[i].nodes.size(); ++a)
                gradient.col(carriers_[i].nodes[a]) += carriers_[i].weights(static_cast<Index>(a)) * d_pulls[i] +
                                                       d_weights(static_cast<Index>(a)) * pulls[i];
        });
    }

    bool steady(double from_s, double to_s) const override { return constant_between(command_, from_s, to_s); }
    std::vector<double> jumps() const override { return command_.jumps(); }

    TendonState state(const ForceState& at) const {
        const Path path = path_at(at.x);
        return {tension(path, at), rest_length_ - path.total};
    }

private:
    Index knots() const { return static_cast<Index>(command_.times_s.size()); }

    template <class Visit>
    void for_each_carried(const Visit& visit) const {
        Index row = 0;
        for (std::size_t i = 0; i < guides_.size(); ++i)
            if (guides_[i].on_body) {
                visit(i, row);
                row += 3;
            }
    }

    void make_groups() {
        const std::vector<std::vector<int>> couplings = tendon_couplings(guides_, stiffness_.has_value());
        for (std::size_t g = 0; g < couplings.size(); ++g) {
            Group group{couplings[g], {}, {}};
            if (stiffness_)
                for (std::size_t leg = 0; leg + 1 < guides_.size(); ++leg) group.legs.push_back(leg);
            else
                group.legs = {g};
            group.spread = MatrixXd::Zero(static_cast<Index>(group.nodes.size()), static_cast<Index>(guides_.size()));
            for (std::size_t i = 0; i < carriers_.size(); ++i)
                for (std::size_t a = 0; a < carriers_[i].nodes.size(); ++a) {
                    const auto at = std::find(group.nodes.begin(), group.nodes.end(), carriers_[i].nodes[a]);
                    if (at != group.nodes.end())
                        group.spread(at - group.nodes.begin(),
                                     static_cast<Index>(i)) += carriers_[i].weights(static_cast<Index>(a));
                }
            groups_.push_back(std::move(group));
        }
    }

    static Path path_of(const std::vector<Vector3d>& points) {
        Path path;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vector3d leg = points[i + 1] - points[i];
            path.length.push_back(leg.norm());
            path.direction.push_back(leg / path.length.back());
            path.total += path.length.back();
        }
        return path;
    }
    Path path_at(const Matrix3Xd& x) const {
        std::vector<Vector3d> points;
        for (const Carrier& carrier : carriers_) points.push_back(carrier.at(x));
        return path_of(points);
    }

    Tautness taut(const Path& path, const ForceState& at) const {
        return tautness(path.total - rest_length_ + command_value(command_, at), slack_m_);
    }
    double tension(const Path& path, const ForceState& at) const {
        return stiffness_ ? *stiffness_ * taut(path, at).value : std::max(0.0, command_value(command_, at));
    }

    /// Derivative of the length along motions of the guides.
    static double lengthening(const Path& path, const std::vector<Vector3d>& dp) {
        double sum = 0.0;
        for (std::size_t leg = 0; leg < path.length.size(); ++leg)
            sum += path.direction[leg].dot(dp[leg + 1] - dp[leg]);
        return sum;
    }
    /// Derivative of the direction of a leg by the vector between its ends.
    static Matrix3d across(const Path& path, std::size_t leg) {
        const Vector3d& t = path.direction[leg];
        return (Matrix3d::Identity() - t * t.transpose()) / path.length[leg];
    }

    /// Derivative of the potential by the positions of the guides.
    static std::vector<Vector3d> pulls_on_guides(const Path& path, double T) {
        std::vector<Vector3d> pulls(path.length.size() + 1, Vector3d::Zero());
        for (std::size_t leg = 0; leg < path.length.size(); ++leg) {
            pulls[leg] -= T * path.direction[leg];
            pulls[leg + 1] += T * path.direction[leg];
        }
        return pulls;
    }
    void add_pulls(const Path& path, double T, Matrix3Xd& gradient) const {
        const std::vector<Vector3d> pulls = pulls_on_guides(path, T);
        for (std::size_t i = 0; i < carriers_.size(); ++i)
            for (std::size_t a = 0; a < carriers_[i].nodes.size(); ++a)
                gradient.col(carriers_[i].nodes[a]) += carriers_[i].weights(static_cast<Index>(a)) * pulls[i];
    }

    void add_hessian(const Body& body, const Path& path, double T, const ForceState& at, std::size_t g,
                     solver::SymmetricSparse& hessian) const {
        const Group& group = groups_[g];
        const std::size_t coupling = first_coupling_ + g, count = group.nodes.size();
        assert(coupling < body.couplings.size() && body.couplings[coupling] == group.nodes);
        MatrixXd legs(static_cast<Index>(count), static_cast<Index>(group.legs.size()));  // weight in the leg's vector
        std::vector<Matrix3d> stiffness;
        for (std::size_t k = 0; k < group.legs.size(); ++k) {
            const auto leg = static_cast<Index>(group.legs[k]);
            legs.col(static_cast<Index>(k)) = group.spread.col(leg + 1) - group.spread.col(leg);
            stiffness.push_back(T * across(path, group.legs[k]));
        }
        Matrix3Xd by_node;  // derivative of the length
        const double along = stiffness_ ? *stiffness_ * taut(path, at).derivative : 0.0;
        if (stiffness_) {
            by_node = Matrix3Xd::Zero(3, static_cast<Index>(count));
            for (std::size_t k = 0; k < group.legs.size(); ++k)
                by_node += path.direction[group.legs[k]] * legs.col(static_cast<Index>(k)).transpose();
        }
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t a = 0; a < count; ++a) {
                const auto i = static_cast<Index>(a), j = static_cast<Index>(b);
                Matrix3d block = Matrix3d::Zero();
                for (std::size_t k = 0; k < group.legs.size(); ++k)
                    block += legs(i, static_cast<Index>(k)) * legs(j, static_cast<Index>(k)) * stiffness[k];
                if (stiffness_) block += along * by_node.col(i) * by_node.col(j).transpose();
                body.pattern.add_coupled(hessian, group.nodes, coupling, a, b, block);
            }
    }

    std::vector<TendonGuide> guides_;
    std::size_t first_coupling_;
    fibre::Signal command_;
    std::optional<double> stiffness_;  // empty: prescribed tension
    double slack_m_;
    VectorXd shifts_;                // of the guides on the body, three each [m]
    std::vector<Carrier> carriers_;  // per guide
    std::vector<Vector3d> rest_;     // guides at rest [m]
    std::vector<Group> groups_;
    double rest_length_ = 0.0;
};

VectorXd no_shifts(const std::vector<TendonGuide>& guides) {
    const auto carried = std::count_if(guides.begin(), guides.end(),
                                       [](const TendonGuide& guide) { return guide.on_body.has_value(); });
    return VectorXd::Zero(3 * carried);
}

}  // namespace

std::vector<std::vector<int>> tendon_couplings(const std::vector<TendonGuide>& guides, bool by_shortening) {
    std::vector<std::vector<int>> groups;
    for (std::size_t leg = 0; leg + 1 < guides.size(); ++leg) {
        if (groups.empty() || !by_shortening) groups.emplace_back();
        merge(guides[leg], groups.back());
        merge(guides[leg + 1], groups.back());
    }
    return groups;
}

ForceElementPointer tendon_of_tension(const std::vector<TendonGuide>& guides, std::size_t first_coupling,
                                      fibre::Signal tension_N) {
    return std::make_shared<Tendon>(guides, first_coupling, std::move(tension_N), std::nullopt, 0.0, no_shifts(guides));
}

ForceElementPointer tendon_of_shortening(const std::vector<TendonGuide>& guides, std::size_t first_coupling,
                                         fibre::Signal shortening_m, double stiffness_N_m, double slack_m) {
    assert(stiffness_N_m > 0.0 && slack_m > 0.0);
    return std::make_shared<Tendon>(guides, first_coupling, std::move(shortening_m), stiffness_N_m, slack_m,
                                    no_shifts(guides));
}

TendonState tendon_state(const ForceElement& tendon, const ForceState& at) {
    const auto* const element = dynamic_cast<const Tendon*>(&tendon);
    assert(element);
    return element->state(at);
}

}  // namespace myo::model
