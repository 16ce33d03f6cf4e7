#pragma once

namespace myo::setup {

/// Smallest and largest command of a chamber or tendon in all trials, 0 included.
struct CommandRange {
    double lowest = 0.0, highest = 0.0;  // [Pa], [N] or [m]; lowest <= 0 <= highest
};

}  // namespace myo::setup
