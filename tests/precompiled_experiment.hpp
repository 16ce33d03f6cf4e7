#pragma once

#include "../core/precompiled_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
