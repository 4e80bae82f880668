/// @file Tests that every method has to pass.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "components/scan/extractor.hpp"

namespace perceptor::test {

class EachMethod : public testing::TestWithParam<scan::NamedMethod> {
 protected:
  static scan::ScanParameters parameters() {
    scan::ScanParameters chosen;
    chosen.method = GetParam().method;
    return chosen;
  }
};

inline std::string name_of(const testing::TestParamInfo<scan::NamedMethod>& info) {
  return std::string(info.param.name);
}

}  // namespace perceptor::test
