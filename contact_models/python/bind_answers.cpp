// SPDX-License-Identifier: GPL-2.0-or-later
//
// Python bindings of Response and ImpactOutcome.
#include "answers.h"
#include "bind.h"
#include "values.h"

namespace plastigran {

const std::array<AnswerField<Response>, 6> AnswerFields<Response>::all{{
    {"force", &Response::force, nullptr,
     "Normal force, negative where the bodies attract each other [N]."},
    {"contact_radius", &Response::contact_radius, nullptr,
     "Contact radius; half-width of a line contact [m]."},
    {"elastic_energy", &Response::elastic_energy, nullptr,
     "Elastic energy, which unloading would release [J]."},
    {"plastic_work", &Response::plastic_work, nullptr,
     "Energy dissipated by plastic flow since first touch [J]."},
    {"viscous_force", &Response::viscous_force, nullptr,
     "Part of the force that depends on the overlap rate, negative during separation [N]."},
    {"surface_energy", &Response::surface_energy, nullptr,
     "Surface energy relative to separated bodies, never positive; 0 without adhesion [J]."},
}};

const std::array<AnswerField<ImpactOutcome>, 7> AnswerFields<ImpactOutcome>::all{{
    {"overlap_max", &ImpactOutcome::overlap_max, nullptr, "Largest overlap [m]."},
    {"force_max", &ImpactOutcome::force_max, nullptr, "Largest force [N]."},
    {"overlap_res", &ImpactOutcome::overlap_res, nullptr,
     "Residual overlap, at which the force vanishes during unloading [m]."},
    {"coefficient_of_restitution", &ImpactOutcome::coefficient_of_restitution, nullptr,
     "Coefficient of restitution: rebound speed/impact speed [-]; 0 if the bodies stick."},
    {"stiffness_max", &ImpactOutcome::stiffness_max, nullptr,
     "Largest derivative of force with respect to overlap [N/m]."},
    {"damping_max", &ImpactOutcome::damping_max, nullptr,
     "Derivative of force with respect to overlap rate at the largest overlap [N s/m]."},
    {"in_range", nullptr, &ImpactOutcome::in_range,
     "Whether the largest overlap is in the validity range of the law."},
}};

const std::array<AnswerField<PlaneResponse>, 4> AnswerFields<PlaneResponse>::all{{
    {"force_x", &PlaneResponse::force_x, nullptr,
     "Tangential force along x, which the first body exerts on the second [N]."},
    {"force_y", &PlaneResponse::force_y, nullptr,
     "Tangential force along y, which the first body exerts on the second [N]."},
    {"stored_energy", &PlaneResponse::stored_energy, nullptr,
     "Energy stored in the tangential deformation [J]."},
    {"friction_work", &PlaneResponse::friction_work, nullptr,
     "Energy dissipated by friction in the step [J]."},
}};

namespace {

template <class Record>
void bind_answer(nb::module_& module, const char* name, const char* meaning) {
  typedef Answer<Record> Self;
  const auto& fields = AnswerFields<Record>::all;
  nb::class_<Self> type(module, name, meaning);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string signature = std::string("def ") + fields[k].name + "(self) -> " +
                                  (fields[k].number ? "Numbers" : "bool | NDArray[numpy.bool]");
    type.def_prop_ro(
        fields[k].name, [k](const Self& self) { return self.values[k]; },
        nb::for_getter(nb::sig(signature.c_str())), fields[k].meaning);
  }
  bind_values(
      type,
      [](const Self& self) {
        nb::dict values;
        for (std::size_t k = 0; k < self.values.size(); ++k)
          values[AnswerFields<Record>::all[k].name] = self.values[k];
        return values;
      },
      [](Self* memory, const nb::dict& values) {
        Self* const self = new (memory) Self();
        for (const auto& field : AnswerFields<Record>::all)
          self->values.push_back(values[field.name]);
      },
      false);
}

}  // namespace

void bind_answers(nb::module_& module) {
  bind_answer<Response>(
      module, "Response",
      "Response of a law. Fields have the broadcast shape of the arguments. Immutable.");
  bind_answer<ImpactOutcome>(
      module, "ImpactOutcome",
      "Outcome of a central impact. Fields have the broadcast shape of the arguments. Immutable.");
  bind_answer<PlaneResponse>(
      module, "TangentialResponse",
      "Response of a tangential law. Fields have the broadcast shape of the arguments. Immutable.");
}

}  // namespace plastigran
