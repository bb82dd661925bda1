#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "core/contact_file.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain {
namespace {

TEST(ContactFile, ReadsTheSameBitsBack) {
  std::mt19937 random(20261122);
  std::normal_distribution<double> anything(0, 1e-7);
  ContactHistory history;
  for (std::uint32_t k = 0; k < 200; ++k)
    history.push_back(
        {k / 3, k % 3 == 2 ? wall_partner_bit + 5 : 1000 + k, {anything(random), anything(random), 0}});
  const TemporaryFolder folder;
  write_contact_file(folder / "contacts.csv", history);
  const ContactHistory again = read_contact_file(folder / "contacts.csv");
  ASSERT_EQ(again.size(), history.size());
  for (std::size_t k = 0; k < history.size(); ++k) {
    EXPECT_EQ(again[k].particle_id, history[k].particle_id);
    EXPECT_EQ(again[k].partner_id, history[k].partner_id);
    EXPECT_EQ(again[k].tangential_displacement, history[k].tangential_displacement);
  }
}

TEST(ContactFile, RefusesWhatIsNoHistory) {
  const TemporaryFolder folder;
  for (const auto& [text, message] :
       {std::pair{"particle_id,partner_id,x,y\n1,2,0,0\n", "line 1: no column 'z'"},
        {"particle_id,partner_id,x,y,z\n1,2,0,0,nan\n",
         "line 2: column 'z': 'nan'; expected a finite number"},
        {"particle_id,partner_id,x,y,z\n1,2,0,0,0\n1,2,0,0,0\n",
         "line 3: contact of 1 and 2 behind that of 1 and 2"},
        {"particle_id,partner_id,x,y,z\n4294967296,2,0,0,0\n", "line 2: column 'particle_id': '4294967296'"},
        {"particle_id,partner_id,x,y,z\n1,2,0,0,0", "the file ends within the line"}}) {
    write_file_atomically(folder / "contacts.csv", text);
    try {
      read_contact_file(folder / "contacts.csv");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(message));
    }
  }
}

}  // namespace
}  // namespace warpgrain
