#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace myo::measurement {

// Faults of labelling in recordings: exchanged labels (here), excursions of a track (excursions.hpp) and spikes
// (spikes.hpp). They are restored or hidden when a trial is read; faults that only a model can reveal stay.

/// An interval in which markers carried each other's labels.
struct Exchange {
    std::vector<std::size_t> markers;  // indices, ascending, at least two
    Eigen::Index first = 0, end = 0;   // samples [first, end)
};

/// Restores tracks whose labels were exchanged, as happens when a camera system loses several markers and
/// relabels them.
///
/// Each track is predicted from sample to sample by linear extrapolation; over a gap by the last position. Labels have
/// moved if (1) each track is closest to another track's prediction, four times closer than to its own, and these
/// assignments form a cycle; a moving body, or a marker that jumps to a free position, forms none. Labels have also
/// moved if (2) markers lost together (up to four) reappear so that another order of their labels keeps their relative
/// positions four times better, unless other markers show that the body turned round, or (3) a marker lost alone
/// reappears where its label was taken by another one. An exchange that is never reversed is restored only if it began
/// while the markers were hidden, where camera systems relabel; in full view it may be the effect `marker_swap` of the
/// catalogue or two wrong labels, which only a model can decide.
///
/// @param tracks  in/out, one per marker, 3 x T [m], NaN where occluded
/// @return        the exchanges that were reversed, in order of time
std::vector<Exchange> put_back_exchanges(std::vector<Eigen::Matrix3Xd>& tracks);

}  // namespace myo::measurement
