#include "server/jobs/run_end.h"

#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

namespace toile {
namespace {

std::string seconds(double s) {
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "%.2f s", s);
  return text.data();
}

RunEnd succeeded(std::string code, std::string reason) {
  RunEnd end;
  end.succeeded = true;
  end.code = std::move(code);
  end.reason = std::move(reason);
  return end;
}

RunEnd failed(std::string code, std::string reason, std::string where) {
  RunEnd end;
  end.code = std::move(code);
  end.reason = std::move(reason);
  end.where = std::move(where);
  return end;
}

}  // namespace

RunEnd verdict_on(const DrapeInput& input, const DrapeResult& result) {
  constexpr std::string_view kStalled = "stalled ";  // and the seam
  const std::string& why = result.stop_reason;
  if (result.settled) {
    return succeeded("settled", "the cloth came to rest after " + seconds(result.simulated_time));
  }
  if (why == "time") {
    return succeeded("time", "the cloth still moved after " + seconds(input.settings.max_time) +
                                 "; a higher settings.max_time_s or settle_speed_mm_s lets it settle");
  }
  if (why.starts_with(kStalled)) {
    return failed("drape.stalled_seam",
                  "the seam did not close; place its pieces nearer to each other, with nothing between them",
                  why.substr(kStalled.size()));
  }
  if (why == "not finite") {
    return failed("drape.not_finite",
                  "the simulation left the numbers; a smaller settings.time_step_s or a softer fabric helps",
                  "");
  }
  return failed("drape.stopped", "the drape stopped before its end: " + why, "");
}

}  // namespace toile
