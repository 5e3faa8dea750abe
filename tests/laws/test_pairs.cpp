// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tests of the table of pairs of atom types, used as a host uses it.
#include <doctest/doctest.h>

#include <string>

#include "plastigran/laws/brake_2015.h"
#include "plastigran/laws/kogut_etsion.h"
#include "plastigran/laws/lim_stronge.h"
#include "plastigran/laws/thornton.h"
#include "plastigran/laws/universal.h"
#include "plastigran/laws/vu_quoc_zhang.h"
#include "plastigran/pairs/impact_forecast.h"
#include "plastigran/pairs/impact_times.h"
#include "plastigran/pairs/range_account.h"
#include "plastigran/pairs/type_pairs.h"

using namespace plastigran;

namespace {

const Body aluminium{7e10, 0.3, 1e8, 1.61}, steel{2.1e11, 0.3, 3e8}, elastic{5e9, 0.2};

// Returns the bodies of three types: aluminum, steel, and a body that never yields.
Materials three_types() {
  Materials materials;
  materials.bodies = {aluminium, steel, elastic};
  return materials;
}

template <class Law>
TypePairs<Law> table(const Materials& materials) {
  TypePairs<Law> pairs;
  const Complaint complaint = pairs.build(materials, typename Law::Parameters());
  REQUIRE(complaint.text() == "");
  return pairs;
}

template <class Law>
std::string complaint_of(const Materials& materials) {
  TypePairs<Law> pairs;
  return pairs.build(materials, typename Law::Parameters()).text();
}

}  // namespace

TEST_CASE("a pair has the law of its two bodies, in either order") {
  TypePairs<Thornton> pairs = table<Thornton>(three_types());
  CHECK(pairs.type_count() == 3);
  const Thornton expected(combine(aluminium, steel), {});
  for (TypePair<Thornton>* pair : {&pairs(1, 2), &pairs(2, 1)}) {
    Thornton::State state, state_expected;
    CHECK(pair->law.respond(0.01, 1e-5, state).force ==
          expected.respond(0.01, 1e-5, state_expected).force);
  }
  CHECK(&pairs(1, 2) == &pairs(2, 1));
  CHECK(&pairs(1, 1) != &pairs(2, 2));
}

// A Meeting contains two atom types, R* [m], m* [kg] and the relative speed [m/s].
TEST_CASE("a law that yields refuses a contact of two bodies that never yield") {
  TypePairs<Thornton> pairs = table<Thornton>(three_types());
  CHECK(pairs(1, 3).refusal.empty());
  CHECK(pairs(3, 3).refusal.text() ==
        "yield_strength is missing. At least one of the bodies needs it, positive and finite "
        "[Pa] (atom types 3 and 3)");
  const auto refused = [&](const std::vector<Meeting>& meetings) {
    return !refusal(meetings, {}, pairs).empty();
  };
  CHECK_FALSE(refused({{1, 3, 0.01, 0.1, 0.1}}));
  CHECK(refused({{1, 3, 0.01, 0.1, 0.1}, {3, 3, 0.01, 0.1, 0}}));
}

TEST_CASE("a bad constant of a body is named with its type") {
  Materials materials = three_types();
  materials.bodies[1].poissons_ratio = 0.7;
  CHECK(complaint_of<Thornton>(materials) ==
        "poissons_ratio is 0.7; it must be above -1 and at most 0.5 [-] (atom type 2)");
}

TEST_CASE("a constant of a pair of types is mixed, checked and described by pair") {
  Materials materials = three_types();
  materials.bodies.pop_back();
  materials.constants["curvature_coefficient"] = {0.01, 0.9, 0.9, 0.02};
  materials.given = {"curvature_coefficient"};
  TypePairs<VuQuocZhang> pairs = table<VuQuocZhang>(materials);
  CHECK(pairs(1, 1).constants.curvature_coefficient == 0.01);
  CHECK(pairs(2, 2).constants.curvature_coefficient == 0.02);
  CHECK(pairs(1, 1).refusal.empty());
  const std::string reason = pairs(2, 1).refusal.text();
  CHECK(reason.find("or the contact might create energy (atom types 1 and 2)") !=
        std::string::npos);
  const auto same = [](const std::string& word) { return word; };
  const std::string text = pairs.describe("law", {same, same}, {}, " (default)");
  CHECK(text.find("law, atom types 1 and 1: effective modulus 3.84615e+10 Pa") == 0);
  CHECK(text.find("contact_radius_coefficient 0.0258303 (default), curvature_coefficient 0.01\n") !=
        std::string::npos);
  CHECK(text.find("1 and 2") == std::string::npos);
}

TEST_CASE("a constant of bodies is the larger of two, and refused where neither has it") {
  Materials materials = three_types();
  materials.constants["cylinder_length"] = {0.5, 0.2, 0};
  materials.constants["body_thickness"] = {1, 0, 0};
  TypePairs<LimStronge> pairs = table<LimStronge>(materials);
  CHECK(pairs(1, 2).constants.cylinder_length == 0.5);
  CHECK(pairs(1, 2).refusal.empty());
  CHECK(pairs(2, 2).lacking);
  CHECK(pairs(2, 2).refusal.text().find("body_thickness is 0; it must be between") == 0);
  CHECK(refusal({}, {{2, 2}}, pairs).empty());  // the types may never meet
  CHECK_FALSE(refusal({{2, 2, 0.01, 0.1, 0.1}}, {}, pairs).empty());
  materials.constants["cylinder_length"] = {0.5, -1, 0};
  CHECK(complaint_of<LimStronge>(materials).find("cylinder_length is -1; it must be between") == 0);
}

// Kogut & Etsion's law is valid up to 110 times the overlap at yield. A contact that exceeds this
// limit counts once.
TEST_CASE("a contact is counted where it leaves the range for the first time") {
  TypePairs<KogutEtsion> pairs = table<KogutEtsion>(three_types());
  const TypePair<KogutEtsion>& pair = pairs(1, 1);
  RangeAccount account;
  KogutEtsion::State state;
  for (const double depth : {0.5, 0.9, 1.1, 1.3, 0.4, 1.2, 1.4}) {  // overlap / range
    const double overlap = depth * pair.range * 0.01, closing = 0.2 * pair.range * 0.01;
    const KogutEtsion::State before = state;
    pair.law.respond(0.01, overlap, state);
    if (depth > 1)
      account.add(pair.law, pair.range, {0.01, overlap, closing, before, state, false, 1});
  }
  CHECK(account.contacts == 1);
  CHECK(account.furthest == doctest::Approx(1.4).epsilon(1e-12));
}

TEST_CASE("a contact is checked again when it is 10 % deeper, or at the end of the range") {
  TypePairs<KogutEtsion> pairs = table<KogutEtsion>(three_types());
  TypePair<KogutEtsion>& pair = pairs(1, 1);
  const double shallow = 0.5 * pair.range;
  CHECK(pair.deepens(shallow, 1));
  CHECK(pair.checked_from == 1.1 * shallow);
  CHECK_FALSE(pair.deepens(1.05 * shallow, 1));
  CHECK(pair.deepens(pair.range, 1));
  CHECK(pair.checked_from == pair.range);
}

TEST_CASE("the fastest impact determines the time step, and shows whether it leaves the range") {
  TypePairs<KogutEtsion> pairs = table<KogutEtsion>(three_types());
  const KogutEtsion law(combine(aluminium, aluminium), {});
  const ImpactTimes times = impact_times<KogutEtsion>(
      {{1, 1, 0.01, 0.1, 0}, {1, 1, 0.01, 0.1, 0.01}, {1, 1, 0.01, 0.1, 50}}, pairs);
  CHECK(times.step == recommended_timestep(law, 0.01, 0.1, 50));
  CHECK(times.step_speed == 50);
  CHECK(times.outside_speed == 50);
  CHECK(times.hertz == hertz_duration(0.01, 0.1, pairs(1, 1).bodies.youngs_modulus_eff, 50));
}

// Two grains of type 1 move in parallel, a grain of type 2 moves towards them, and type 3 is a
// wall.
TEST_CASE("the forecast has the fastest impact of each pair of types") {
  std::vector<TypeExtremes> types(3);
  const double forward[3] = {2, 0, 0}, slower[3] = {1.5, 0, 0}, back[3] = {-1, 0, 0};
  types[0].add(0.01, 0.1, forward);
  types[0].add(0.02, 0.3, slower);
  types[1].add(0.03, 0.3, back);
  const ImpactForecast between(types, {1, 2, 3}, false, {3});
  REQUIRE(between.meetings().size() == 3);
  const Meeting& same = between.meetings()[0];
  CHECK(same.partner_type == 1);
  CHECK(same.speed == 0.5);
  const Meeting& towards = between.meetings()[1];
  CHECK(towards.partner_type == 2);
  CHECK(towards.speed == 3);
  CHECK(towards.radius_eff == doctest::Approx(0.0075).epsilon(1e-14));
  CHECK(towards.mass_eff == doctest::Approx(0.075).epsilon(1e-14));
  CHECK(between.expected() == std::vector<std::pair<int, int>>{{1, 1}, {1, 2}, {2, 1}, {2, 2}});
  const ImpactForecast wall(types, {3}, true, {3});
  REQUIRE(wall.meetings().size() == 2);
  CHECK(wall.meetings()[0].speed == 2);
  CHECK(wall.expected() == std::vector<std::pair<int, int>>{{1, 3}, {2, 3}});
}
