#pragma once
// An array with a value for every ray kind.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

#include "shared/kinds.h"

namespace crsh {

inline constexpr size_t kind_count = shared::kind_count;

/// Values by kind. It is made of one value for all, of a value each, or of a function of the kind: none can be missing.
template <class T>
class PerKind {
 public:
  /// All empty, where T can be that; a number has to be said.
  template <class Value = T, std::enable_if_t<std::is_class_v<Value>, int> = 0>
  constexpr PerKind() {}

  template <std::copyable Value = T>
  constexpr explicit PerKind(const std::type_identity_t<Value>& all) {
    fill(all);
  }

  template <std::invocable<uint32_t> Of>
  constexpr explicit PerKind(const Of& of) {
    for (uint32_t kind = 0; kind < kind_count; ++kind) values_[kind] = of(kind);
  }

  template <std::convertible_to<T>... Values,
            std::enable_if_t<sizeof...(Values) == kind_count && (kind_count > 1), int> = 0>
  constexpr PerKind(Values&&... values) : values_{T(std::forward<Values>(values))...} {}

  constexpr void fill(const T& value) { std::ranges::fill(values_, value); }
  [[nodiscard]] constexpr T& operator[](size_t kind) { return values_[kind]; }
  [[nodiscard]] constexpr const T& operator[](size_t kind) const { return values_[kind]; }
  [[nodiscard]] static constexpr size_t size() { return kind_count; }
  [[nodiscard]] constexpr auto begin() { return std::begin(values_); }
  [[nodiscard]] constexpr auto begin() const { return std::begin(values_); }
  [[nodiscard]] constexpr auto end() { return std::end(values_); }
  [[nodiscard]] constexpr auto end() const { return std::end(values_); }
  [[nodiscard]] constexpr bool operator==(const PerKind&) const = default;

 private:
  T values_[kind_count]{};
};

}  // namespace crsh
