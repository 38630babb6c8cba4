#pragma once
// People for whom tests ask.

#include "server/store/request_context.h"

namespace toile {

/// The user of the server under test.
inline const store::RequestContext kMe("local");
inline const store::RequestContext kAnn("ann"), kBob("bob");
inline const store::RequestContext kStranger("somebody else");

}  // namespace toile
