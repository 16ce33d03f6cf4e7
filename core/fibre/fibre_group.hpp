#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// Quadrature point of a fibre: F m = x_cell * shape with shape = (dN/dX) m.
struct FibrePoint {
    int cell = 0;                                              // cell number
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1> shape;  // nodes per cell [1/m]
    double volume = 0.0;                                       // [m3] rest volume represented by the point
};

/// Muscle fibres with a common activation a(t): energy per rest volume w/2 (|F m| - a)^2.
/// Source: the project file; Min et al. 2019 ("SoftCon").
struct FibreGroup {
    std::string name;                // in files and messages
    double stiffness_Pa = 0.0;       // w
    std::vector<FibrePoint> points;  // points of a cell are consecutive
    // dN/dX per point [1/m]: shape = gradient m
    std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 10, 3>> gradients{};

    /// Total rest volume of the points [m3].
    double volume() const;
};

/// Direction m of a fibre point, from shape = gradient m by least squares. Asserts that the group has its gradients.
Eigen::Vector3d direction_of(const FibreGroup& group, std::size_t point);

/// Fibres along a direction in the part of the body inside a box.
///
/// The intersection of each cell with the box is integrated exactly for flat faces and strains linear in the rest
/// position, so that a group thinner than a cell has the correct bending stiffness.
/// @param box           rest frame [m]
/// @param direction     unit, rest frame
/// @param stiffness_Pa  w
FibreGroup fibres_in_box(const mesh::VolumeMesh& mesh, const Box& box, const Eigen::Vector3d& direction,
                         double stiffness_Pa, std::string name);

/// Energy density of one fibre point and its derivatives with respect to s = F m.
struct FibreResponse {
    double energy = 0.0;                  // [J/m3]
    Eigen::Vector3d gradient;             // d energy / d s [Pa]
    Eigen::Matrix3d hessian;              // d2 energy / d s2 [Pa]
    Eigen::Vector3d gradient_activation;  // d gradient / d a [Pa]
};
/// Fibre law w/2 (|s| - a)^2.
/// @param s  F m, dimensionless; non-finite results for s = 0
FibreResponse fibre_response(const Eigen::Vector3d& s, double activation, double stiffness_Pa);

}  // namespace myo::fibre
