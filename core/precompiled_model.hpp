#pragma once

// What nearly every file above the model reads, parsed once. Each file still includes what it uses.

#include "precompiled.hpp"

#include "model/model.hpp"
