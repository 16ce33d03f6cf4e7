#include "model/tendon.hpp"

#include <algorithm>
#include <cassert>
#include <string>

#include "base/text.hpp"
#include "model/command.hpp"
#include "model/one_sided.hpp"
#include "model/taking_in.hpp"
#include "model/tendon_path.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Nodes that carry a guide and their weights; a fixed guide has none.
struct Carrier {
    std::vector<int> nodes;
    VectorXd weights;
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradient;
    Vector3d fixed_m = Vector3d::Zero();

    Vector3d at(const Matrix3Xd& x) const { return nodes.empty() ? fixed_m : moved(x); }
    /// Sum of a nodal field over the carrying nodes; 0 for a fixed guide.
    Vector3d moved(const Matrix3Xd& dx) const {
        return nodes.empty() ? Vector3d(Vector3d::Zero()) : Vector3d(dx(Eigen::all, nodes) * weights);
    }
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

VectorXd no_shifts(const std::vector<TendonGuide>& guides) {
    const auto carried = std::count_if(guides.begin(), guides.end(),
                                       [](const TendonGuide& guide) { return guide.on_body.has_value(); });
    return VectorXd::Zero(3 * carried);
}

/// Law of a thread apart from its guides and its command.
struct Thread {
    std::optional<double> stiffness_N_m;  // empty: prescribed tension
    double slack_m = 0.0;
};

/// Change of a tendon: motion of the guides, their shift through the body at rest, and changes of its numbers.
struct TendonChange {
    std::vector<Vector3d> dp, d_rest;
    double command = 0.0, stiffness = 0.0, friction = 0.0;
};

class Tendon : public ForceElement {
public:
    Tendon(TendonRoute route, fibre::Signal command, const Thread& thread, VectorXd shifts)
        : route_(std::move(route)),
          command_(std::move(command)),
          sense_(command_),
          thread_(thread),
          shifts_(std::move(shifts)) {
        Index row = 0;
        for (const TendonGuide& guide : route_.guides) {
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
        rest_path_ = tendon_path(rest_);
    }

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const Tensions now = tensions(at);
        if (thread_.stiffness_N_m)
            out.energy += *thread_.stiffness_N_m * taut(now.path, at).value;
        else
            out.energy += now.legs.dot(now.path.length - rest_path_.length);
        if (now.motor == 0.0) return;
        add_at_nodes(pulls_on_guides(now.path, now.legs), out.gradient);
        if (kind == HessianKind::none) return;
        // Positive semidefinite, because tensions are positive.
        for (std::size_t g = 0; g < groups_.size(); ++g) add_hessian(body, now, at, g, out.hessian);
    }

    bool has_potential() const override { return route_.friction == 0.0; }
    void add_unsymmetric_tangent(const Body&, const ForceState& at, const Matrix3Xd& dx,
                                 Matrix3Xd& gradient) const override {
        if (has_potential()) return;
        const Tensions now = tensions(at);
        TendonChange change{{}, std::vector<Vector3d>(route_.guides.size(), Vector3d::Zero())};
        for (const Carrier& carrier : carriers_) change.dp.push_back(carrier.moved(dx));
        VectorXd beyond = tension_changes(now, at, change);
        // The Hessian already has the part that is equal in all legs.
        beyond.array() -= along(now, at) * lengthening(now.path, change.dp).sum();
        add_at_nodes(pulls_on_guides(now.path, beyond), gradient);
    }
    void add_unsymmetric_pull(const Body&, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_x) const override {
        if (has_potential()) return;
        const Tensions now = tensions(at);
        std::vector<Vector3d> at_guides;
        for (const Carrier& carrier : carriers_) at_guides.push_back(carrier.moved(p));
        const VectorXd by_tension = lengthening(now.path, at_guides);
        const double total = by_tension.dot(now.factors);
        VectorXd by_factor = now.motor * by_tension;
        if (thread_.stiffness_N_m)
            by_factor -= total * now.motor / now.mean_factor * rest_path_.length / rest_path_.total;
        std::vector<Vector3d> by_position = pulls_on_guides(
            now.path, VectorXd::Constant(by_tension.size(), along(now, at) * (total - by_tension.sum())));
        pull_by_capstan(now.path, now.friction, now.factors, by_factor, by_position);
        add_at_nodes(by_position, by_x);
    }

    const fibre::Signal* command() const override { return &command_; }
    ForceElementPointer with_command(const fibre::Signal& command) const override {
        return std::make_shared<Tendon>(route_, command, thread_, shifts_);
    }

    std::string command_words(double time_s, bool before) const override {
        const double value = before ? command_.value_before(time_s) : command_.value(time_s);
        return format_number(value, 4) + (thread_.stiffness_N_m ? " m" : " N") + " of " + route_.words;
    }

    std::vector<ForceParameter> parameters() const override {
        const std::optional<double>& stiffness = thread_.stiffness_N_m;
        std::vector<ForceParameter> list = stiffness ? command_parameters(command_, "shortening_m", 1e-3)
                                                     : command_parameters(command_, "tension_N", 1.0);
        if (stiffness) list.push_back({"stiffness_N_m", *stiffness, *stiffness});
        list.push_back({"friction", route_.friction, 0.1});
        Index row = 0;
        for (std::size_t i = 0; i < route_.guides.size(); ++i)
            for (int axis = 0; route_.guides[i].on_body && axis < 3; ++axis)
                list.push_back({"guide " + std::to_string(i + 1) + ", " + "xyz"[axis] + "_m", shifts_(row++), 1e-3});
        return list;
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        Thread thread = thread_;
        if (thread.stiffness_N_m) thread.stiffness_N_m = values(knots());
        TendonRoute route = route_;
        route.friction = values(friction_index());
        return std::make_shared<Tendon>(std::move(route), with_values(command_, values), thread,
                                        values.tail(shifts_.size()));
    }

    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        const Tensions now = tensions(at);
        const VectorXd shift = change.tail(shifts_.size());
        const std::vector<Vector3d> still(route_.guides.size(), Vector3d::Zero());
        TendonChange d{still, still, command_change(command_, at, change), 0.0, change(friction_index())};
        if (thread_.stiffness_N_m) d.stiffness = change(knots());
        for_each_carried([&](std::size_t i, Index row) {
            d.d_rest[i] = shift.segment<3>(row);
            d.dp[i] = at.x(Eigen::all, carriers_[i].nodes) * (carriers_[i].gradient * d.d_rest[i]);
        });
        std::vector<Vector3d> changes = pulls_on_guides(now.path, tension_changes(now, at, d));
        for (std::size_t leg = 0; leg < now.path.legs(); ++leg) {
            const Vector3d turned = now.legs(static_cast<Index>(leg)) *
                                    (turning(now.path, leg) * (d.dp[leg + 1] - d.dp[leg]));
            changes[leg] -= turned;
            changes[leg + 1] += turned;
        }
        add_at_nodes(changes, gradient);
        // A shifted guide hangs on its nodes with other weights.
        const std::vector<Vector3d> pulls = pulls_on_guides(now.path, now.legs);
        for_each_carried([&](std::size_t i, Index) {
            const VectorXd d_weights = carriers_[i].gradient * d.d_rest[i];
            for (std::size_t a = 0; a < carriers_[i].nodes.size(); ++a)
                gradient.col(carriers_[i].nodes[a]) += d_weights(static_cast<Index>(a)) * pulls[i];
        });
    }

    const TendonRoute& route() const { return route_; }
    bool by_shortening() const { return thread_.stiffness_N_m.has_value(); }
    ForceElementPointer with_route(TendonRoute route) const {
        VectorXd still = no_shifts(route.guides);
        return std::make_shared<Tendon>(std::move(route), command_, thread_, std::move(still));
    }
    ForceElementPointer with_added_friction(double added) const {
        TendonRoute route = route_;
        route.friction += added;
        return std::make_shared<Tendon>(std::move(route), command_, thread_, shifts_);
    }

    bool steady(double from_s, double to_s) const override {
        return has_potential() && constant_between(command_, from_s, to_s);
    }
    std::vector<double> jumps() const override {
        std::vector<double> times = command_.jumps();
        if (has_potential()) return times;
        const std::vector<double> turns = sense_.turns();
        times.insert(times.end(), turns.begin(), turns.end());
        return times;
    }

    TendonState state(const ForceState& at) const {
        const Tensions now = tensions(at);
        return {now.motor, rest_path_.total - now.path.total};
    }

private:
    /// The path and its tensions at one configuration.
    struct Tensions {
        TendonPath path;
        double friction = 0.0;  // with the sign of the sense
        VectorXd factors;       // tension of each leg over that at the motor
        double mean_factor = 1.0;
        double motor = 0.0;  // [N]
        VectorXd legs;       // [N]
    };

    Index knots() const { return static_cast<Index>(command_.times_s.size()); }
    Index friction_index() const { return knots() + (thread_.stiffness_N_m ? 1 : 0); }

    template <class Visit>
    void for_each_carried(const Visit& visit) const {
        Index row = 0;
        for (std::size_t i = 0; i < route_.guides.size(); ++i)
            if (route_.guides[i].on_body) {
                visit(i, row);
                row += 3;
            }
    }

    void make_groups() {
        const std::vector<std::vector<int>> couplings = tendon_couplings(route_.guides,
                                                                         thread_.stiffness_N_m.has_value());
        for (std::size_t g = 0; g < couplings.size(); ++g) {
            Group group{couplings[g], {}, {}};
            if (thread_.stiffness_N_m)
                for (std::size_t leg = 0; leg + 1 < route_.guides.size(); ++leg) group.legs.push_back(leg);
            else
                group.legs = {g};
            group.spread = MatrixXd::Zero(static_cast<Index>(group.nodes.size()),
                                          static_cast<Index>(route_.guides.size()));
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

    /// Smoothed positive part of the stretch, zero up to -slack_m.
    OneSided taut(const TendonPath& path, const ForceState& at) const {
        const double stretch = path.total - rest_path_.total + command_value(command_, at);
        return one_sided(stretch + thread_.slack_m, 2.0 * thread_.slack_m);
    }

    Tensions tensions(const ForceState& at) const {
        Tensions now;
        std::vector<Vector3d> points;
        for (const Carrier& carrier : carriers_) points.push_back(carrier.at(at.x));
        now.path = tendon_path(points);
        now.friction = route_.friction * sense_.at(at.time_s, at.before_jump);
        now.factors = capstan_factors(now.path, now.friction);
        now.mean_factor = now.factors.dot(rest_path_.length) / rest_path_.total;
        now.motor = thread_.stiffness_N_m ? *thread_.stiffness_N_m * taut(now.path, at).slope / now.mean_factor
                                          : std::max(0.0, command_value(command_, at));
        now.legs = now.motor * now.factors;
        return now;
    }

    /// Derivative of the motor's tension by the length of the path [N/m].
    double along(const Tensions& now, const ForceState& at) const {
        return thread_.stiffness_N_m ? *thread_.stiffness_N_m * taut(now.path, at).second / now.mean_factor : 0.0;
    }

    /// Derivatives of the legs' tensions.
    VectorXd tension_changes(const Tensions& now, const ForceState& at, const TendonChange& d) const {
        const double sense = sense_.at(at.time_s, at.before_jump);
        const VectorXd d_factors = capstan_changes(now.path, now.friction, now.factors, d.dp, sense * d.friction);
        double d_motor = d.command;
        if (thread_.stiffness_N_m) {
            const VectorXd d_rest = lengthening(rest_path_, d.d_rest);
            const double d_total = d_rest.sum();
            const double d_mean = (d_factors.dot(rest_path_.length) + now.factors.dot(d_rest) -
                                   now.mean_factor * d_total) /
                                  rest_path_.total;
            d_motor = along(now, at) * (d.command + lengthening(now.path, d.dp).sum() - d_total) +
                      (d.stiffness * taut(now.path, at).slope - now.motor * d_mean) / now.mean_factor;
        }
        return d_motor * now.factors + now.motor * d_factors;
    }

    void add_at_nodes(const std::vector<Vector3d>& at_guides, Matrix3Xd& gradient) const {
        for (std::size_t i = 0; i < carriers_.size(); ++i)
            for (std::size_t a = 0; a < carriers_[i].nodes.size(); ++a)
                gradient.col(carriers_[i].nodes[a]) += carriers_[i].weights(static_cast<Index>(a)) * at_guides[i];
    }

    void add_hessian(const Body& body, const Tensions& now, const ForceState& at, std::size_t g,
                     solver::SymmetricSparse& hessian) const {
        const Group& group = groups_[g];
        const std::size_t coupling = route_.first_coupling + g, count = group.nodes.size();
        assert(coupling < body.couplings.size() && body.couplings[coupling] == group.nodes);
        MatrixXd legs(static_cast<Index>(count), static_cast<Index>(group.legs.size()));  // weight in the leg's vector
        Matrix3Xd by_node = Matrix3Xd::Zero(3, static_cast<Index>(count));                // derivative of the length
        std::vector<Matrix3d> stiffness;
        for (std::size_t k = 0; k < group.legs.size(); ++k) {
            const auto leg = static_cast<Index>(group.legs[k]);
            legs.col(static_cast<Index>(k)) = group.spread.col(leg + 1) - group.spread.col(leg);
            by_node += now.path.direction[group.legs[k]] * legs.col(static_cast<Index>(k)).transpose();
            stiffness.push_back(now.legs(leg) * turning(now.path, group.legs[k]));
        }
        const double k_along = along(now, at);
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t a = 0; a < count; ++a) {
                const auto i = static_cast<Index>(a), j = static_cast<Index>(b);
                Matrix3d block = k_along * by_node.col(i) * by_node.col(j).transpose();
                for (std::size_t k = 0; k < group.legs.size(); ++k)
                    block += legs(i, static_cast<Index>(k)) * legs(j, static_cast<Index>(k)) * stiffness[k];
                body.pattern.add_coupled(hessian, group.nodes, coupling, a, b, block);
            }
    }

    TendonRoute route_;
    fibre::Signal command_;
    TakingIn sense_;
    Thread thread_;
    VectorXd shifts_;                // of the guides on the body, three each [m]
    std::vector<Carrier> carriers_;  // per guide
    std::vector<Vector3d> rest_;     // guides at rest [m]
    TendonPath rest_path_;
    std::vector<Group> groups_;
};

const Tendon& as_tendon(const ForceElement& element) {
    const auto* const tendon = dynamic_cast<const Tendon*>(&element);
    assert(tendon);
    return *tendon;
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

ForceElementPointer tendon_of_tension(const TendonRoute& route, const fibre::Signal& tension_N) {
    return std::make_shared<Tendon>(route, tension_N, Thread{}, no_shifts(route.guides));
}

ForceElementPointer tendon_of_shortening(const TendonRoute& route, const fibre::Signal& shortening_m,
                                         double stiffness_N_m, double slack_m) {
    assert(stiffness_N_m > 0.0 && slack_m > 0.0);
    return std::make_shared<Tendon>(route, shortening_m, Thread{stiffness_N_m, slack_m}, no_shifts(route.guides));
}

TendonState tendon_state(const ForceElement& tendon, const ForceState& at) { return as_tendon(tendon).state(at); }

const TendonRoute* tendon_route(const ForceElement& element) {
    const auto* const tendon = dynamic_cast<const Tendon*>(&element);
    return tendon ? &tendon->route() : nullptr;
}

ForceElementPointer with_route(const ForceElement& tendon, TendonRoute route) {
    return as_tendon(tendon).with_route(std::move(route));
}

bool is_driven_by_shortening(const ForceElement& tendon) { return as_tendon(tendon).by_shortening(); }

ForceElementPointer with_added_friction(const ForceElement& element, double added) {
    const auto* const tendon = dynamic_cast<const Tendon*>(&element);
    return tendon ? tendon->with_added_friction(added) : nullptr;
}

}  // namespace myo::model
