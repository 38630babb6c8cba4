#pragma once
// What every test includes.

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "cmake/precompiled/standard.h"
