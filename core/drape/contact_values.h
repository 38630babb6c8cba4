#pragma once
// Contacts in a checkpoint. Which vertices were measured when is a matter of history, so that the lists are
// kept whole.

#include <cstddef>

#include "core/base/state_bytes.h"
#include "core/collision/contacts.h"

namespace toile::drape {

/// m; no drape gets there.
inline constexpr double kFarthest = 1e6;

void contact_values(StateWriter& out, collision::Contacts& contacts);
void contact_values(StateReader& in, collision::Contacts& contacts);

/// True when the lists name only each other and vertices below `vertex_count`, with numbers that can be; or
/// when there are none at all.
bool sound_contacts(const collision::Contacts& contacts, std::size_t vertex_count);

}  // namespace toile::drape
