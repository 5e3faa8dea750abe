// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/kept_fixes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "atom.h"
#include "liggghts/fixes/messages.h"
#include "neighbor.h"

namespace plastigran {

void PairHistories::allocate_pages() {
  if (pgsize_ == neighbor->pgsize && oneatom_ == neighbor->oneatom) return;
  const auto former_partners = std::exchange(ipage_, nullptr);
  const auto former_values = std::exchange(dpage_, nullptr);
  FixContactHistory::allocate_pages();
  for (int i = 0; former_partners && i < atom->nlocal; ++i) {
    const int count = npartner_[i];
    int* const partners = ipage_->get(count);
    double* const values = dpage_->get(dnum_ * count);
    if (!partners || !values)
      stop_from_rank(lmp, "neigh_modify: `one` is " + std::to_string(oneatom_) +
                              ", but a particle has " + std::to_string(count) +
                              " contacts. Set `one` to at least " + std::to_string(count));
    partner_[i] = std::copy_n(partner_[i], count, partners) - count;
    contacthistory_[i] = std::copy_n(contacthistory_[i], dnum_ * count, values) - dnum_ * count;
  }
  delete[] former_partners;
  delete[] former_values;
}

}  // namespace plastigran
