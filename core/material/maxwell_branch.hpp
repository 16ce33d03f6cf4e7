#pragma once

namespace myo::material {

/// Maxwell branch (spring and dashpot in series) parallel to the elastic network: creep of the deviatoric stress, S = 2
/// mu g dev(E - E_v) with the dashpot strain dE_v/dt = (E - E_v) / tau.
///
/// A sudden load meets (1 + g) times the relaxed stiffness, which then relaxes.
/// Source: Simo & Hughes 1998, ch. 10, standard linear solid; here in Green strain.
struct MaxwellBranch {
    double modulus_ratio = 0.0;      // g: shear modulus of the branch over that of the network
    double relaxation_time_s = 0.0;  // tau > 0

    bool operator==(const MaxwellBranch&) const = default;
};

}  // namespace myo::material
