#include "profiler/ordered_output.hpp"

#include <ostream>

namespace warpgrain::profiler {

void OrderedOutput::write(std::uint64_t index, std::string text) {
  const std::lock_guard lock(mutex_);
  if (index != next_) {
    waiting_.emplace(index, std::move(text));
    return;
  }
  out_ << text;
  for (++next_; !waiting_.empty() && waiting_.begin()->first == next_; ++next_) {
    out_ << waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
  }
}

}  // namespace warpgrain::profiler
