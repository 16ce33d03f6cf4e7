#pragma once

#include "../core/precompiled_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
