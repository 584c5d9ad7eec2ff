// SPDX-License-Identifier: MIT
#include "traced_number.h"

#include <utility>

namespace occlude::bound_check {
namespace {

int next_unknown() {
  static int last = 0;
  return ++last;
}

Exact power_of_roundoff(int degree) { return degree == 0 ? Exact(1) : kRoundoff * power_of_roundoff(degree - 1); }

}  // namespace

TracedNumber::TracedNumber(double x) { add({0, 0}, Exact(x)); }

void TracedNumber::add(const Unknowns& unknowns, const Exact& coefficient) {
  Exact& term = terms_[unknowns];
  term += coefficient;
  if (term == 0) terms_.erase(unknowns);
}

TracedNumber TracedNumber::unknown(int number) {
  TracedNumber d;
  d.add({number, 0}, 1);
  return d;
}

TracedNumber TracedNumber::tail() const { return product(*this, unknown(next_unknown())); }

const Exact& TracedNumber::leading() const {
  static const Exact zero = 0;
  const auto found = terms_.find({0, 0});
  return found == terms_.end() ? zero : found->second;
}

Exact TracedNumber::most() const {
  Exact sum = beyond_ * power_of_roundoff(3);
  for (const auto& [unknowns, coefficient] : terms_) sum += CGAL::abs(coefficient) * power_of_roundoff(degree(unknowns));
  return sum;
}

Exact TracedNumber::least() const { return 2 * leading() - most(); }

TracedNumber TracedNumber::operator-() const { return product(*this, -1.0); }

TracedNumber TracedNumber::sum(const TracedNumber& a, const TracedNumber& b) {
  TracedNumber result = a;
  for (const auto& [unknowns, coefficient] : b.terms_) result.add(unknowns, coefficient);
  result.beyond_ += b.beyond_;
  return result;
}

TracedNumber TracedNumber::product(const TracedNumber& a, const TracedNumber& b) {
  TracedNumber result;
  for (const auto& [p, x] : a.terms_) {
    for (const auto& [q, y] : b.terms_) {
      const int total = degree(p) + degree(q);
      if (total > 2) {
        result.beyond_ += CGAL::abs(x * y) * power_of_roundoff(total - 3);
      } else if (degree(p) == 1 && degree(q) == 1) {
        result.add({std::max(p[0], q[0]), std::min(p[0], q[0])}, x * y);
      } else {
        result.add(degree(p) == 0 ? q : p, x * y);
      }
    }
  }
  result.beyond_ += a.beyond_ * b.most() + a.most() * b.beyond_;
  return result;
}

TracedNumber TracedNumber::rounded() const {
  const int number = next_unknown();
  TracedNumber result = sum(*this, product(*this, unknown(number)));
  result.last_ = number;
  return result;
}

TracedNumber TracedNumber::unrounded() const {
  TracedNumber result = *this;
  std::erase_if(result.terms_,
                [&](const auto& term) { return last_ != 0 && (term.first[0] == last_ || term.first[1] == last_); });
  return result;
}

TracedNumber fabs(const TracedNumber& x) { return x.leading() < 0 ? -x : x; }

namespace {

TracedTerms split(const TracedNumber& exact) {
  const TracedNumber high = exact.rounded();
  return {high, TracedNumber::sum(exact, -high)};
}

}  // namespace

TracedTerms two_sum(const TracedNumber& a, const TracedNumber& b) { return split(TracedNumber::sum(a, b)); }
TracedTerms two_difference(const TracedNumber& a, const TracedNumber& b) { return split(TracedNumber::sum(a, -b)); }
TracedTerms two_product(const TracedNumber& a, const TracedNumber& b) { return split(TracedNumber::product(a, b)); }

}  // namespace occlude::bound_check
