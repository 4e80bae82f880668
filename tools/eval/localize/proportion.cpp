#include "tools/eval/localize/proportion.hpp"

#include <limits>

#include <boost/math/distributions/binomial.hpp>

namespace perceptor {

double Proportion::share() const {
  if (cases == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(hits) / cases;
}

ConfidenceInterval clopper_pearson(const Proportion& proportion, double confidence) {
  if (proportion.cases == 0) return {};
  using Binomial = boost::math::binomial_distribution<>;
  const double either_side = (1.0 - confidence) / 2.0;
  return {Binomial::find_lower_bound_on_p(proportion.cases, proportion.hits, either_side),
          Binomial::find_upper_bound_on_p(proportion.cases, proportion.hits, either_side)};
}

}  // namespace perceptor
