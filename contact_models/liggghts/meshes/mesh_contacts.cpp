// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/meshes/mesh_contacts.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "fix_contact_history_mesh.h"
#include "fix_neighlist_mesh.h"
#include "liggghts/meshes/fold.h"
#include "neighbor.h"
#include "tri_mesh.h"
#include "update.h"
#include "vector_liggghts.h"

namespace plastigran {

namespace {

// Overlap depths that differ by less than this fraction of the radius count as equal. Of equal
// depths, the contact with a history is preferred: at an edge between coplanar triangles, LIGGGHTS
// may compute only this contact.
const double same_depth = 1e-11;

// Tolerance of a cosine, because the coordinates of corners in mesh files have about seven digits.
const double rounding = 1e-6;

// Two contacts are on opposite sides of a particle if the cosine of the angle between their
// directions is below this value.
const double opposite = 0.5;

// Rotates `vector` by the smallest rotation from the direction `from` to the direction `to`. Does
// nothing if the two are opposite or one of them is zero.
void rotate(const double* from, const double* to, double* vector) {
  const double lengths = vectorMag3D(from) * vectorMag3D(to);
  const double cosine = vectorDot3D(from, to) / lengths;
  if (!(lengths > 0 && cosine > -1)) return;
  double axis[3], once[3], twice[3];
  vectorCross3D(from, to, axis);
  vectorScalarDiv3D(axis, lengths);
  vectorCross3D(axis, vector, once);
  vectorCross3D(axis, once, twice);
  for (int k = 0; k < 3; ++k) vector[k] += once[k] + twice[k] / (1 + cosine);
}

double cosine_between(const double* a, const double* b) {
  return vectorDot3D(a, b) / (vectorMag3D(a) * vectorMag3D(b));
}

}  // namespace

MeshContacts::MeshContacts(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::FixMeshSurface* mesh,
                           double feature_cosine, std::vector<int> springs, int in_contact)
    : engine_(engine),
      fix_(mesh),
      mesh_(mesh->triMesh()),
      feature_cosine_(feature_cosine - rounding),
      springs_(std::move(springs)),
      in_contact_(in_contact) {}

bool MeshContacts::computes(int particle, int triangle, double* history) {
  const auto [first, last] = overlaps_of(particle);
  const auto begin = overlaps_.begin() + first, end = overlaps_.begin() + last;
  const auto overlap =
      std::find_if(begin, end, [&](const Overlap& o) { return o.triangle == triangle; });
  if (overlap != end && overlap->carries) {
    if (overlap->history) take_over(particle, *overlap, history);
    return true;
  }
  if (!history) return overlap == end;
  const bool will_move =
      std::any_of(begin, end, [&](const Overlap& o) { return o.history == history; });
  if (will_move) return false;
  if (overlap == end && in_contact_ < 0) return true;
  // Clear the history: LIGGGHTS copies histories between coplanar triangles, and a copy must not
  // act as a second contact.
  std::fill_n(history, fix_->contactHistory()->get_dnum(), 0.0);
  return false;
}

std::pair<int, int> MeshContacts::overlaps_of(int particle) {
  const LAMMPS_NS::bigint step = engine_->update->ntimestep, listed = engine_->neighbor->lastcall;
  const std::size_t count = engine_->atom->nlocal;
  if (step != contact_step_ || spans_.size() != count) {
    if (listed != list_step_ || spans_.size() != count) list_triangles();
    list_step_ = listed;
    spans_.assign(count, {-1, -1});
    overlaps_.clear();
    contact_step_ = step;
  }
  if (spans_[particle].first < 0) {
    const int first = overlaps_.size();
    find_overlaps(particle);
    join_surfaces(particle, first);
    add_nearer_triangles(particle, first);
    choose_carriers(particle, first);
    find_histories(particle, first);
    if (!check_->seen(MeshCheck::seam)) look_for_seam(particle, first);
    if (!check_->seen(MeshCheck::ring)) look_for_ring(particle, first);
    spans_[particle] = {first, static_cast<int>(overlaps_.size())};
  }
  return spans_[particle];
}

void MeshContacts::list_triangles() {
  LAMMPS_NS::FixNeighlistMesh* const lists = fix_->meshNeighlist();
  const int count = engine_->atom->nlocal, triangles = mesh_->sizeLocal() + mesh_->sizeGhost();
  first_near_.assign(count + 1, 0);
  for (int triangle = 0; triangle < triangles; ++triangle)
    for (int particle : lists->get_contact_list(triangle))
      if (particle < count) ++first_near_[particle + 1];
  for (int i = 0; i < count; ++i) first_near_[i + 1] += first_near_[i];
  near_.resize(first_near_[count]);
  std::vector<int> next(first_near_.begin(), first_near_.end() - 1);
  for (int triangle = 0; triangle < triangles; ++triangle)
    for (int particle : lists->get_contact_list(triangle))
      if (particle < count) near_[next[particle]++] = triangle;
}

void MeshContacts::find_overlaps(int particle) {
  const double reach = reach_of(particle);
  double to_foot[3];
  for (int k = first_near_[particle]; k < first_near_[particle + 1]; ++k) {
    if (beyond_its_plane(particle, near_[k])) continue;
    const double gap = distance(particle, near_[k], false, to_foot);
    if (gap <= 0 || (gap < reach && is_stretched(particle, near_[k])))
      add(particle, near_[k], gap, to_foot, overlaps_.size());
  }
}

void MeshContacts::add(int particle, int triangle, double gap, const double* to_foot, int surface) {
  const bool has_history = slot_of(particle, triangle) >= 0;
  overlaps_.push_back({triangle, {}, -gap, has_history, surface, false, nullptr, -1});
  vectorCopy3D(to_foot, overlaps_.back().to_foot);
}

void MeshContacts::join_surfaces(int particle, int first) {
  const int last = overlaps_.size();
  for (int a = first; a < last; ++a)
    for (int b = a + 1; b < last; ++b) {
      const auto [kept, joined] = std::minmax(overlaps_[a].surface, overlaps_[b].surface);
      const int surface = kept, other = joined;
      if (surface == other || !meet_as_one(particle, overlaps_[a].triangle, overlaps_[b].triangle))
        continue;
      for (int k = first; k < last; ++k)
        if (overlaps_[k].surface == other) overlaps_[k].surface = surface;
    }
}

// Moves an adhesive contact at negative overlap along its surface to the nearest triangle. If the
// particle overlaps no triangle of a surface, adds neighboring triangles of the surface that are
// nearer than those already listed.
void MeshContacts::add_nearer_triangles(int particle, int first) {
  if (in_contact_ < 0) return;
  const double tolerance = same_depth * engine_->atom->radius[particle];
  double to_foot[3];
  for (std::size_t k = first; k < overlaps_.size(); ++k) {
    const Overlap from = overlaps_[k];
    const auto is_overlapped = [&](const Overlap& o) {
      return o.surface == from.surface && o.depth >= 0;
    };
    if (std::any_of(overlaps_.begin() + first, overlaps_.end(), is_overlapped)) continue;
    for (int n = first_near_[particle]; n < first_near_[particle + 1]; ++n) {
      const int triangle = near_[n];
      const auto is_added = [&](const Overlap& o) { return o.triangle == triangle; };
      if (beyond_its_plane(particle, triangle) ||
          std::any_of(overlaps_.begin() + first, overlaps_.end(), is_added))
        continue;
      const double gap = distance(particle, triangle, false, to_foot);
      if (-gap >= from.depth - tolerance && meet_as_one(particle, from.triangle, triangle))
        add(particle, triangle, gap, to_foot, from.surface);
    }
  }
}

// Returns whether two triangles form one surface for this particle. A shared node suffices, because
// the particle may not reach the triangles between them.
bool MeshContacts::meet_as_one(int particle, int a, int b) const {
  return one_surface(*mesh_, a, b, engine_->atom->x[particle], feature_cosine_) ||
         around_a_node(*mesh_, a, b, feature_cosine_);
}

void MeshContacts::choose_carriers(int particle, int first) {
  const double tolerance = same_depth * engine_->atom->radius[particle];
  const double reach = reach_of(particle);
  const int last = overlaps_.size();
  double to_foot[3];
  for (int k = first; k < last && last - first > 1; ++k)
    overlaps_[k].depth = -distance(particle, overlaps_[k].triangle, true, to_foot);
  for (int surface = first; surface < last; ++surface) {
    Overlap* deepest = nullptr;
    for (int k = surface; k < last; ++k) {
      Overlap& overlap = overlaps_[k];
      if (overlap.surface != surface || overlap.depth < -reach) continue;
      const double deeper = deepest ? overlap.depth - deepest->depth : overlap.depth;
      if (!deepest || deeper > tolerance ||
          (deeper >= -tolerance && overlap.has_history && !deepest->has_history))
        deepest = &overlap;
    }
    if (deepest) deepest->carries = true;
  }
}

// Reports a seam: contacts with two surfaces whose directions differ by less than the feature
// angle.
void MeshContacts::look_for_seam(int particle, int first) const {
  const int last = overlaps_.size();
  for (int a = first; a < last; ++a)
    for (int b = a + 1; b < last; ++b)
      if (overlaps_[a].carries && overlaps_[b].carries &&
          cosine_between(overlaps_[a].to_foot, overlaps_[b].to_foot) >= feature_cosine_)
        return check_->note(MeshCheck::seam, place(particle, overlaps_[a], overlaps_[b]));
}

// Reports a ring: triangles of one surface on opposite sides of the particle.
void MeshContacts::look_for_ring(int particle, int first) const {
  const int last = overlaps_.size();
  for (int a = first; a < last; ++a)
    for (int b = first; overlaps_[a].carries && b < last; ++b)
      if (a != b && overlaps_[a].surface == overlaps_[b].surface &&
          cosine_between(overlaps_[a].to_foot, overlaps_[b].to_foot) < opposite)
        return check_->note(MeshCheck::ring, place(particle, overlaps_[a], overlaps_[b]));
}

MeshCheck::Place MeshContacts::place(int particle, const Overlap& a, const Overlap& b) const {
  const double* const x = engine_->atom->x[particle];
  const double cosine = std::min(1.0, cosine_between(a.to_foot, b.to_foot));
  return {engine_->atom->tag[particle],
          {mesh_->id(a.triangle), mesh_->id(b.triangle)},
          {x[0], x[1], x[2]},
          std::acos(cosine) * 180 / M_PI};
}

// Assigns the histories of a particle's contacts to the overlaps that now have these contacts. If
// two surfaces have joined, keeps the history of the deepest triangle, or the first history if the
// deepest triangle has none.
void MeshContacts::find_histories(int particle, int first) {
  LAMMPS_NS::FixContactHistoryMesh* const stored = fix_->contactHistory();
  if (!stored || stored->get_dnum() == 0) return;
  for (int slot = 0; slot < stored->nneighs(particle); ++slot) {
    const int id = stored->partner(particle, slot);
    double* const history = id < 0 ? nullptr : stored->contacthistory(particle, slot);
    if (!history || !any(history)) continue;
    const auto end = near_.begin() + first_near_[particle + 1];
    const auto former = std::find_if(near_.begin() + first_near_[particle], end,
                                     [&](int triangle) { return mesh_->id(triangle) == id; });
    Overlap* const heir = former == end ? nullptr : heir_of(particle, first, *former);
    if (!heir) continue;
    double* lost = history;
    if (!heir->history || heir->triangle == *former) {
      lost = heir->history;
      heir->history = history;
      heir->former = *former;
    }
    if (lost) std::fill_n(lost, stored->get_dnum(), 0.0);
  }
}

// Returns the overlap that now has the contact with the surface of `triangle`; null if the particle
// has left this surface.
MeshContacts::Overlap* MeshContacts::heir_of(int particle, int first, int triangle) {
  const double* const centre = engine_->atom->x[particle];
  const auto begin = overlaps_.begin() + first, end = overlaps_.end();
  auto same = std::find_if(begin, end, [&](const Overlap& o) { return o.triangle == triangle; });
  if (same == end)
    same = std::find_if(begin, end, [&](const Overlap& o) {
      return one_surface(*mesh_, o.triangle, triangle, centre, feature_cosine_);
    });
  if (same == end)
    same = std::find_if(begin, end, [&](const Overlap& o) {
      return around_a_node(*mesh_, o.triangle, triangle, feature_cosine_);
    });
  if (same == end) return nullptr;
  const auto heir = std::find_if(
      begin, end, [&](const Overlap& o) { return o.carries && o.surface == same->surface; });
  return heir == end ? nullptr : &*heir;
}

// Moves the history of the surface to `history`, and rotates its springs to the new contact
// direction.
void MeshContacts::take_over(int particle, Overlap& overlap, double* history) const {
  double* const former_history = std::exchange(overlap.history, nullptr);
  if (former_history == history) return;
  const int width = fix_->contactHistory()->get_dnum();
  std::copy_n(former_history, width, history);
  std::fill_n(former_history, width, 0.0);
  double before[3], now[3];
  distance(particle, overlap.former, false, before);
  distance(particle, overlap.triangle, false, now);
  for (int offset : springs_) rotate(before, now, history + offset);
}

// Returns the largest gap at which LIGGGHTS still computes a contact [m]; 0 if contacts end with
// the overlap.
double MeshContacts::reach_of(int particle) const {
  if (in_contact_ < 0) return 0;
  return (engine_->neighbor->contactDistanceFactor - 1) * engine_->atom->radius[particle];
}

bool MeshContacts::is_stretched(int particle, int triangle) const {
  const int slot = slot_of(particle, triangle);
  return slot >= 0 && fix_->contactHistory()->contacthistory(particle, slot)[in_contact_] != 0;
}

// Returns whether the particle is too far from the plane of the triangle to touch it. This fast
// test excludes most triangles.
bool MeshContacts::beyond_its_plane(int particle, int triangle) const {
  double node[3], normal[3], to_centre[3];
  mesh_->node(triangle, 0, node);
  mesh_->surfaceNorm(triangle, normal);
  vectorSubtract3D(engine_->atom->x[particle], node, to_centre);
  return std::abs(vectorDot3D(to_centre, normal)) >
         engine_->atom->radius[particle] + reach_of(particle);
}

// Returns the distance from the particle's surface to the triangle [m], negative for an overlap.
// `to_foot` becomes the vector from the particle center to the nearest point. With `as_liggghts`,
// the distance is positive at edges and corners that LIGGGHTS assigns to another triangle.
double MeshContacts::distance(int particle, int triangle, bool as_liggghts, double* to_foot) const {
  double weights[3];
  int region;
  return mesh_->resolveTriSphereContactBary(particle, triangle, engine_->atom->radius[particle],
                                            engine_->atom->x[particle], to_foot, weights, region,
                                            as_liggghts);
}

bool MeshContacts::any(const double* history) const {
  return std::any_of(history, history + fix_->contactHistory()->get_dnum(),
                     [](double value) { return value != 0; });
}

int MeshContacts::slot_of(int particle, int triangle) const {
  LAMMPS_NS::FixContactHistoryMesh* const stored = fix_->contactHistory();
  for (int slot = 0; stored && slot < stored->nneighs(particle); ++slot)
    if (stored->partner(particle, slot) == mesh_->id(triangle)) return slot;
  return -1;
}

}  // namespace plastigran
