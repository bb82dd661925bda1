#pragma once
// Which values of the axes go together, and how exact a variant has to be.

#include <string>
#include <vector>

#include "variants/axes.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain {

// Why the combination makes no sense, in one line; empty when it does.
std::string refusal(const Variant& variant);
// Throws InputError with the reason.
void require_sensible(const Variant& variant);

// Every combination that makes sense, tuning axes at their defaults, in table order.
std::vector<Variant> all_variants();

// Every value of every axis at least once in a variant that makes sense: the default variant, then, value by
// value, the first variant that has it and differs least from the default.
std::vector<Variant> one_value_at_a_time();

// What the variant's forces may be off: the law's bounds for its arithmetic, times what precision and math
// mode allow.
double error_bound(const Variant& variant);
double error_bound_at_rest(const Variant& variant);

}  // namespace warpgrain
