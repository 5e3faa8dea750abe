// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/stored_histories.h"

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "comm.h"
#include "fix_contact_history.h"
#include "fix_mesh_surface.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/private_member.h"
#include "modify.h"
#include "primitive_wall.h"
#include "tri_mesh.h"

namespace plastigran {

using LAMMPS_NS::FixContactHistory;
using LAMMPS_NS::FixPropertyAtom;

namespace {

PRIVATE_MEMBER(PartnerCounts, FixContactHistory::npartner_);
PRIVATE_MEMBER(PartnerIds, FixContactHistory::partner_);

// Returns the double with the same bits as an integer, because LIGGGHTS stores integers in arrays
// of doubles in this way.
double as_double(std::int64_t number) {
  double same_bits;
  std::memcpy(&same_bits, &number, sizeof number);
  return same_bits;
}

// Prefixes in the IDs of LIGGGHTS' history fixes. The ID of the mesh or wall follows the prefix.
const char mesh_histories[] = "tracker_", primitive_histories[] = "history_";

// Returns the mesh or wall fix to which `histories` belongs; null if the ID of `histories` does not
// begin with `prefix`.
LAMMPS_NS::Fix* fix_of(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories,
                       const char* prefix) {
  const std::size_t length = std::strlen(prefix);
  if (std::strncmp(histories->id, prefix, length) != 0) return nullptr;
  return engine->modify->find_fix_id(histories->id + length);
}

std::uint64_t hash_of(std::uint64_t sum, double number) {
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  sum = (sum ^ bits) * 1099511628211u;
  return sum ^ sum >> 32;
}

}  // namespace

StoredHistories::StoredHistories(LAMMPS_NS::Fix* fix)
    : fix_(fix),
      has_partners_(std::strncmp(fix->style, "contacthistory", 14) == 0),
      of_pairs_(std::strcmp(fix->style, "contacthistory") == 0) {}

int StoredHistories::width() const {
  return has_partners_ ? static_cast<FixContactHistory*>(fix_)->get_dnum()
                       : static_cast<FixPropertyAtom*>(fix_)->get_nvalues();
}

std::size_t StoredHistories::size_of(int i) const {
  if (!has_partners_) return width();
  return 1 + static_cast<FixContactHistory*>(fix_)->n_partner(i) * (1 + width());
}

std::vector<double> StoredHistories::of(int i) const {
  std::vector<double> values;
  if (!has_partners_) {
    values.resize(width());
    fix_->pack_exchange(i, values.data());
    return values;
  }
  FixContactHistory* const list = static_cast<FixContactHistory*>(fix_);
  values.push_back(list->n_partner(i));
  for (int k = 0; k < list->n_partner(i); ++k) {
    values.push_back(list->partner(i, k));
    const double* const history = list->contacthistory(i, k);
    values.insert(values.end(), history, history + width());
  }
  return values;
}

void StoredHistories::replace_partner_ids(int count, const NewIds& ids) {
  if (!of_pairs_) return;
  FixContactHistory* const list = static_cast<FixContactHistory*>(fix_);
  for (int i = 0; i < count; ++i) {
    int* const partners = (list->*member_of(PartnerIds()))[i];
    int kept = 0;
    for (int k = 0; k < list->n_partner(i); ++k)
      if (const int id = ids.of(partners[k])) {
        partners[kept] = id;
        std::copy_n(list->contacthistory(i, k), width(), list->contacthistory(i, kept++));
      }
    (list->*member_of(PartnerCounts()))[i] = kept;
  }
}

void StoredHistories::set(int i, const double* values, int count) {
  std::vector<double> packed(values, values + count);
  if (has_partners_)
    for (int k = 0; k < count; k += k ? 1 + width() : 1)
      packed[k] = as_double(static_cast<std::int64_t>(packed[k]));
  fix_->unpack_exchange(i, packed.data());
}

void StoredHistories::clear(int i) {
  std::vector<double> nothing(has_partners_ ? 1 : width(), 0);
  fix_->unpack_exchange(i, nothing.data());
}

bool StoredHistories::Layout::any(const double* values, int count) const {
  for (int k = has_partners ? 2 : 0; k + width <= count; k += 1 + width)
    if (std::any_of(values + k, values + k + width, [](double value) { return value != 0; }))
      return true;
  return false;
}

int StoredHistories::Layout::replace_partner_ids(double* values, int count,
                                                 const NewIds& ids) const {
  if (!has_particles) return count;
  double* end = values + 1;
  for (double* contact = values + 1; contact < values + count; contact += 1 + width)
    if (const int id = ids.of(static_cast<int>(*contact))) {
      *contact = id;
      end = std::copy_n(contact, 1 + width, end);
    }
  values[0] = static_cast<double>((end - values - 1) / (1 + width));
  return static_cast<int>(end - values);
}

std::uint64_t primitive_wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories) {
  const auto wall =
      dynamic_cast<LAMMPS_NS::FixWallGran*>(fix_of(engine, histories, primitive_histories));
  if (!wall) return 0;
  std::uint64_t sum = 1;
  for (const double number : geometry(wall->primitiveWall())) sum = hash_of(sum, number);
  return sum;
}

std::uint64_t wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories) {
  if (const std::uint64_t position = primitive_wall_position(engine, histories)) return position;
  const auto fix =
      dynamic_cast<LAMMPS_NS::FixMeshSurface*>(fix_of(engine, histories, mesh_histories));
  if (!fix) return 0;
  LAMMPS_NS::TriMesh* const mesh = fix->triMesh();
  std::uint64_t sum = 0;  // a sum, because the order of triangles depends on the number of ranks
  const bool is_distributed = mesh->isParallel();  // if false, each rank has all triangles
  for (int triangle = 0; triangle < mesh->sizeLocal(); ++triangle) {
    if (!is_distributed && engine->comm->me != 0) break;
    std::uint64_t of_triangle = mesh->id(triangle) + 1;
    for (int node = 0; node < 3; ++node) {
      double x[3];
      mesh->node(triangle, node, x);
      for (const double coordinate : x) of_triangle = hash_of(of_triangle, coordinate);
    }
    sum += of_triangle;
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, engine->world);
  return sum;
}

}  // namespace plastigran
