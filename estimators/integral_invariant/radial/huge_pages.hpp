#pragma once

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace gridstep {

/// Allocates large tables that are read here and there: in pages of 2 MiB where the system has them to give, since with
/// small ones looking up the page takes longer than reading the entry.
template <class T>
struct HugePages {
  using value_type = T;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t n) {
    if (!is_large(n)) return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{alignof(T)}));
    const std::size_t bytes = (n * sizeof(T) + kPage - 1) / kPage * kPage;
    void* const memory = std::aligned_alloc(kPage, bytes);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes, MADV_HUGEPAGE);  // a hint: it may be refused
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t n) {
    if (is_large(n))
      std::free(memory);
    else
      ::operator delete (memory, std::align_val_t{alignof(T)});
  }
  friend bool operator==(const HugePages&, const HugePages&) {
    return true;
  }

 private:
  static constexpr std::size_t kPage = std::size_t{2} << 20;
  static bool is_large(std::size_t n) {
    return n * sizeof(T) >= 4 * kPage;
  }
};

}  // namespace gridstep
