#pragma once

// What nearly every file that knows experiments reads, parsed once. Each file still includes what it uses.

#include "precompiled.hpp"

#include "project/experiment.hpp"
#include "project/study_effects.hpp"
