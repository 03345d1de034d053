#include "lissom/core/traced_dual.h"

namespace lissom {

void Tape::add_result(const TracedDual& result, double weight) {
  if (result.tape_ == nullptr) return;
  sensitivity_.resize(numbers_);
  sensitivity_[result.number_].a += weight;
}

void Tape::sweep() {
  sensitivity_.resize(numbers_);
  for (size_t k = links_.size(); k-- > 0;) {
    const Link& link = links_[k];
    sensitivity_[link.from] += sensitivity_[link.result].times(link.partial);
  }
}

const HyperDual& Tape::by(const TracedDual& variable) const { return sensitivity_[variable.number_]; }

}  // namespace lissom
