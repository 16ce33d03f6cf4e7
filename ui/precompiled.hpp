#pragma once

// Library headers that nearly every file of the workbench reads, parsed once. Each file still includes what it uses.

#include "../core/precompiled.hpp"

#include <imgui.h>
