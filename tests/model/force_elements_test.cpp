#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "model/cavity_pressure.hpp"
#include "model/contact.hpp"
#include "model/elastic_bed.hpp"
#include "model/law_cases.hpp"
#include "model/loaded_face.hpp"
#include "model/mount_forces.hpp"
#include "model/point_friction.hpp"
#include "model/point_pull.hpp"
#include "model/point_stop.hpp"
#include "model/surface_drag.hpp"
#include "model/tendon_channel.hpp"
#include "support/hollow.hpp"
#include "support/tendon_body.hpp"
#include "support/turning_mount.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct ForceCase {
    const char* element;
    fem::ElementKind kind;
};

/// A cell at the free end, and its nodes.
int tip_cell(const Body& body) {
    Eigen::Index last = 0;
    body.mesh.nodes.row(0).maxCoeff(&last);
    for (int c = 0; c < static_cast<int>(body.mesh.cells.cols()); ++c)
        if ((body.mesh.cells.col(c).array() == static_cast<int>(last)).any()) return c;
    return 0;
}

std::vector<int> nodes_of_tip(const Body& body) {
    const auto cell = body.mesh.cells.col(tip_cell(body));
    return {cell.begin(), cell.end()};
}

/// A hollow block, clamped at one end, with one force element.
Model model_with(const ForceCase& c) {
    Model model = test::hollow_block(c.kind);
    const Body& body = *model.body;
    const std::string element = c.element;
    if (element == "bed") model.force_elements = {elastic_bed(body, free_faces(body), 3e5)};
    if (element.starts_with("law_"))
        model.force_elements = {test::law_element(body, element.substr(4), tip_cell(body))};
    if (element == "seen_law")
        model.force_elements = {in_laboratory(test::law_element(body, "lift", tip_cell(body)), test::tumbling_mount())};
    if (element == "drag") model.force_elements = {surface_drag(body, free_faces(body), 20.0, 900.0)};
    if (element == "friction") {
        const std::vector<int> nodes = nodes_of_tip(body);
        const VectorXd shares = VectorXd::Constant(static_cast<Eigen::Index>(nodes.size()),
                                                   1.0 / static_cast<double>(nodes.size()));
        model.force_elements = {
            point_friction(body, tip_cell(body), nodes, shares, Vector3d(1.0, 2.0, -0.5), 0.3, 0.05)};
    }
    if (element == "pull") {
        const std::vector<int> nodes = nodes_of_tip(body);
        const VectorXd shares = VectorXd::Constant(static_cast<Eigen::Index>(nodes.size()),
                                                   1.0 / static_cast<double>(nodes.size()));
        const Matrix3Xd places = Vector3d(0.1, 0.05, -0.02).replicate(1, shares.size());
        model.force_elements = {point_pull(body, nodes, shares, places, 30.0)};
    }
    if (element == "stop") {
        const std::vector<int> nodes = nodes_of_tip(body);
        const VectorXd shares = VectorXd::Constant(static_cast<Eigen::Index>(nodes.size()),
                                                   1.0 / static_cast<double>(nodes.size()));
        model.force_elements = {
            point_stop(body, tip_cell(body), nodes, shares, Vector3d(1.0, 2.0, -0.5), 1e-4, 300.0, 0.01)};
    }
    const auto touching = [&](const DistanceField& obstacle, double friction) {
        model.force_elements = {contact(body, free_faces(body), obstacle, {2e7, 0.02, friction, 0.3, 2e-4})};
    };
    if (element == "smooth_sphere") touching(sphere_distance({0.08, 0.02, 0.01}, 0.04), 0.0);
    if (element == "rough_plane") touching(plane_distance({0.0, 0.0, 0.004}, {0.2, -0.1, 1.0}), 0.4);
    if (element == "rough_sphere") touching(sphere_distance({0.08, 0.02, 0.01}, 0.04), 0.4);
    if (element == "rough_box") touching(box_distance({0.05, 0.02, 0.02}, {0.1, 0.1, 0.1}, 0.02), 0.4);
    if (element == "mount") {
        model.gravity_m_s2 = {0.0, 1.0, -9.81};
        model.forces.push_back({VectorXd::Constant(body.node_count(), 1.0 / body.node_count()), {0.1, 0.2, 0.3}});
        model.force_elements = {mount_forces(model, test::tumbling_mount())};
    }
    if (element == "seen_bed")
        model.force_elements = {in_laboratory(elastic_bed(body, free_faces(body), 3e5), test::tumbling_mount())};
    if (element == "seen_drag")
        model.force_elements = {
            in_laboratory(surface_drag(body, free_faces(body), 20.0, 900.0), test::tumbling_mount())};
    if (element == "seen_rough_plane") {
        touching(plane_distance(test::tumbling_mount()->at(0.3).in_laboratory(Vector3d(0.0, 0.0, 0.004)).col(0),
                                test::tumbling_mount()->at(0.3).rotation * Vector3d(0.2, -0.1, 1.0)),
                 0.4);
        model.force_elements = {in_laboratory(model.force_elements.front(), test::tumbling_mount())};
    }
    const std::vector<Vector3d> path{
        {-0.01, 0.004, 0.002}, {0.02, 0.004, 0.003}, {0.043, 0.005, 0.026}, {0.058, 0.027, 0.02}};
    if (element == "tension") test::pull_by_tension(path, fibre::Signal{{0.0, 1.0}, {2.0, 3.0}}, model);
    if (element == "capstan") test::pull_by_tension(path, fibre::Signal{{0.0, 1.0}, {3.0, 2.0}}, model, 0.3);
    if (element == "capstan_shortening")
        test::pull_by_shortening(path, fibre::Signal{{0.0, 1.0}, {2e-3, 3e-3}}, 900.0, model, 0.3);
    if (element == "shortening") test::pull_by_shortening(path, fibre::Signal{{0.0, 1.0}, {2e-3, 3e-3}}, 900.0, model);
    // Between its straight path and the material. Without friction: nearly straight legs lie at its smoothed corner,
    // and need steps of differences a tenth as long (then it passes, too).
    if (element == "channel" || element == "channel_shortening") {
        const bool by_shortening = element == "channel_shortening";
        if (by_shortening)
            test::pull_by_shortening(path, fibre::Signal{{0.0, 1.0}, {2e-3, 3e-3}}, 900.0, model);
        else
            test::pull_by_tension(path, fibre::Signal{{0.0, 1.0}, {3.0, 2.0}}, model);
        const ForceElement& straight = *model.force_elements.front();
        TendonRoute route = in_channel(*tendon_route(straight), model.body->mesh, 0.4);
        EXPECT_GT(route.guides.size(), path.size());
        model.body = coupled_body(*model.body, route, by_shortening);
        model.force_elements = {with_route(straight, std::move(route))};
    }
    if (element == "pressure")
        model.force_elements = {
            cavity_pressure(body, closed_cavities(body).at(0), fibre::Signal{{0.0, 1.0}, {4e3, 6e3}})};
    return model;
}

class ForceElements : public testing::TestWithParam<ForceCase> {
protected:
    ForceElements() : model(model_with(GetParam())), X(model.body->mesh.nodes) {
        x = X + 2e-4 * test::rough_field(X.cols(), 0.3);
        v_history = test::rough_field(X.cols(), 1.1) - factor * x;
    }

    InternalEnergy at(const Matrix3Xd& positions, HessianKind kind) const {
        InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, X.cols());
        if (kind != HessianKind::none) out.hessian = model.body->pattern.zero;
        const Matrix3Xd v = factor * positions + v_history;
        add_force_elements(model, {positions, &v, factor, time_s}, kind, out);
        return out;
    }

    static constexpr double factor = 200.0, time_s = 0.3;
    Model model;
    Matrix3Xd X, x, v_history;
};

TEST_P(ForceElements, HaveTheGradientOfTheirPotentialAndItsHessian) {
    const Matrix3Xd d = scatter(model.body->pattern, gather(model.body->pattern, test::rough_field(X.cols(), 2.0)));
    const double step = 1e-6;
    const InternalEnergy here = at(x, HessianKind::exact), up = at(x + step * d, HessianKind::none),
                         down = at(x - step * d, HessianKind::none);
    const double slope = here.gradient.cwiseProduct(d).sum();
    EXPECT_NE(slope, 0.0);
    if (has_potential(model)) {
        EXPECT_NEAR((up.energy - down.energy) / (2.0 * step) / slope, 1.0, 1e-6);
    }
    const Matrix3Xd v = factor * x + v_history;
    const ForceState state{x, &v, factor, time_s};
    const Matrix3Xd rest = unsymmetric_product(model, state, d, StiffnessForm::complete);
    const VectorXd product = here.hessian.selfadjointView<Eigen::Lower>() * gather(model.body->pattern, d) +
                             gather(model.body->pattern, rest);
    const VectorXd difference = gather(model.body->pattern, (up.gradient - down.gradient) / (2.0 * step));
    EXPECT_GT(difference.norm(), 0.0);
    EXPECT_LT((product - difference).norm(), 1e-6 * difference.norm());
    const Matrix3Xd p = test::rough_field(X.cols(), 3.0);
    EXPECT_EQ(rest.isZero(0.0), has_potential(model));
    EXPECT_NEAR(unsymmetric_product(model, state, p, StiffnessForm::transposed).cwiseProduct(d).sum(),
                rest.cwiseProduct(p).sum(), 1e-12 * rest.norm() * p.norm());
}

TEST_P(ForceElements, KnowTheirDerivativesByParametersAndVelocity) {
    const ForceElement& element = *model.force_elements.front();
    const Body& body = *model.body;
    const Matrix3Xd v = factor * x + v_history, p = test::rough_field(X.cols(), 5.0);
    const ForceState state{x, &v, factor, time_s};
    const VectorXd values = parameter_values(element);
    const auto gradient_of = [&](const ForceElement& some, const ForceState& there) {
        InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, X.cols());
        some.add(body, there, HessianKind::none, out);
        return out.gradient;
    };
    VectorXd work = VectorXd::Zero(values.size());
    element.add_work(body, state, p, work);
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const VectorXd change = 1e-4 * element.parameters()[static_cast<std::size_t>(k)].scale *
                                VectorXd::Unit(values.size(), k);
        Matrix3Xd tangent = Matrix3Xd::Zero(3, X.cols());
        element.add_tangent(body, state, change, tangent);
        const Matrix3Xd difference = 0.5 * (gradient_of(*element.changed(values + change), state) -
                                            gradient_of(*element.changed(values - change), state));
        EXPECT_GT(difference.norm(), 0.0);
        EXPECT_LT((tangent - difference).norm(), 1e-8 * difference.norm());
        EXPECT_NEAR(work(k) * change(k), tangent.cwiseProduct(p).sum(),
                    1e-10 * std::abs(tangent.cwiseProduct(p).sum()));
    }
    if (!element.depends_on_velocity()) return;
    const Matrix3Xd dv = test::rough_field(X.cols(), 7.0), up = v + 1e-5 * dv, down = v - 1e-5 * dv;
    const Matrix3Xd difference = (gradient_of(element, {x, &up, factor, time_s}) -
                                  gradient_of(element, {x, &down, factor, time_s})) /
                                 2e-5;
    EXPECT_LE((velocity_tangent(model, state, dv) - difference).norm(), 1e-7 * difference.norm());
    EXPECT_NEAR(velocity_pull(model, state, p).cwiseProduct(dv).sum(), difference.cwiseProduct(p).sum(),
                1e-7 * difference.norm() * p.norm());
}

INSTANTIATE_TEST_SUITE_P(
    All, ForceElements,
    testing::Values(
        ForceCase{"bed", fem::ElementKind::hex8}, ForceCase{"bed", fem::ElementKind::tet10},
        ForceCase{"drag", fem::ElementKind::hex8}, ForceCase{"drag", fem::ElementKind::tet10},
        ForceCase{"friction", fem::ElementKind::hex8}, ForceCase{"friction", fem::ElementKind::tet10},
        ForceCase{"pressure", fem::ElementKind::hex8}, ForceCase{"pressure", fem::ElementKind::tet4},
        ForceCase{"pressure", fem::ElementKind::tet10}, ForceCase{"tension", fem::ElementKind::hex8},
        ForceCase{"tension", fem::ElementKind::tet10}, ForceCase{"shortening", fem::ElementKind::hex8},
        ForceCase{"shortening", fem::ElementKind::tet10}, ForceCase{"capstan", fem::ElementKind::hex8},
        ForceCase{"capstan_shortening", fem::ElementKind::tet10}, ForceCase{"stop", fem::ElementKind::hex8},
        ForceCase{"channel", fem::ElementKind::hex8}, ForceCase{"channel", fem::ElementKind::tet10},
        ForceCase{"channel_shortening", fem::ElementKind::hex8}, ForceCase{"pull", fem::ElementKind::hex8},
        ForceCase{"pull", fem::ElementKind::tet10}, ForceCase{"stop", fem::ElementKind::tet10},
        ForceCase{"smooth_sphere", fem::ElementKind::hex8}, ForceCase{"smooth_sphere", fem::ElementKind::tet10},
        ForceCase{"rough_plane", fem::ElementKind::tet10}, ForceCase{"rough_sphere", fem::ElementKind::hex8},
        ForceCase{"rough_sphere", fem::ElementKind::tet10}, ForceCase{"rough_box", fem::ElementKind::hex8},
        ForceCase{"mount", fem::ElementKind::hex8}, ForceCase{"mount", fem::ElementKind::tet10},
        ForceCase{"seen_bed", fem::ElementKind::hex8}, ForceCase{"seen_drag", fem::ElementKind::hex8},
        ForceCase{"seen_rough_plane", fem::ElementKind::hex8}, ForceCase{"law_drag", fem::ElementKind::hex8},
        ForceCase{"law_drag", fem::ElementKind::tet10}, ForceCase{"law_bed", fem::ElementKind::tet4},
        ForceCase{"law_bed_energy", fem::ElementKind::hex8}, ForceCase{"law_damper", fem::ElementKind::hex8},
        ForceCase{"law_lift", fem::ElementKind::hex8}, ForceCase{"law_pressure", fem::ElementKind::hex8},
        ForceCase{"law_pressure", fem::ElementKind::tet10}, ForceCase{"law_wet_drag", fem::ElementKind::tet4},
        ForceCase{"law_point", fem::ElementKind::tet10}, ForceCase{"law_volume", fem::ElementKind::hex8},
        ForceCase{"law_volume", fem::ElementKind::tet10}, ForceCase{"seen_law", fem::ElementKind::hex8}),
    [](const auto& c) { return std::string(c.param.element) + "_" + to_string(c.param.kind); });

/// In statics the displacement from the rest shape stands for the velocity, and springs hold what nothing holds.
TEST(Contact, HasTheTangentOfItsForcesInStatics) {
    const Model model = test::hollow_block(fem::ElementKind::hex8);
    const Body& body = *model.body;
    const Matrix3Xd x = body.mesh.nodes + 2e-4 * test::rough_field(body.node_count(), 0.2);
    const ForceElementPointer element = contact(body, free_faces(body), sphere_distance({0.08, 0.02, 0.01}, 0.04),
                                                {2e7, 0.02, 0.4, 0.3, 2e-4, 1e5});
    const auto forces = [&](const Matrix3Xd& at, HessianKind kind) {
        InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, x.cols());
        if (kind != HessianKind::none) out.hessian = body.pattern.zero;
        element->add(body, {at}, kind, out);
        return out;
    };
    const Matrix3Xd d = scatter(body.pattern, gather(body.pattern, test::rough_field(x.cols(), 2.0)));
    Matrix3Xd tangent = scatter(
        body.pattern,
        VectorXd(forces(x, HessianKind::exact).hessian.selfadjointView<Eigen::Lower>() * gather(body.pattern, d)));
    element->add_unsymmetric_tangent(body, {x}, d, tangent);
    const double step = 1e-7;
    const Matrix3Xd difference = (forces(x + step * d, HessianKind::none).gradient -
                                  forces(x - step * d, HessianKind::none).gradient) /
                                 (2.0 * step);
    EXPECT_LT(gather(body.pattern, tangent - difference).norm(), 1e-6 * gather(body.pattern, difference).norm());
}

TEST(DistanceField, OfABoxIsThatOfItsRoundedSurface) {
    const DistanceField box = box_distance({0.0, 0.0, 0.0}, {0.4, 0.2, 0.2}, 0.02);
    EXPECT_NEAR(box({0.2, 0.1, 0.25}).distance_m, 0.05, 1e-15);
    EXPECT_NEAR(box({0.2, 0.1, 0.17}).distance_m, -0.03, 1e-15);
    EXPECT_NEAR(box({0.41, 0.1, 0.21}).distance_m, std::hypot(0.03, 0.03) - 0.02, 1e-15);
    EXPECT_NEAR((box({0.41, 0.1, 0.21}).normal - Vector3d(1.0, 0.0, 1.0).normalized()).norm(), 0.0, 1e-15);
    // From the middle the way out is the nearest face.
    EXPECT_NEAR(box({0.2, 0.11, 0.12}).normal.z(), 1.0, 1e-15);
}

TEST(CavityPressure, PushesNothingAwayAndTurnsWithTheBody) {
    const Model model = test::hollow_block(fem::ElementKind::hex8);
    const Body& body = *model.body;
    const std::vector<std::vector<int>> cavities = closed_cavities(body);
    ASSERT_EQ(cavities.size(), 1u);
    EXPECT_EQ(open_edges(body, cavities[0]), 0);
    EXPECT_NEAR(cavity_volume(body, cavities[0], body.mesh.nodes), test::hollow_volume_m3, 1e-12);
    const ForceElementPointer pressure = cavity_pressure(body, cavities[0], fibre::Signal::constant(5e3));
    const auto gradient = [&](const Matrix3Xd& x) {
        InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, x.cols());
        pressure->add(body, {x}, HessianKind::none, out);
        return out.gradient;
    };
    const Matrix3Xd x = body.mesh.nodes + 3e-4 * test::rough_field(body.node_count(), 0.2);
    const Matrix3Xd g = gradient(x);
    EXPECT_GT(g.norm(), 1.0);
    EXPECT_LT(g.rowwise().sum().norm(), 1e-12 * g.norm());
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    EXPECT_LT((gradient(R * x) - R * g).norm(), 1e-12 * g.norm());
}

}  // namespace
}  // namespace myo::model
