#pragma once
// People for whom tests ask.

#include "server/store/request_context.h"

namespace toile {

/// The user of the server under test.
inline const RequestContext kMe("local");
inline const RequestContext kAnn("ann"), kBob("bob");
inline const RequestContext kStranger("somebody else");

}  // namespace toile
