#include "sensitivity/model_gradient.hpp"

#include <cassert>
#include <numeric>

#include "dynamics/creep.hpp"
#include "model/force_element.hpp"
#include "model/point_energy.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

double dot(const Matrix3Xd& a, const Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

/// Part of M p from the isotropic masses: M p minus the directional part.
Matrix3Xd isotropic_part(const model::MassMatrix& mass, const Matrix3Xd& p, Matrix3Xd Mp) {
    if (mass.has_directional()) model::add_directional(mass.directional, -p, Mp);
    return Mp;
}

}  // namespace

material::YoungPoisson young_gradient(const model::Model& model, const ModelGradient& gradient,
                                      const std::vector<int>& cells) {
    material::YoungPoisson result;
    const auto add = [&](std::size_t c) {
        const auto [E, nu] = material::young_from_moduli(model.moduli[c]);
        const material::Moduli& m = model.moduli[c];
        const material::Moduli& g = gradient.moduli[c];
        // E: all moduli are proportional to it. nu at fixed E: mu = E / (2 (1 + nu)), kappa = E / (3 (1 - 2 nu)).
        result.youngs_modulus_Pa += (g.mu * m.mu + g.kappa * m.kappa) / E;
        result.poissons_ratio += -g.mu * m.mu / (1.0 + nu) + g.kappa * 2.0 * m.kappa / (1.0 - 2.0 * nu);
    };
    if (cells.empty())
        for (std::size_t c = 0; c < gradient.moduli.size(); ++c) add(c);
    for (const int c : cells) add(static_cast<std::size_t>(c));
    return result;
}

Matrix3Xd fibre_direction_gradient(const model::Model& model, const ModelGradient& gradient, std::size_t group) {
    assert(group < gradient.fibre_shape.size());
    const fibre::FibreGroup& fibres = (*model.fibres)[group];
    Matrix3Xd result = Matrix3Xd::Zero(3, model.body->cell_count());
    for (std::size_t k = 0; k < fibres.points.size(); ++k)
        result.col(fibres.points[k].cell) += fibres.gradients[k].transpose() * gradient.fibre_shape[group][k];
    return result;
}

GradientSum::GradientSum(const model::Model& model, bool fibre_points)
    : model_(model),
      masses_(model::mass_spans(model)),
      moduli_(model::no_moduli_work(model)),
      fibres_(model::no_fibre_work(model, fibre_points)) {
    if (model.creep) damping_ = model::no_moduli_work(model);
    if (model.softening) softened_ = model;
    for (std::size_t k = 0; k < model.material->parameters().size(); ++k)
        by_law_.push_back(stiffness_tangent(model, law_tangent(k)));
    gradient_.law.assign(by_law_.size(), 0.0);
    for (const fibre::Signal& signal : model.activation) gradient_.activation.emplace_back(signal.values.size(), 0.0);
    gradient_.forces_N.assign(model.forces.size(), Vector3d::Zero());
    gradient_.attached_masses_kg.assign(model.masses.size(), 0.0);
    gradient_.directional_masses.assign(model.directional_masses.size(), 0.0);
    for (const model::ForceElementPointer& element : model.force_elements)
        gradient_.force_elements.push_back(
            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(element->parameters().size())));
}

void GradientSum::add(const Balance& at, const Matrix3Xd& p, const Matrix3Xd& Mp) {
    add_material(at, p);
    if (!model_.fibres->empty()) {
        // The work per unit activation is distributed to knots here, per equilibrium; the other works accumulate.
        std::fill(fibres_.by_activation.begin(), fibres_.by_activation.end(), 0.0);
        model::add_fibre_work(model_, at.x, p, model::activations(model_, at.time_s, at.before_jump), fibres_);
        // A signal is linear between its knots: its value distributes to the two adjacent knots.
        for (std::size_t g = 0; g < fibres_.by_activation.size(); ++g) {
            // One-sided at a jump: the knot on the side from which the loads are taken.
            const fibre::Signal::Weights w = model_.activation[g].weights(at.time_s, at.before_jump);
            gradient_.activation[g][w.left] -= w.of_left * fibres_.by_activation[g];
            gradient_.activation[g][w.right] -= w.of_right * fibres_.by_activation[g];
        }
    }
    for (std::size_t e = 0; e < model_.force_elements.size(); ++e) {
        Eigen::VectorXd work = Eigen::VectorXd::Zero(gradient_.force_elements[e].size());
        model_.force_elements[e]->add_work(*model_.body, {at.x, at.v, 0.0, at.time_s, at.before_jump}, p, work);
        gradient_.force_elements[e] -= work;
    }
    for (std::size_t f = 0; f < model_.forces.size(); ++f) {
        const model::DeadForce& load = model_.forces[f];
        // `share` distributes the force to the nodes: the derivative is the adjoint at its point of action.
        if (const double factor = load.factor(at.time_s, at.before_jump); factor != 0.0)
            gradient_.forces_N[f] += factor * (p * load.share);
    }
    const Matrix3Xd isotropic_p = isotropic_part(masses_[model::span_at(masses_, at.inertia_at_s)].mass, p,
                                                 Mp);  // only isotropic masses have weight
    gradient_.gravity_m_s2 += isotropic_p.rowwise().sum();
    add_isotropic(p, isotropic_p, model_.gravity_m_s2.replicate(1, p.cols()));
    // Inertia of directional masses and the derivative with respect to Lambda.
    if (at.accelerations) add_momentum(at.inertia_at_s, p, Mp, *at.accelerations, at.by_velocity_force);
}

void GradientSum::add_material(const Balance& at, const Matrix3Xd& p) {
    model::StrainRate rate = at.rate;
    Eigen::VectorXd effective, of_body;
    if (model_.creep && at.rate.history) {
        // The effective rate F E + H of creep.hpp has unit viscosity; damping multiplies the strain rate of the body.
        effective = dynamics::viscous_history(model_, at.rate.factor, *at.rate.history);
        of_body = at.rate.history->head(effective.size());
        rate = {dynamics::viscous_factor(model_, at.rate.factor), &effective};
        model::ModuliWork of_damping = model::no_moduli_work(model_);
        model::add_moduli_work(model_, at.x, p, {at.rate.factor, &of_body}, of_damping);
        for (std::size_t c = 0; c < of_damping.viscous.size(); ++c) damping_.viscous[c] += of_damping.viscous[c];
    }
    const bool softened = at.softening && at.softening->size() > 0;
    if (softened) {
        // Softening multiplies the elastic moduli only.
        softened_.point_factors = model::times_factors(model_.point_factors, *at.softening);
        model::add_moduli_work(softened_, at.x, p, {}, moduli_);
        model::ModuliWork viscous = model::no_moduli_work(model_);
        model::add_moduli_work(model_, at.x, p, rate, viscous);
        for (std::size_t c = 0; c < viscous.viscous.size(); ++c) moduli_.viscous[c] += viscous.viscous[c];
    } else {
        model::add_moduli_work(model_, at.x, p, rate, moduli_);
    }
    for (std::size_t k = 0; k < by_law_.size(); ++k) {
        by_law_[k].elastic_factors = softened ? softened_.point_factors : model_.point_factors;
        gradient_.law[k] -= dot(
            model::internal_energy(model_, at.x, {&by_law_[k], nullptr, {}, nullptr}, model::HessianKind::none)
                .gradient,
            p);
    }
}

void GradientSum::add_energies(const Matrix3Xd& x, const Eigen::VectorXd& weights) {
    const model::Body& body = *model_.body;
    const Eigen::VectorXd part = weights.cwiseProduct(model::isochoric_energy_densities(model_, x));
    for (int c = 0; c < body.cell_count(); ++c) {
        double sum = 0.0;
        for (int q = 0; q < body.points_per_cell; ++q) sum += part(body.point_entry(c, q));
        // Densities are proportional to mu. The sign is that of the works, see take().
        moduli_.elastic[static_cast<std::size_t>(c)].mu -= sum / model_.moduli[static_cast<std::size_t>(c)].mu;
    }
    for (std::size_t k = 0; k < by_law_.size(); ++k) {
        model::Model changed = model_;
        changed.material = by_law_[k].law;
        gradient_.law[k] += weights.dot(model::isochoric_energy_densities(changed, x));
    }
}

void GradientSum::add_momentum(double at_s, const Matrix3Xd& p, const Matrix3Xd& Mp, const Matrix3Xd& u,
                               const Matrix3Xd* by_velocity_force) {
    add_isotropic(p, isotropic_part(masses_[model::span_at(masses_, at_s)].mass, p, Mp), u);
    for (std::size_t k = 0; k < model_.directional_masses.size(); ++k) {
        const model::DirectionalMass& directional = model_.directional_masses[k];
        if (!directional.active(at_s)) continue;
        Matrix3Xd Du = Matrix3Xd::Zero(3, u.cols());
        model::add_directional(directional.inertia_kg, u, Du);
        gradient_.directional_masses[k] += dot(p, Du);
    }
    if (by_velocity_force) gradient_.velocity_force_1_s += dot(Mp, *by_velocity_force);
}

// Attached masses separately; the density is proportional to what remains, see take().
void GradientSum::add_isotropic(const Matrix3Xd& p, const Matrix3Xd& isotropic_p, const Matrix3Xd& u) {
    of_mass_ += dot(isotropic_p, u);
    for (std::size_t k = 0; k < model_.masses.size(); ++k)
        gradient_.attached_masses_kg[k] += p.cwiseProduct(u).colwise().sum() * model_.masses[k].share;
}

ModelGradient GradientSum::take() {
    // Forces are minus the energy gradient: hence the signs. Viscous forces are proportional to damping times mu.
    for (std::size_t c = 0; c < moduli_.elastic.size(); ++c) {
        const double viscous = moduli_.viscous[c];
        gradient_.moduli.push_back(
            {-moduli_.elastic[c].mu - model::viscous_scale(model_, c) * viscous, -moduli_.elastic[c].kappa});
        gradient_.damping_s -= model_.moduli[c].mu * (model_.creep ? damping_.viscous[c] : viscous);
    }
    for (const double work : fibres_.by_stiffness) gradient_.fibre_stiffness_Pa.push_back(-work);
    for (auto& group : fibres_.by_shape)
        for (Eigen::VectorXd& shape : group) shape = -shape;
    gradient_.fibre_shape = std::move(fibres_.by_shape);
    for (auto& group : fibres_.by_volume)
        for (double& volume : group) volume = -volume;
    gradient_.fibre_volume_m3 = std::move(fibres_.by_volume);
    double attached = 0.0;
    for (std::size_t k = 0; k < model_.masses.size(); ++k)
        attached += model_.masses[k].mass_kg * gradient_.attached_masses_kg[k];
    // M is linear in the density and the attached masses, so p . M u is the sum of each times its derivative.
    gradient_.density_kg_m3 = model_.density_kg_m3 > 0.0 ? (of_mass_ - attached) / model_.density_kg_m3 : 0.0;
    return std::move(gradient_);
}

}  // namespace myo::sensitivity
