#include "server/jobs/kept_drape.h"

#include "core/base/state_bytes.h"

namespace toile::jobs {
namespace {

constexpr std::string_view kMagic = "TOILEJB\n";

}  // namespace

std::string encode_kept(const KeptDrape& kept) {
  StateWriter out;
  out.raw(kMagic);
  out.value(kept.motion);
  out.value(kept.checkpoint);
  if (!kept.shape.empty()) out.value(kept.shape);
  return out.take();
}

Result<KeptDrape> decode_kept(std::string_view bytes) {
  KeptDrape kept;
  StateReader in(bytes.starts_with(kMagic) ? bytes.substr(kMagic.size()) : std::string_view());
  in.value(kept.motion);
  in.value(kept.checkpoint);
  if (in.ok() && !in.at_end()) in.value(kept.shape);
  if (in.ok() && in.at_end()) return kept;
  return Error{"checkpoint.damaged", "the checkpoint cannot be read", "", ErrorKind::kSystem};
}

}  // namespace toile::jobs
