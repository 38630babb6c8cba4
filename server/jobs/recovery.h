#pragma once
// What becomes of the jobs that a process leaves which is no more. Pure.

#include "server/store/store.h"

namespace toile::jobs {

/// Crashes that are put down to one job before it is not tried again: one that takes the server down with it
/// must not do so for ever.
inline constexpr int kMostAttempts = 3;

enum class Fate {
  kStays,            ///< queued or paused, as it was
  kGoesOn,           ///< back to the queue
  kGoesAlone,        ///< the same, but nothing runs beside it until it has come further
  kFails,            ///< not tried again
  kWithoutPictures,  ///< draped long since: ends with the results that it has
};

struct Recovery {
  Fate fate = Fate::kStays;
  int attempt = 0;  ///< for the job's row
};

/// Judges a job whose holder is gone: its row becomes what it is to be from now on.
void judge(store::Store::LeftJob& left);

/// `further`: the job has kept a checkpoint since it began last. `running`: how many jobs, this one among
/// them, that process was running when it went. A crash is put down to a job that ran alone and had not come
/// further; when several ran, nobody knows whose it was, and each is tried by itself.
Recovery recover(const store::JobRow& job, bool further, int running);

}  // namespace toile::jobs
