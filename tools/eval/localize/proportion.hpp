/// @file A share of some cases, and how sure that is.
#pragma once

namespace perceptor {

struct Proportion {
  int hits = 0;
  int cases = 0;

  void add(bool is_hit) {
    hits += is_hit ? 1 : 0;
    ++cases;
  }
  double share() const;  ///< NaN without cases
};

struct ConfidenceInterval {
  double low = 0.0;
  double high = 1.0;
};

/// Of a binomial proportion (C. J. Clopper and E. S. Pearson, "The use of confidence or fiducial
/// limits", Biometrika 26, 1934): holds the true share with at least the probability `confidence`.
ConfidenceInterval clopper_pearson(const Proportion& proportion, double confidence = 0.95);

}  // namespace perceptor
