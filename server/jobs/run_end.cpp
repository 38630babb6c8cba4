#include "server/jobs/run_end.h"

#include <utility>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/drape/stop_reason.h"

namespace toile::jobs {
namespace {

std::string seconds(double s) { return fixed_text(s, 2) + " s"; }

std::string millimetres(double m) { return fixed_text(mm_from_metres(m), 1) + " mm"; }

std::string at_rest(const drape::DrapeResult& result) {
  return "the cloth came to rest after " + seconds(result.simulated_time) + " with ";
}

RunEnd succeeded(std::string code, std::string reason) {
  RunEnd end;
  end.succeeded = true;
  end.code = std::move(code);
  end.reason = std::move(reason);
  return end;
}

/// A result with a fault in one place.
RunEnd partly(std::string code, std::string reason, std::string where) {
  RunEnd end = succeeded(std::move(code), std::move(reason));
  end.where = std::move(where);
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

void fall_short(RunEnd& end, const std::string& code, const std::string& message) {
  end.notes.push_back({code, message});
  end.reason += "; " + message;
}

RunEnd verdict_on(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  const drape::StopReason& why = result.stop_reason;
  switch (why.kind) {
    case drape::Stop::kSettled:
      return succeeded("settled", "the cloth came to rest after " + seconds(result.simulated_time));
    case drape::Stop::kTime:
      if (!result.open_seams.empty())
        return partly("open_seam",
                      "the cloth still moved after " + seconds(input.settings.max_time) + ", with the seam " +
                          millimetres(result.open_seams.front().gap) +
                          " open; see what lies between its sides",
                      "seam " + result.open_seams.front().id);
      return succeeded("time", "the cloth still moved after " + seconds(input.settings.max_time) +
                                   "; a higher settings.max_time_s or settle_speed_mm_s lets it settle");
    case drape::Stop::kOpenSeam:
      return partly("open_seam",
                    at_rest(result) + "the seam still " + millimetres(why.gap) +
                        " open; see whether its sides are as long as each other and nothing lies between",
                    "seam " + why.name);
    case drape::Stop::kOpenButton:
      return failed("drape.open_button",
                    at_rest(result) + "the button's thread still " + millimetres(why.gap) +
                        " too long; see whether the button and its hole can reach each other",
                    "button " + why.name);
    case drape::Stop::kNotFinite:
      return failed(
          "drape.not_finite",
          "the simulation left the numbers; a smaller settings.time_step_s or a softer fabric helps", "");
    case drape::Stop::kCancelled:
      break;
  }
  // Who cancels a job asks for no verdict; a drape that was cut off all the same is told as that.
  return failed("drape.stopped", "the drape stopped before its end: " + drape::to_string(why), "");
}

}  // namespace toile::jobs
