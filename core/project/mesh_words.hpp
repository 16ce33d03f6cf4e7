#pragma once

#include <string>

namespace myo {

struct Study;

/// "64 hex8 elements of 5 mm, 2 layers across 10 mm, 375 degrees of freedom": what a study's body is made of, its
/// thinnest wall and its unknowns. Where layers cannot be counted, they are "about 1.9".
std::string mesh_words(const Study& study);

}  // namespace myo
