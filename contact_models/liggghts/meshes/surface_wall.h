// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' wall with the setting `feature_angle` for meshes. Triangles that share an edge or a
// node and differ in direction by at most this angle form one surface. A particle has one contact
// with a surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "fix_wall_gran_base.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/meshes/mesh_contacts.h"

namespace plastigran {

template <class Contact>
class SurfaceWall : public LIGGGHTS::Walls::Granular<Contact> {
  typedef LIGGGHTS::Walls::Granular<Contact> Base;

 public:
  SurfaceWall(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::FixWallGran* wall, int64_t hash)
      : Base(engine, wall, hash), engine_(engine), wall_(wall) {}

  // Reads feature_angle and passes the other settings to the contact models.
  void settings(int count, char** words, LIGGGHTS::IContactHistorySetup* owner) override {
    std::vector<char*> others;
    for (int k = 0; k < count; k += 2) {
      if (std::strcmp(words[k], "feature_angle") == 0 && k + 1 < count)
        set_feature_angle(words[k + 1]);
      else
        others.insert(others.end(), words + k, words + std::min(k + 2, count));
    }
    Base::settings(others.size(), others.data(), owner);
  }

  // Sets the property `curvature` of the meshes to about zero. LIGGGHTS sets up the meshes after
  // the first call of this function, and removes edges that bend by less than `curvature`. A
  // particle on the convex side of a removed edge would have no contact.
  void init_granular() override {
    Base::init_granular();
    if (feature_angle_ == 0 || !wall_->is_mesh_wall()) return;
    for (int k = meshes_.size(); k < wall_->n_meshes(); ++k) {
      LAMMPS_NS::FixMeshSurface* const mesh = wall_->mesh_list()[k];
      if (!std::strstr(mesh->style, "planar")) mesh->triMesh()->setCurvature(1 - 1e-12);
      meshes_.emplace_back(engine_, mesh, std::cos(feature_angle_ * M_PI / 180), spring_offsets(),
                           this->get_history_offset("in_contact"));
    }
    MeshCheck* const check = ensure_fix<MeshCheck>(engine_);
    for (MeshContacts& mesh : meshes_) mesh.begin_run(check);
  }

  void compute_force(LAMMPS_NS::FixWallGran* wall,
                     LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool overlaps,
                     double* velocity, LAMMPS_NS::FixMeshSurface* fix, int index,
                     LAMMPS_NS::TriMesh* mesh, int triangle) override {
    double* const history = wall->dnum() > 0 ? contact.contact_history : nullptr;
    if (meshes_.empty() || meshes_[index].computes(contact.i, triangle, history))
      Base::compute_force(wall, contact, overlaps, velocity, fix, index, mesh, triangle);
    else if (wall->addflag() && wall->compute_wall_gran_local())
      list_without_force(wall, contact, velocity, index, mesh->id(triangle));
  }

 private:
  void set_feature_angle(const char* word) {
    feature_angle_ = engine_->force->numeric(FLERR, word);
    if (!wall_->is_mesh_wall())
      engine_->error->fix_error(FLERR, wall_,
                                "feature_angle is supported only for mesh walls. Remove it");
    if (!(feature_angle_ >= 0 && feature_angle_ <= 90))
      engine_->error->fix_error(
          FLERR, wall_,
          (std::string("feature_angle is ") + word + "; it must be from 0 to 90 degrees").c_str());
  }

  // Returns the offsets of tangential and rolling springs in the contact history.
  std::vector<int> spring_offsets() {
    std::vector<int> offsets;
    for (const char* first : {"shearx", "r_torquex_old"}) {
      const int offset = this->get_history_offset(first);
      if (offset >= 0) offsets.push_back(offset);
    }
    return offsets;
  }

  // Adds an overlap with zero force to the list of compute wall/gran/local, because this list
  // contains all overlaps.
  void list_without_force(LAMMPS_NS::FixWallGran* wall,
                          LIGGGHTS::ContactModels::SurfacesIntersectData& contact, double* velocity,
                          int index, int id) {
    double point[3], normal[3];
    vectorSubtract3D(engine_->atom->x[contact.i], contact.delta, point);
    vectorScalarMult3D(contact.delta, -1 / vectorMag3D(contact.delta), normal);
    const double r = contact.radi - contact.deltan;
    const auto compute = wall->compute_wall_gran_local();
    compute->add_wall_1(index, id, contact.i, point, velocity);
    compute->add_wall_2(contact.i, 0, 0, 0, 0, 0, 0, contact.contact_history, r * r, normal);
  }

  LAMMPS_NS::LAMMPS* engine_;
  LAMMPS_NS::FixWallGran* wall_;
  double feature_angle_ = 30;  // degrees; 0: one contact per triangle, as in LIGGGHTS
  std::vector<MeshContacts> meshes_;
};

}  // namespace plastigran
