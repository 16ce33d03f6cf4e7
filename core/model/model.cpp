#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "model/force_element.hpp"

namespace myo {

std::vector<Moduli> uniform_moduli(int cell_count, double youngs_modulus_Pa, double poissons_ratio) {
    return std::vector<Moduli>(static_cast<std::size_t>(cell_count), moduli_from_young(youngs_modulus_Pa, poissons_ratio));
}

namespace {

/// Mean cell volume on the diagonal: what every vertex gets of a density of 1.
Eigen::SparseMatrix<double> equal_vertex_mass(const Body& body) {
    Eigen::SparseMatrix<double> mass(body.node_count(), body.node_count());
    mass.setIdentity();
    mass *= body.unit_mass.sum() / body.cell_count();
    return mass;
}

}  // namespace

Eigen::SparseMatrix<double> mass_matrix(const Model& model) {
    Eigen::SparseMatrix<double> mass =
        model.mass_model == MassModel::consistent ? model.body->unit_mass : equal_vertex_mass(*model.body);
    mass *= model.density_kg_m3;
    for (const AttachedMass& attached : model.masses)
        for (int i = 0; i < model.body->node_count(); ++i)
            if (attached.share(i) != 0.0) mass.coeffRef(i, i) += attached.mass_kg * attached.share(i);
    mass.makeCompressed();
    return mass;
}

// Eigen multiplies dense rows one by one through the sparse matrix; node by node is several times faster.
Eigen::Matrix3Xd times_mass(const Eigen::Matrix3Xd& X, const Eigen::SparseMatrix<double>& mass) {
    Eigen::Matrix3Xd result(3, mass.cols());
    parallel_ranges(static_cast<int>(mass.outerSize()), 1000, [&](int first, int end) {
        for (int j = first; j < end; ++j) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (Eigen::SparseMatrix<double>::InnerIterator entry(mass, j); entry; ++entry) sum += entry.value() * X.col(entry.row());
            result.col(j) = sum;
        }
    });
    return result;
}

Eigen::Matrix3Xd external_forces(const Model& model, const Eigen::SparseMatrix<double>& mass, double t, bool before) {
    const Eigen::VectorXd nodal_mass = mass * Eigen::VectorXd::Ones(mass.cols());
    Eigen::Matrix3Xd f = model.gravity_m_s2 * nodal_mass.transpose();
    for (const DeadForce& load : model.forces)
        if (before ? load.active_before(t) : load.active(t)) f += load.force_N * load.share.transpose();
    return f;
}

std::vector<double> activations(const Model& model, double t, bool before) {
    std::vector<double> a;
    for (const Signal& signal : model.activation) a.push_back(before ? signal.value_before(t) : signal.value(t));
    return a;
}

std::vector<double> jump_times(const Model& model) {
    std::vector<double> times;
    for (const DeadForce& load : model.forces)
        for (const double t : {load.from_s, load.until_s})
            if (std::isfinite(t)) times.push_back(t);
    for (const Signal& signal : model.activation)
        for (const double t : signal.jumps()) times.push_back(t);
    for (const ForceElementPointer& element : model.force_elements)
        for (const double t : element->jumps()) times.push_back(t);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace myo
