#include "profiler/fiber_pool.hpp"

#include <sanitizer/asan_interface.h>

namespace warpgrain::profiler {

namespace context = boost::context::detail;

FiberPool::FiberPool(std::size_t lanes, std::size_t stack_bytes) : allocator_(stack_bytes), fibers_(lanes) {
  for (Fiber& fiber : fibers_) fiber.stack = allocator_.allocate();
}

FiberPool::~FiberPool() {
  for (Fiber& fiber : fibers_) {
    forget_frames(fiber);
    allocator_.deallocate(fiber.stack);
  }
}

// The first frame on a stack never returns, so that the address sanitizer would keep its red zones.
void FiberPool::forget_frames(const Fiber& fiber) {
  const auto* const end = static_cast<const std::byte*>(fiber.stack.sp);
  ASAN_UNPOISON_MEMORY_REGION(end - fiber.stack.size, fiber.stack.size);
}

void FiberPool::start(std::size_t index, LaneFunction function, LaneContext* lane) {
  Fiber& fiber = fibers_[index];
  forget_frames(fiber);
  fiber.function = function;
  fiber.context = lane;
  fiber.is_done = false;
  lane->fiber = &fiber;
  lane->wait = wait;
  // Stacks are whole pages apart: frames at the same offset in each would fight for the same cache sets.
  const std::size_t stagger = index % 16 * 192;
  fiber.self = context::make_fcontext(static_cast<std::byte*>(fiber.stack.sp) - stagger,
                                      fiber.stack.size - stagger, enter);
}

bool FiberPool::resume(std::size_t index) {
  Fiber& fiber = fibers_[index];
  fiber.self = context::jump_fcontext(fiber.self, &fiber).fctx;
  return !fiber.is_done;
}

void FiberPool::enter(context::transfer_t transfer) {
  Fiber& fiber = *static_cast<Fiber*>(transfer.data);
  fiber.scheduler = transfer.fctx;
  fiber.function(fiber.context);
  fiber.is_done = true;
  context::jump_fcontext(fiber.scheduler, nullptr);
}

void FiberPool::wait(LaneContext* lane, std::uint32_t line) {
  Fiber& fiber = *static_cast<Fiber*>(lane->fiber);
  lane->line = line;
  fiber.scheduler = context::jump_fcontext(fiber.scheduler, nullptr).fctx;
}

}  // namespace warpgrain::profiler
