#include "components/scan/methods.hpp"

#include "components/scan/angle_clustering.hpp"
#include "components/scan/split_and_merge.hpp"

namespace perceptor::scan {

Method method_of(ScanMethod method) {
  switch (method) {
    case ScanMethod::angle_clustering:
      return angle_clustering;
    case ScanMethod::split_and_merge:
      return split_and_merge;
  }
  return split_and_merge;
}

}  // namespace perceptor::scan
