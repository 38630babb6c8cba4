#include "server/http/body_budget.h"

#include "server/http/problem.h"

namespace toile::http {

HttpResponse no_room() {
  return problem(503, {"server.busy", "too many uploads or large answers at once; try again in a few seconds",
                       "", ErrorKind::kUnavailable});
}

}  // namespace toile::http
