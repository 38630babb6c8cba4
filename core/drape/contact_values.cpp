#include "core/drape/contact_values.h"

#include <algorithm>
#include <cmath>

#include "core/base/crew.h"

namespace toile::drape {
namespace {

template <typename Archive>
void contact_value(Archive& a, collision::Contact& c) {
  a.value(c.count);
  for (Index& v : c.v) a.value(v);
  for (double& w : c.w) a.value(w);
  a.value(c.n);
  a.value(c.c);
  a.value(c.rest);
  a.value(c.friction);
  a.value(c.restitution);
  a.value(c.carried);
}
constexpr std::size_t kContactBytes = 5 * sizeof(Index) + 14 * sizeof(double);

template <typename Archive>
void fields(Archive& a, collision::Contacts& c) {
  constexpr std::size_t kLength = sizeof(std::uint32_t);
  a.value(c.centre);
  a.value(c.trust_radius);
  a.value(c.free_squared);
  a.list(c.pairs, 4 * sizeof(Index) + 1, [&](collision::ListedPair& pair) {
    for (Index& v : pair.v) a.value(v);
    a.value(pair.gone);
  });
  a.list(c.planes, kLength, [&](std::vector<collision::DivisionPlane>& of_vertex) {
    a.list(of_vertex, 4 * sizeof(double) + sizeof(Index), [&](collision::DivisionPlane& plane) {
      a.value(plane.n);
      a.value(plane.slack);
      a.value(plane.pair);
    });
  });
  a.list(c.vertex_contacts, kLength, [&](std::vector<collision::VertexContact>& of_vertex) {
    a.list(of_vertex, kContactBytes, [&](collision::VertexContact& near) {
      a.value(near.pair);
      a.value(near.gap);
      a.value(near.hidden);
      contact_value(a, near.contact);
    });
  });
  a.list(c.rims, kContactBytes, [&](collision::RimContact& rim) {
    a.value(rim.pair);
    contact_value(a, rim.contact);
  });
}

bool within(double value, double most) { return std::abs(value) <= most; }  // false for NaN
bool within(Vec3 v, double most) { return within(v.x, most) && within(v.y, most) && within(v.z, most); }

bool sound_contact(const collision::Contact& c, std::size_t vertex_count) {
  if (c.count < 1 || c.count > 4) return false;
  for (int k = 0; k < c.count; ++k) {
    if (c.v[k] < 0 || static_cast<std::size_t>(c.v[k]) >= vertex_count || !within(c.w[k], 2)) return false;
  }
  return within(c.n, 2) && within(c.c, 2 * kFarthest) && c.rest >= 0 && c.rest <= kFarthest &&
         within(c.friction, kFarthest) && within(c.restitution, kFarthest) && within(c.carried, kFarthest);
}

bool sound_pair(const collision::ListedPair& pair, std::size_t vertex_count) {
  return pair.v[0] != kNone && std::all_of(pair.v.begin(), pair.v.end(), [&](Index v) {
           return v == kNone || (v >= 0 && static_cast<std::size_t>(v) < vertex_count);
         });
}

}  // namespace

void contact_values(StateWriter& out, collision::Contacts& contacts) { fields(out, contacts); }

void contact_values(StateReader& in, collision::Contacts& contacts) {
  fields(in, contacts);
  // What is pushed apart follows from the lists; no vertex is marked, for its bounds were read.
  if (contacts.planes.size() != contacts.vertex_contacts.size()) return;
  Crew alone;
  contacts.follow(std::vector<char>(contacts.planes.size(), 0), alone);
}

bool sound_contacts(const collision::Contacts& c, std::size_t vertex_count) {
  const std::size_t n = c.centre.size();
  if (n != 0 && n != vertex_count) return false;
  if (c.trust_radius.size() != n || c.free_squared.size() != n || c.planes.size() != n ||
      c.vertex_contacts.size() != n) {
    return false;
  }
  const auto listed = [&](Index pair) {
    return pair >= 0 && static_cast<std::size_t>(pair) < c.pairs.size() && !c.pairs[pair].gone;
  };
  const auto sound_plane = [&](const collision::DivisionPlane& plane) {
    return listed(plane.pair) && within(plane.n, 2) && within(plane.slack, kFarthest);
  };
  const auto sound_entry = [&](const auto& entry) {
    return listed(entry.pair) && sound_contact(entry.contact, n);
  };
  return std::all_of(c.pairs.begin(), c.pairs.end(), [&](const auto& pair) { return sound_pair(pair, n); }) &&
         std::all_of(c.centre.begin(), c.centre.end(), [](Vec3 x) { return within(x, kFarthest); }) &&
         std::all_of(c.trust_radius.begin(), c.trust_radius.end(),
                     [](double r) { return r >= 0 && r <= kFarthest; }) &&
         std::all_of(c.free_squared.begin(), c.free_squared.end(),
                     [](double r) { return r >= -1 && r <= kFarthest; }) &&
         std::all_of(c.planes.begin(), c.planes.end(),
                     [&](const auto& list) { return std::all_of(list.begin(), list.end(), sound_plane); }) &&
         std::all_of(c.vertex_contacts.begin(), c.vertex_contacts.end(),
                     [&](const auto& list) { return std::all_of(list.begin(), list.end(), sound_entry); }) &&
         std::all_of(c.rims.begin(), c.rims.end(), sound_entry);
}

}  // namespace toile::drape
