#pragma once
// Random statements of a function: branches, loops and jumps of every kind.

#include "tests/profiler/oracle/random_text.hpp"

namespace warpgrain::oracle {

class RandomStatements {
 public:
  // At most about `budget` statements are made in all.
  RandomStatements(Dice& dice, FunctionText& function, int budget)
      : dice_(dice), function_(function), budget_(budget) {}

  // What may stand at a place beside plain statements.
  struct Around {
    int depth = 0;  // of nesting so far
    bool in_loop = false, in_switch = false, may_return = false;
    bool may_tangle = true;           // whether loops may have several ways in
    std::vector<std::string> labels;  // that a goto may lead to, ahead of it
  };

  // A few statements in a row.
  std::string sequence(const Around& around);

 private:
  std::string statement(const Around& around);
  std::string simple(const Around& around);
  std::string assignment();
  std::string branch(const Around& around);
  std::string choice(const Around& around);
  std::string loop(const Around& around);
  std::string jump(const Around& around);
  std::string region_with_way_out(const Around& around);
  std::string tangle(const Around& around);
  std::string loop_entered_by_switch(const Around& around);
  std::string new_counter();
  std::string new_label();

  Dice& dice_;
  FunctionText& function_;
  int budget_;
};

}  // namespace warpgrain::oracle
