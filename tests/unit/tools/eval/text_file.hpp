/// @file Files of a test, plain and gzipped.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <zlib.h>

namespace perceptor::testing {

inline void write_plain(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline void write_gzipped(const std::filesystem::path& file, const std::string& text) {
  const gzFile out = gzopen(file.c_str(), "wb");
  if (out == nullptr) throw std::runtime_error("cannot write " + file.string());
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
}

/// What the exception says; empty where there is none.
template <class Error, class Function>
std::string error_of(Function&& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace perceptor::testing
