#pragma once

// What a program holds on the heap: replaces operator new and delete, so include it in one source file of a program.

#include <malloc.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace gridstep::heap {

inline std::atomic<std::int64_t> bytes{0}, peak{0};

inline void* allocated(void* memory) {
  if (!memory) throw std::bad_alloc();
  const std::int64_t now = bytes += std::int64_t(malloc_usable_size(memory));
  for (std::int64_t most = peak; now > most && !peak.compare_exchange_weak(most, now);) {
  }
  return memory;
}
inline void release(void* memory) {
  bytes -= std::int64_t(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace gridstep::heap

void* operator new(std::size_t size) {
  return gridstep::heap::allocated(std::malloc(size > 0 ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = std::size_t(alignment);
  return gridstep::heap::allocated(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}
void operator delete(void* memory) noexcept {
  gridstep::heap::release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  gridstep::heap::release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  gridstep::heap::release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  gridstep::heap::release(memory);
}
