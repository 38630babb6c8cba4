#pragma once
// Who has a store open, so that others on this machine see at once when somebody is no more.

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace toile::store {

/// A name that leases are held under. Its file is locked for as long as this lives; the system lets go when
/// the process dies, however it dies.
class Holder {
 public:
  /// Makes a name in `folder` (a store's) that nobody has had. Error: store.open.
  static Result<Holder> join(const std::filesystem::path& folder);
  Holder(Holder&& other) noexcept;
  Holder& operator=(Holder&&) = delete;
  ~Holder();

  const std::string& id() const { return id_; }
  /// Whether nobody has that name any more; whoever it is that hangs is still there.
  bool is_gone(const std::string& id) const;
  /// Removes what those who are gone have left.
  void sweep() const;

 private:
  Holder() = default;
  std::filesystem::path folder_;
  std::string id_;
  int fd_ = -1;
};

}  // namespace toile::store
