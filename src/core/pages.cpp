#include "carom/core/pages.hpp"

#include <algorithm>
#include <cstring>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#else
#include <cstdlib>
#endif

#include "carom/core/page_vector.hpp"

namespace carom {
namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;

std::size_t rounded(std::size_t bytes) {
  const std::size_t page = bytes >= huge_page ? huge_page : std::size_t{1} << 12;
  return std::max(page, (bytes + page - 1) / page * page);
}

#if defined(__linux__)
void* take(std::size_t bytes) {
  // Huge pages begin at multiples of their size: take more, give back what lies before and behind.
  const std::size_t more = bytes >= huge_page ? bytes + huge_page : bytes;
  char* const got = static_cast<char*>(mmap(nullptr, more, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  if (got == MAP_FAILED) throw std::bad_alloc();
  if (more == bytes) return got;
  const std::size_t before = (huge_page - reinterpret_cast<std::size_t>(got) % huge_page) % huge_page;
  if (before > 0) munmap(got, before);
  if (before < huge_page) munmap(got + before + bytes, huge_page - before);
  madvise(got + before, bytes, MADV_HUGEPAGE);
  return got + before;
}
void give_back(void* data, std::size_t bytes) { munmap(data, bytes); }

/// Puts the pages of `from` in the place of those that begin at `to`: nothing is copied, and no byte is there twice.
bool move_pages(void* from, std::size_t bytes, void* to, std::size_t room) {
  if (mremap(from, bytes, room, MREMAP_MAYMOVE | MREMAP_FIXED, to) == MAP_FAILED) return false;
  if (room >= huge_page) madvise(to, room, MADV_HUGEPAGE);
  return true;
}
#else
void* take(std::size_t bytes) {
  void* const got = std::aligned_alloc(4096, bytes);
  if (got == nullptr) throw std::bad_alloc();
  std::memset(got, 0, bytes);
  return got;
}
void give_back(void* data, std::size_t) { std::free(data); }
bool move_pages(void*, std::size_t, void*, std::size_t) { return false; }
#endif

}  // namespace

Pages::Pages(std::size_t bytes) : data_(take(rounded(bytes))), bytes_(rounded(bytes)) {}

Pages::~Pages() {
  if (data_ != nullptr) give_back(data_, bytes_);
}

void Pages::grow(std::size_t bytes) {
  if (bytes <= bytes_) return;
  Pages larger(bytes);
  if (data_ != nullptr && move_pages(data_, bytes_, larger.data_, larger.bytes_)) {
    data_ = nullptr;
    bytes_ = 0;
  }
  if (data_ != nullptr) std::memcpy(larger.data_, data_, bytes_);
  *this = std::move(larger);
}

namespace detail {
void* take_pages(std::size_t bytes) { return take(rounded(bytes)); }
void give_back_pages(void* data, std::size_t bytes) { give_back(data, rounded(bytes)); }
}  // namespace detail

}  // namespace carom
