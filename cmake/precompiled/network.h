#pragma once
// Asio and Beast take three seconds to parse; every file of the two rooms that speak to the network needs
// them.

#include <boost/asio.hpp>
#include <boost/beast.hpp>

#include "cmake/precompiled/standard.h"
