#include "variants/backend.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "variants/backend_cuda.hpp"
#include "variants/backend_host.hpp"
#include "variants/backend_opencl.hpp"
#include "variants/backend_simt.hpp"

namespace warpgrain {

std::span<const Backend> backends() {
  static const std::array<Backend, 4> table{host_backend, opencl_backend, cuda_backend, simt_backend};
  return table;
}

const Backend& backend(std::string_view name) {
  const auto it = std::ranges::find(backends(), name, &Backend::name);
  if (it == backends().end()) {
    std::vector<std::string_view> valid;
    for (const Backend& b : backends()) valid.push_back(b.name);
    throw_unknown_name("--backend", "back end", name, valid);
  }
  return *it;
}

}  // namespace warpgrain
