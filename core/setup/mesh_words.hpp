#pragma once

#include <string>

namespace myo::setup {

struct Setup;

/// Summary of the mesh: "64 hex8 elements of 5 mm, 2 layers across 10 mm, 375 degrees of freedom", where 10 mm is the
/// thinnest wall. An estimated number of layers reads "about 1.9".
std::string mesh_words(const Setup& setup);

}  // namespace myo::setup
