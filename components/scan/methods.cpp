#include "components/scan/methods.hpp"

#include <algorithm>

#include "components/scan/angle_clustering.hpp"
#include "components/scan/endpoint_fit.hpp"
#include "components/scan/incremental_regression.hpp"
#include "components/scan/ransac.hpp"
#include "components/scan/split_and_merge.hpp"

namespace perceptor::scan {

constinit const std::array<NamedMethod, 5> kMethods = {{
    {"split_and_merge", ScanMethod::split_and_merge, split_and_merge},
    {"angle_clustering", ScanMethod::angle_clustering, angle_clustering},
    {"endpoint_fit", ScanMethod::endpoint_fit, endpoint_fit},
    {"incremental_regression", ScanMethod::incremental_regression, incremental_regression},
    {"ransac", ScanMethod::ransac, ransac},
}};

Method method_of(ScanMethod method) {
  const auto* const found = std::ranges::find(kMethods, method, &NamedMethod::method);
  return found != kMethods.end() ? found->function : split_and_merge;
}

}  // namespace perceptor::scan
