// SPDX-License-Identifier: GPL-2.0-or-later
//
// Access to private members of LIGGGHTS' classes, for data without a public function. C++ does not
// check access in the template arguments of an explicit instantiation. After
// `PRIVATE_MEMBER(Tag, Class::member)`, `object.*member_of(Tag())` is the member.
#pragma once

namespace plastigran {
namespace {  // gives each source file separate functions member_of()

template <class Tag, auto pointer>
struct MemberOf {
  friend auto member_of(Tag) { return pointer; }
};

#define PRIVATE_MEMBER(Tag, member) \
  struct Tag {                      \
    friend auto member_of(Tag);     \
  };                                \
  template struct MemberOf<Tag, &member>

}  // namespace
}  // namespace plastigran
