#pragma once
// A log for each job, for whoever asks why one came out as it did.

#include <filesystem>
#include <memory>

#include "core/base/log.h"

namespace toile::log {

/// The most that is kept of a job: what would make it larger is left out.
inline constexpr std::size_t kMostJobLogBytes = std::size_t{256} << 10;

/// Passes every line on to `next`, and puts those that carry the field "job", however light, as JSON also
/// into the file of that name in `folder`. A file that cannot be written costs its lines and nothing else.
/// `next` must outlive it.
std::unique_ptr<LogSink> make_job_log(LogSink& next, std::filesystem::path folder);

}  // namespace toile::log
