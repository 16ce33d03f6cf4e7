#pragma once

#include <functional>

namespace myo::bench {

/// A straight bar along x of rectangular section, held at x = 0; it bends along z.
///
/// The formulas below are beam theory: sections contract freely, also at the held end, where a solid cannot. For
/// nu = 0.5 that makes a solid stiffer by the bending of a sixteenth of its height: for gravity 0.6 % at L/h = 40
/// (from the converged sag of the case locking, L/h = 3.3). Where a law is not linear, the fibres of a section want to
/// contract by different amounts; beam theory lets each of them.
struct BarShape {
    double length_m = 0.2;
    double width_m = 0.005;               // along y
    double height_m = 0.005;              // along z
    double youngs_modulus_Pa = 263824.0;  // the paper's beam: Dubied et al. 2022, sec. IV
    double poissons_ratio = 0.49;
    double density_kg_m3 = 1070.0;

    double area_m2() const { return width_m * height_m; }
    double bending_stiffness_N_m2() const;  // E I
    double shear_modulus_Pa() const;
};

/// Deflection of the free end under the bar's weight [m], shear included. Source: Timoshenko 1921.
double sag_under_gravity(const BarShape& bar, double gravity_m_s2);

/// First frequency of bending [rad/s] with rotary inertia and shear to first order of (height / length)^2.
/// Source: Blevins 1979, table 8-1 and, for the integrals of the mode, appendix C.
double first_bending_rad_s(const BarShape& bar);

/// Torque per twist of the whole bar [N m/rad]. Source: Timoshenko & Goodier 1970, sec. 109 (Saint-Venant's series).
double torsion_stiffness_N_m(const BarShape& bar);

/// The neo-Hookean law of the schema with Yeoh's second term c2, softened by the largest energy: damage_max, scale.
struct StretchLaw {
    double yeoh_c2 = 0.0;
    double damage_max = 0.0;
    double energy_scale_J_m3 = 1.0;
};

/// Nominal stress of a fibre of the bar at a strain [Pa]: it contracts sideways until nothing presses there.
double uniaxial_stress(const BarShape& bar, const StretchLaw& law, double strain);

/// Deflection of the free end under a force there [m], to first order of the slope: the curvature of every section
/// balances the moment, which is the law's stress integrated over the height.
double end_load_deflection(const BarShape& bar, const StretchLaw& law, double force_N);

/// Deflection of the free end [m] towards the stiffer side of a bar that is pulled by a force in its axis. The modulus
/// is linear across the height, E (1 + relative_change (z/h - 1/2)).
double deflection_of_graded_bar(const BarShape& bar, double relative_change, double pull_N);

/// Deflection of the free end [m] by a muscle that fills the upper half, of stiffness w, and wants to be shorter by
/// `contraction`, a small part of its length: a bar of the two moduli E and E + w without force and moment.
double deflection_by_half_muscle(const BarShape& bar, double stiffness_Pa, double contraction);

}  // namespace myo::bench
