#include "carom/queue/calendar.hpp"

namespace carom {

void Calendar::reset(const Time<double>& now, double width, std::uint32_t outer) {
  start_ = {now.epoch - 1, 0.0};  // what is due is rounded down to an epoch at most
  per_width_ = 1 / width;
  now_ = -1;
  ring_size_ = outer;
  in_ring_ = 0;
  for (std::uint32_t& list : near_) list = none;
  far_ = free_ = none;
  ring_ = PageArray<std::uint32_t>(outer);
  for (std::uint32_t k = 0; k < outer; ++k) ring_[k] = none;
  chunks_ = PageArray<Chunk>();
}

}  // namespace carom
