#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace gridstep {

/// std::allocator, but elements made without a value keep what their memory held.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  UninitializedAllocator() = default;
  template <class U>
  UninitializedAllocator(const UninitializedAllocator<U>&) {}

  void construct(T*) {}
  template <class... Values>
  void construct(T* element, Values&&... values) {
    std::construct_at(element, std::forward<Values>(values)...);
  }
};

/// For results that threads write, each its own: zeros would be written before, and all memory touched first, by one
/// of them. Its size may be given; what resize() adds has no value either.
template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}  // namespace gridstep
