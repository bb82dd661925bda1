#pragma once
// Contact histories as CSV, beside a state file of the same particles: a row a record, displacements in m,
//   particle_id,partner_id,x,y,z
// Numbers are printed so that reading them back gives the same doubles.

#include <filesystem>

#include "core/contact_history.hpp"

namespace warpgrain {

// Atomic: the file is whole or not there. Throws InputError when it cannot be written.
void write_contact_file(const std::filesystem::path& path, const ContactHistory& history);

// Throws InputError naming file and line: a row with too few or too many fields, a field that is no finite
// number, rows that are not sorted by both ids, a last line without its end.
ContactHistory read_contact_file(const std::filesystem::path& path);

}  // namespace warpgrain
