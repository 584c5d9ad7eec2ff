// SPDX-License-Identifier: MIT
#include "traced_number.h"

#include <cmath>

namespace occlude::bound_check {
namespace {

int next_unknown() {
  static int last = 0;
  return ++last;
}

template <int kBits>
Exact power_of_roundoff(int degree) {
  return degree == 0 ? Exact(1) : Exact(std::ldexp(1.0, -kBits) * power_of_roundoff<kBits>(degree - 1));
}

}  // namespace

template <int kBits>
BasicTracedNumber<kBits>::BasicTracedNumber(double x) {
  add({0, 0}, Exact(x));
}

template <int kBits>
void BasicTracedNumber<kBits>::add(const Unknowns& unknowns, const Exact& coefficient) {
  Exact& term = terms_[unknowns];
  term += coefficient;
  if (term == 0) terms_.erase(unknowns);
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::unknown(int number) {
  BasicTracedNumber d;
  d.add({number, 0}, 1);
  return d;
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::tail() const {
  return product(*this, unknown(next_unknown()));
}

template <int kBits>
const Exact& BasicTracedNumber<kBits>::leading() const {
  static const Exact zero = 0;
  const auto found = terms_.find({0, 0});
  return found == terms_.end() ? zero : found->second;
}

template <int kBits>
Exact BasicTracedNumber<kBits>::most() const {
  Exact sum = beyond_ * power_of_roundoff<kBits>(3);
  for (const auto& [unknowns, coefficient] : terms_)
    sum += CGAL::abs(coefficient) * power_of_roundoff<kBits>(degree(unknowns));
  return sum;
}

template <int kBits>
Exact BasicTracedNumber<kBits>::least() const {
  return 2 * leading() - most();
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::operator-() const {
  return product(*this, -1.0);
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::sum(const BasicTracedNumber& a, const BasicTracedNumber& b) {
  BasicTracedNumber result = a;
  for (const auto& [unknowns, coefficient] : b.terms_) result.add(unknowns, coefficient);
  result.beyond_ += b.beyond_;
  return result;
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::product(const BasicTracedNumber& a, const BasicTracedNumber& b) {
  BasicTracedNumber result;
  for (const auto& [p, x] : a.terms_) {
    for (const auto& [q, y] : b.terms_) {
      const int total = degree(p) + degree(q);
      if (total > 2) {
        result.beyond_ += CGAL::abs(x * y) * power_of_roundoff<kBits>(total - 3);
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

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::rounded() const {
  const int number = next_unknown();
  BasicTracedNumber result = sum(*this, product(*this, unknown(number)));
  result.last_ = number;
  return result;
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::unrounded() const {
  BasicTracedNumber result = *this;
  std::erase_if(result.terms_,
                [&](const auto& term) { return last_ != 0 && (term.first[0] == last_ || term.first[1] == last_); });
  return result;
}

template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::series(const BasicTracedNumber& x, const Exact& first,
                                                          const Exact& second, const Exact& beyond) {
  const auto times = [](const BasicTracedNumber& a, const Exact& factor) {
    BasicTracedNumber result;
    for (const auto& [unknowns, coefficient] : a.terms_) result.add(unknowns, coefficient * factor);
    result.beyond_ = a.beyond_ * CGAL::abs(factor);
    return result;
  };
  BasicTracedNumber result = sum(sum(1, times(x, first)), times(product(x, x), second));
  const Exact most = x.most() / power_of_roundoff<kBits>(1);
  result.beyond_ += beyond * most * most * most;
  return result;
}

/// 1 - x + x^2; what follows is less than twice x^3 for x below 1 / 2.
template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::inverse() const {
  BasicTracedNumber scale;
  scale.add({0, 0}, 1 / leading());
  return product(scale, series(sum(product(*this, scale), -1), -1, 1, 2));
}

/// 1 + x / 2 - x^2 / 8; what follows is less than x^3 / 8 for x below 1 / 2.
template <int kBits>
BasicTracedNumber<kBits> BasicTracedNumber<kBits>::root() const {
  return series(sum(*this, -1), Exact(0.5), Exact(-0.125), Exact(0.125));
}

template class BasicTracedNumber<53>;
template class BasicTracedNumber<24>;

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
