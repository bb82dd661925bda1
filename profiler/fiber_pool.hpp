#pragma once
// The lanes of a work-group that wait for each other: each runs on a stack of its own until it waits or ends.
//
// Boost.Context's switches are used below its fiber class: a lane that never comes back from a diverged
// barrier is dropped with its stack, where the class would unwind it by an exception through translated code,
// which has no unwind tables.

#include <boost/context/detail/fcontext.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>
#include <cstddef>
#include <vector>

#include "profiler/lane_context.hpp"

namespace warpgrain::profiler {

class FiberPool {
 public:
  // `stack_bytes` for each lane's own frames.
  FiberPool(std::size_t lanes, std::size_t stack_bytes);
  ~FiberPool();
  FiberPool(const FiberPool&) = delete;
  FiberPool& operator=(const FiberPool&) = delete;

  // Makes lane `index` ready to run `function(context)`. Its way to wait is put into the context.
  void start(std::size_t index, LaneFunction function, LaneContext* context);
  // Runs the lane until it waits (true) or ends (false).
  bool resume(std::size_t index);

 private:
  struct Fiber {
    boost::context::stack_context stack;
    boost::context::detail::fcontext_t self = nullptr;
    boost::context::detail::fcontext_t scheduler = nullptr;
    LaneFunction function = nullptr;
    LaneContext* context = nullptr;
    bool is_done = true;
  };

  static void forget_frames(const Fiber& fiber);
  static void enter(boost::context::detail::transfer_t transfer);
  static void wait(LaneContext* context, std::uint32_t line);

  boost::context::protected_fixedsize_stack allocator_;
  std::vector<Fiber> fibers_;
};

}  // namespace warpgrain::profiler
