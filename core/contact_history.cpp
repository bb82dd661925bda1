#include "core/contact_history.hpp"

#include <algorithm>
#include <utility>

namespace warpgrain {

void make_antisymmetric(ContactHistory& history) {
  const auto before = [](const ContactRecord& record, const std::pair<std::uint32_t, std::uint32_t>& ids) {
    return std::pair(record.particle_id, record.partner_id) < ids;
  };
  for (ContactRecord& record : history) {
    if (record.partner_id >= record.particle_id) continue;  // a wall's, or the side that decides
    const std::pair ids(record.partner_id, record.particle_id);
    const auto other = std::lower_bound(history.begin(), history.end(), ids, before);
    if (other != history.end() && other->particle_id == ids.first && other->partner_id == ids.second)
      record.tangential_displacement = -other->tangential_displacement;
  }
}

}  // namespace warpgrain
