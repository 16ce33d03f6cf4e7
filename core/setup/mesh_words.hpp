#pragma once

#include <string>

namespace myo::setup {

struct Setup;

/// "64 hex8 elements of 5 mm, 2 layers across 10 mm, 375 degrees of freedom": what a setup's body is made of, its
/// thinnest wall and its unknowns. Where layers cannot be counted, they are "about 1.9".
std::string mesh_words(const Setup& setup);

}  // namespace myo::setup
