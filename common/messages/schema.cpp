#include "common/messages/schema.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace perceptor::messages {
namespace {

/// Counts that one type may have; room for them is on the stack.
constexpr std::size_t kMaxCounts = 8;
using Counts = std::array<std::int32_t, kMaxCounts>;

struct Schema;

struct Dimension {
  bool is_variable = false;
  std::int32_t size = 0;  ///< where fixed
  std::size_t count = 0;  ///< where variable: which of the type's counts
};

struct Field {
  lcm_field_type_t type = LCM_FIELD_BYTE;
  std::size_t bytes = 0;           ///< of one element; 0: depends on the content
  const Schema* nested = nullptr;  ///< of a user type
  std::vector<Dimension> dimensions;
  bool is_count = false;
  std::size_t count = 0;  ///< which one, where it is a count
};

/// The fields of a type in the order in which they are encoded.
struct Schema {
  std::uint64_t fingerprint = 0;
  std::vector<Field> fields;
};

std::size_t bytes_of(lcm_field_type_t type) {
  switch (type) {
    case LCM_FIELD_INT8_T:
    case LCM_FIELD_BYTE:
    case LCM_FIELD_BOOLEAN:
      return 1;
    case LCM_FIELD_INT16_T:
      return 2;
    case LCM_FIELD_INT32_T:
    case LCM_FIELD_FLOAT:
      return 4;
    case LCM_FIELD_INT64_T:
    case LCM_FIELD_DOUBLE:
      return 8;
    case LCM_FIELD_STRING:
    case LCM_FIELD_USER_TYPE:
      break;
  }
  return 0;
}

/// The generated type information tells a variable dimension by the *value* of its count. So
/// each whole number of an example is given a value of its own, and the one that comes back
/// tells which field is the count.
class Example {
 public:
  explicit Example(const lcm_type_info_t& type)
      : type_(type),
        memory_(static_cast<std::size_t>(type.struct_size()) / sizeof(std::max_align_t) + 1) {
    for (int i = 0; i < size(); ++i) {
      const lcm_field_t field = get(i);
      const bool may_be_count = field.type == LCM_FIELD_INT32_T && field.num_dim == 0;
      if (may_be_count) *static_cast<std::int32_t*>(field.data) = kMark + i;
    }
  }

  int size() const { return type_.num_fields(); }

  lcm_field_t get(int index) const {
    lcm_field_t field{};
    type_.get_field(memory_.data(), index, &field);
    return field;
  }

  /// The index of the field that gives this size; throws where none before `index` does.
  int count_of(std::int32_t dimension_size, int index) const {
    const int count = dimension_size - kMark;
    const bool is_field_before = count >= 0 && count < index;
    if (!is_field_before)
      throw std::logic_error(std::string("no count comes back for the array ") + get(index).name);
    return count;
  }

 private:
  static constexpr std::int32_t kMark = 0x10000;
  const lcm_type_info_t& type_;
  std::vector<std::max_align_t> memory_;
};

/// The schemas of all types, each compiled once.
class Schemas {
 public:
  Schemas() {
#define PICO_TYPE(type) types_[#type] = type_info<pico::type>();
#include <pico/all_types.inc>
#undef PICO_TYPE
    for (const auto& [name, type] : types_) compile(*type);
  }

  const Schema* find(const lcm_type_info_t* type) const {
    const auto found = schemas_.find(type);
    return found == schemas_.end() ? nullptr : &found->second;
  }

 private:
  const lcm_type_info_t& nested_type(const lcm_field_t& field) const {
    const std::string_view name = field.typestr;
    const auto found = types_.find(name.substr(name.rfind('.') + 1));
    if (found == types_.end()) throw std::logic_error("unknown type " + std::string(name));
    return *found->second;
  }

  const Schema* compile(const lcm_type_info_t& type) {
    if (const Schema* known = find(&type)) return known;
    const Example example(type);
    Schema schema;
    schema.fingerprint = static_cast<std::uint64_t>(type.get_hash());
    std::size_t counts = 0;
    for (int i = 0; i < example.size(); ++i) {
      const lcm_field_t described = example.get(i);
      Field field;
      field.type = described.type;
      field.bytes = bytes_of(described.type);
      if (described.type == LCM_FIELD_USER_TYPE) field.nested = compile(nested_type(described));
      for (int k = 0; k < described.num_dim; ++k) {
        Dimension dimension;
        dimension.is_variable = described.dim_is_variable[k] != 0;
        dimension.size = described.dim_size[k];
        if (dimension.is_variable) {
          const int index = example.count_of(dimension.size, i);
          Field& count = schema.fields.at(static_cast<std::size_t>(index));
          if (!std::exchange(count.is_count, true)) count.count = counts++;
          dimension.count = count.count;
        }
        field.dimensions.push_back(dimension);
      }
      schema.fields.push_back(std::move(field));
    }
    if (counts > kMaxCounts) throw std::logic_error("a type has too many counts");
    return &schemas_.emplace(&type, std::move(schema)).first->second;
  }

  std::map<std::string, const lcm_type_info_t*, std::less<>> types_;
  std::map<const lcm_type_info_t*, Schema> schemas_;
};

/// Compiled before main, so that a schema that is not understood stops the process at once.
const Schemas kSchemas;

/// Goes once through the bytes. The first fault is kept, and nothing is read after it.
class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  std::string_view message(const Schema& schema) {
    if (!has(8)) return "truncated";
    if (read_big_endian(8) != schema.fingerprint) return "another type";
    if (!walk(schema)) return fault_;
    if (!left_.empty()) return "bytes left over";
    return {};
  }

 private:
  bool fail(std::string_view fault) {
    fault_ = fault;
    return false;
  }

  bool has(std::size_t bytes) const { return bytes <= left_.size(); }

  void skip(std::size_t bytes) { left_ = left_.subspan(bytes); }

  std::uint64_t read_big_endian(std::size_t bytes) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : left_.first(bytes)) value = value << 8U | byte;
    skip(bytes);
    return value;
  }

  bool walk(const Schema& schema) {
    Counts counts{};
    for (const Field& field : schema.fields) {
      if (field.is_count) {
        if (!walk_count(counts.at(field.count))) return false;
      } else if (!walk(field, counts)) {
        return false;
      }
    }
    return true;
  }

  bool walk_count(std::int32_t& count) {
    if (!has(4)) return fail("truncated");
    count = static_cast<std::int32_t>(static_cast<std::uint32_t>(read_big_endian(4)));
    return true;
  }

  bool walk(const Field& field, const Counts& counts) {
    std::size_t elements = 1;
    for (const Dimension& dimension : field.dimensions) {
      const std::int32_t size = dimension.is_variable ? counts.at(dimension.count) : dimension.size;
      if (size < 0) return fail("negative length");
      // Each dimension by itself: the decode allocates rows even where they have no columns.
      const bool fits = has(static_cast<std::size_t>(size));
      elements *= fits ? static_cast<std::size_t>(size) : 0;
      if (!fits || !has(elements))
        return fail(dimension.is_variable ? "length beyond the message" : "truncated");
    }
    if (field.type == LCM_FIELD_BOOLEAN) return walk_booleans(elements);
    if (field.bytes > 0) return walk_plain(elements * field.bytes);
    for (std::size_t i = 0; i < elements; ++i) {
      const bool is_good = field.nested ? walk(*field.nested) : walk_string();
      if (!is_good) return false;
    }
    return true;
  }

  bool walk_plain(std::size_t bytes) {
    if (!has(bytes)) return fail("truncated");
    skip(bytes);
    return true;
  }

  bool walk_booleans(std::size_t bytes) {
    if (!has(bytes)) return fail("truncated");
    const auto is_neither = [](std::uint8_t byte) { return byte > 1; };
    if (std::ranges::any_of(left_.first(bytes), is_neither))
      return fail("boolean that is neither 0 nor 1");
    skip(bytes);
    return true;
  }

  /// Length with the final zero, the characters, the final zero.
  bool walk_string() {
    std::int32_t length = 0;
    if (!walk_count(length)) return false;
    if (length < 1) return fail("string without its end");
    const auto bytes = static_cast<std::size_t>(length);
    if (!has(bytes)) return fail("length beyond the message");
    const auto end = std::ranges::find(left_.first(bytes), std::uint8_t{0});
    const auto zero_at = static_cast<std::size_t>(end - left_.begin());
    if (zero_at == bytes) return fail("string without its end");
    if (zero_at + 1 < bytes) return fail("string with a zero inside");
    skip(bytes);
    return true;
  }

  std::span<const std::uint8_t> left_;
  std::string_view fault_;
};

}  // namespace

std::string_view find_fault(const lcm_type_info_t* type, std::span<const std::uint8_t> bytes) {
  const Schema* schema = kSchemas.find(type);
  if (!schema) return "unknown type";
  return Walk(bytes).message(*schema);
}

std::optional<Stamp> stamp_in(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 32) return std::nullopt;
  const auto int64_at = [bytes](std::size_t offset) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(offset, 8)) value = (value << 8U) | byte;
    return static_cast<std::int64_t>(value);
  };
  return Stamp{int64_at(8), int64_at(16), int64_at(24)};
}

}  // namespace perceptor::messages
