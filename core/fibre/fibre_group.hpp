#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// One quadrature point of a fibre: F m = x_cell * shape, with shape = (dN/dX) m.
struct FibrePoint {
    int cell = 0;
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1> shape;  // nodes per cell [1/m]
    double volume = 0.0;                                       // rest volume it stands for [m3]
};

/// Muscle fibres with one signal a(t): energy per rest volume w/2 (|F m| - a)^2.
/// Source: the experiment schema; Min et al. 2019 ("SoftCon").
struct FibreGroup {
    std::string name;
    double stiffness_Pa = 0.0;  // w
    std::vector<FibrePoint> points;
    std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 10, 3>>
        gradients{};  // dN/dX per point [1/m]: shape = gradient m

    double volume() const;
};

/// Fibres along `direction` (unit, rest frame) in the part of the body inside `box`.
///
/// Cells are integrated over their intersection with the box, exactly for flat faces and strains linear in the rest
/// position, so that a group thinner than a cell bends as it should.
FibreGroup fibres_in_box(const mesh::VolumeMesh& mesh, const Box& box, const Eigen::Vector3d& direction,
                         double stiffness_Pa, std::string name);

/// Energy per rest volume of one point and its derivatives with respect to s = F m.
struct FibreResponse {
    double energy = 0.0;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
    Eigen::Vector3d gradient_activation;  // d gradient / d a
};
FibreResponse fibre_response(const Eigen::Vector3d& s, double activation, double stiffness_Pa);

}  // namespace myo::fibre
