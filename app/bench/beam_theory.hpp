#pragma once

#include <functional>

namespace myo::bench {

/// A straight bar along x of rectangular cross section, clamped at x = 0; bending along z.
///
/// The formulas below are beam theory: cross sections contract freely, also at the clamp, where a solid cannot. For
/// nu = 0.5 this makes a solid stiffer by the bending of a sixteenth of its height: for gravity 0.6 % at L/h = 40 (from
/// the converged sag of the case locking, L/h = 3.3). If a law is nonlinear, the fibres of a section contract by
/// different amounts; beam theory permits that.
struct BarShape {
    double length_m = 0.2;
    double width_m = 0.005;               // along y
    double height_m = 0.005;              // along z
    double youngs_modulus_Pa = 263824.0;  // the paper's beam: Dubied et al. 2022, sec. IV
    // Bars of the cases accuracy and default-meshes; nearly incompressible, as silicone.
    double poissons_ratio = 0.49;
    double density_kg_m3 = 1070.0;

    double area_m2() const { return width_m * height_m; }
    double bending_stiffness_N_m2() const;  // E I
    double shear_modulus_Pa() const;        // E / (2 (1 + nu))
};

/// Deflection of the free end under the weight of the bar [m], shear included. Source: Timoshenko 1921.
double sag_under_gravity(const BarShape& bar, double gravity_m_s2);

/// First bending frequency [rad/s] with rotary inertia and shear, to first order in (height / length)^2.
/// Source: Blevins 1979, table 8-1 and, for the integrals of the mode, appendix C.
double first_bending_rad_s(const BarShape& bar);

/// Torque over twist of the whole bar [N m/rad]. Source: Timoshenko & Goodier 1970, sec. 109 (Saint-Venant's series).
double torsion_stiffness_N_m(const BarShape& bar);

/// The neo-Hookean law of the schema with Yeoh's second coefficient c2, softened as a function of the largest energy.
struct StretchLaw {
    double yeoh_c2 = 0.0;            // relative to the first coefficient
    double damage_max = 0.0;         // limit of the relative loss of stress
    double energy_scale_J_m3 = 1.0;  // energy density over which the softening develops
};

/// Nominal uniaxial stress [Pa] at a strain on first loading; the lateral stretch follows from zero lateral stress.
double uniaxial_stress(const BarShape& bar, const StretchLaw& law, double strain);

/// Deflection of the free end under a transverse force there [m], to first order in the slope. The curvature of each
/// section balances the moment, with the stress of the law integrated over the height.
double end_load_deflection(const BarShape& bar, const StretchLaw& law, double force_N);

/// Deflection of the free end [m] towards the stiffer side of a bar under axial tension, with a modulus linear across
/// the height: E (1 + relative_change (z/h - 1/2)).
double deflection_of_graded_bar(const BarShape& bar, double relative_change, double pull_N);

/// Deflection of the free end [m] due to a muscle in the upper half with stiffness w and rest length shorter by the
/// fraction `contraction` << 1: a bimaterial bar of moduli E and E + w without resulting force and moment.
double deflection_by_half_muscle(const BarShape& bar, double stiffness_Pa, double contraction);

}  // namespace myo::bench
