#pragma once

#include "../ui/precompiled.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
