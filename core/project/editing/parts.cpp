#include "core/project/editing/parts.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/sewing/placement.h"

namespace toile::editing {
namespace {

using Ids = std::vector<std::string>;

bool has(const Ids& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

/// Whether the part has become one with another that keeps its own name.
bool is_joined(const edit::RenamedPart& part) { return part.now.size() == 1 && part.now[0] != part.was; }

/// The ids with those of `part` in the place of the one that was, none twice.
void rename(Ids& ids, const edit::RenamedPart& part) {
  Ids now;
  const auto add = [&](const std::string& id) {
    if (!has(now, id)) now.push_back(id);
  };
  for (const std::string& id : ids) {
    if (id != part.was) {
      add(id);
    } else {
      std::for_each(part.now.begin(), part.now.end(), add);
    }
  }
  ids = std::move(now);
}

/// Follows the names in the lists of `things` on the edited piece. What was on parts that are all gone goes;
/// what never named a part is on the whole piece, and stays.
template <typename Thing>
Status follow_names(std::vector<Thing>& things, Ids Thing::*ids, const edit::EditEffect& effect,
                    const char* kind) {
  for (const Thing& thing : things) {
    if (thing.piece != effect.was) continue;
    for (const edit::RenamedPart& part : effect.parts) {
      if (!is_joined(part) || has(thing.*ids, part.was) == has(thing.*ids, part.now[0])) continue;
      return Error{"edit.in_use",
                   "Of the two edges only one is held by this; let it hold both or none first.",
                   std::string(kind) + " " + thing.id};
    }
  }
  std::erase_if(things, [&](Thing& thing) {
    if (thing.piece != effect.was || (thing.*ids).empty()) return false;
    for (const edit::RenamedPart& part : effect.parts) rename(thing.*ids, part);
    return (thing.*ids).empty();
  });
  return {};
}

template <typename Thing>
void follow_piece(std::vector<Thing>& things, const edit::EditEffect& effect) {
  std::erase_if(things, [&](Thing& thing) {
    if (thing.piece != effect.was) return false;
    thing.piece = effect.piece;
    return effect.piece.empty();
  });
}

void follow_buttons(std::vector<project::ProjectButton>& buttons, const edit::EditEffect& effect) {
  const auto follow = [&](project::ProjectButtonPoint& point) {
    if (point.piece != effect.was) return;
    point.piece = effect.piece;
    if (effect.motion) point.at = edit::moved(point.at, *effect.motion);
  };
  for (project::ProjectButton& button : buttons) {
    follow(button.a);
    follow(button.b);
  }
  std::erase_if(buttons,
                [](const project::ProjectButton& b) { return b.a.piece.empty() || b.b.piece.empty(); });
}

void follow_points(std::vector<project::ProjectAttachment>& attachments, const edit::EditEffect& effect) {
  if (!effect.motion) return;
  for (project::ProjectAttachment& attachment : attachments) {
    if (attachment.piece != effect.was) continue;
    for (Vec2& at : attachment.points) at = edit::moved(at, *effect.motion);
  }
}

/// A cushion with a wall less is none.
void follow_cushions(std::vector<project::ProjectCushion>& cushions, const edit::EditEffect& effect) {
  for (project::ProjectCushion& cushion : cushions)
    std::replace(cushion.pieces.begin(), cushion.pieces.end(), effect.was, effect.piece);
  std::erase_if(cushions, [](const project::ProjectCushion& cushion) { return has(cushion.pieces, ""); });
}

template <typename T>
std::optional<ListSplice<T>> splice(const std::vector<T>& now, const std::vector<T>& wanted) {
  if (now == wanted) return std::nullopt;
  const std::size_t shorter = std::min(now.size(), wanted.size());
  std::size_t front = 0, back = 0;
  while (front < shorter && now[front] == wanted[front]) ++front;
  while (back < shorter - front && now[now.size() - 1 - back] == wanted[wanted.size() - 1 - back]) ++back;
  return ListSplice<T>{static_cast<int>(front), static_cast<int>(now.size() - front - back),
                       std::vector<T>(wanted.begin() + static_cast<std::ptrdiff_t>(front),
                                      wanted.end() - static_cast<std::ptrdiff_t>(back))};
}

template <typename T>
Status put_back(std::vector<T>& list, const std::optional<ListSplice<T>>& given, const char* name) {
  if (!given) return {};
  const auto size = static_cast<int>(list.size());
  if (given->at < 0 || given->remove < 0 || given->at > size || given->remove > size - given->at) {
    return Error{"edit.out_of_range", "the list has " + std::to_string(size) + " elements", name};
  }
  const auto at = list.erase(list.begin() + given->at, list.begin() + given->at + given->remove);
  list.insert(at, given->insert.begin(), given->insert.end());
  return {};
}

}  // namespace

Status follow_parts(project::Project& project, const edit::EditEffect& effect) {
  if (effect.was.empty()) return {};
  TRY(follow_names(project.attachments, &project::ProjectAttachment::edges, effect, "attachment"));
  TRY(follow_names(project.elastics, &project::ProjectElastic::lines, effect, "elastic"));
  TRY(follow_names(project.folds, &project::ProjectFold::lines, effect, "fold"));
  follow_points(project.attachments, effect);
  follow_piece(project.attachments, effect);
  follow_piece(project.elastics, effect);
  follow_piece(project.folds, effect);
  follow_buttons(project.buttons, effect);
  follow_cushions(project.cushions, effect);
  return {};
}

void stay_in_space(project::ProjectPiece& piece, Vec2 by) {
  if (piece.placement.wrapped) {
    piece.placement.wrapped->anchor = piece.placement.wrapped->anchor + by;
    return;
  }
  for (auto* anchor : {piece.placement.on_box ? &piece.placement.on_box->anchor : nullptr,
                       piece.placement.around ? &piece.placement.around->anchor : nullptr}) {
    if (anchor && *anchor) *anchor = **anchor + by;  // without an anchor the piece's middle stays where it is
  }
  if (!piece.placement.rigid) return;
  project::ProjectRigid& given = *piece.placement.rigid;
  sewing::RigidPlacement rigid;
  rigid.rotation = {radians_from_degrees(given.rotation.x), radians_from_degrees(given.rotation.y),
                    radians_from_degrees(given.rotation.z)};
  rigid.flipped = given.flipped;
  const Vec2 shift{metres_from_mm(by.x), metres_from_mm(by.y)};
  given.translation = given.translation - sewing::place({shift}, rigid).front();
}

RestoreLists difference(const project::Project& now, const project::Project& wanted) {
  return {splice(now.pieces, wanted.pieces),           splice(now.seams, wanted.seams),
          splice(now.attachments, wanted.attachments), splice(now.buttons, wanted.buttons),
          splice(now.elastics, wanted.elastics),       splice(now.folds, wanted.folds),
          splice(now.cushions, wanted.cushions),       splice(now.bodies, wanted.bodies)};
}

Status restore(project::Project& project, const RestoreLists& edit) {
  TRY(put_back(project.pieces, edit.pieces, "pieces"));
  TRY(put_back(project.seams, edit.seams, "seams"));
  TRY(put_back(project.attachments, edit.attachments, "attachments"));
  TRY(put_back(project.buttons, edit.buttons, "buttons"));
  TRY(put_back(project.elastics, edit.elastics, "elastics"));
  TRY(put_back(project.folds, edit.folds, "folds"));
  TRY(put_back(project.cushions, edit.cushions, "cushions"));
  return put_back(project.bodies, edit.bodies, "bodies");
}

}  // namespace toile::editing
