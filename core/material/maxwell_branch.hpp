#pragma once

namespace myo::material {

/// A spring and a dashpot in series beside the elastic network: viscoelastic creep of the deviatoric stress, S = 2 mu g
/// dev(E - E_v) with the dashpot's strain dE_v/dt = (E - E_v) / tau. It answers a sudden load (1 + g) times as stiffly
/// and lets go with time. Source: Simo & Hughes 1998, ch. 10, of the standard linear solid; here in Green strain.
struct MaxwellBranch {
    double modulus_ratio = 0.0;      // g: the branch's shear modulus over that of the network
    double relaxation_time_s = 0.0;  // tau, above 0
};

}  // namespace myo::material
