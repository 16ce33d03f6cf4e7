#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

/// Markers that bore each other's names for a while.
struct Exchange {
    std::vector<std::size_t> markers;  // ascending, at least two
    Eigen::Index first = 0, end = 0;   // samples [first, end)
};

/// Puts tracks back that were exchanged for a while, as a camera system does that loses sight of markers and names them
/// anew.
///
/// Each track is foretold from one sample to the next, linearly, over a gap by where it was last seen. Names have moved
/// where tracks are each other's nearest, four times nearer than their own, and close a ring: a body that moves on, or
/// a marker that jumps to where no other was, makes none. Two that were lost together have, too, where they come back
/// the other way round, and one that was lost alone where another takes its name. Names that are never given back stay
/// as they are: that is an effect of the catalogue (`marker_swap`) or two wrong labels, and a model must tell.
///
/// @param tracks one for each marker, 3 x T [m], NaN where occluded; put back in place
/// @return in the order of time
std::vector<Exchange> put_back_exchanges(std::vector<Eigen::Matrix3Xd>& tracks);

}  // namespace myo::measurement
