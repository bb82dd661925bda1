#pragma once
// Closed forms of single contacts, to hold simulations against.

namespace warpgrain {

// Two spheres (or a sphere and a wall) that meet head on without damping: K. L. Johnson, "Contact Mechanics"
// (1985), section 11.4, with C = C_kn sqrt(R*) of eq. (8), so that F = C overlap^1.5.
struct HertzImpact {
  double largest_overlap = 0;  // m, (5 m* v^2 / (4 C))^0.4
  double largest_force = 0;    // N, C largest_overlap^1.5
  double duration = 0;         // s, 2.9432 largest_overlap / v
};
HertzImpact hertz_impact(double normal_parameter, double effective_radius, double effective_mass,
                         double speed);

// The force of that impact `time` [s] after it began [N]; 0 before and after. There is no closed form of it:
// x'' = -5/4 x^1.5 in units of the largest overlap and of that over v, integrated.
double hertz_force(const HertzImpact& impact, double time);

// The overlap at which a Hertz contact carries `force` [N]: (force / C)^(2/3) [m].
double hertz_overlap(double normal_parameter, double effective_radius, double force);

// A sphere of radius r that hits a wall at an angle, slipping all through the contact: friction takes mu
// times the normal impulse (Maw, Barber & Fawcett 1976).
struct SlidingImpact {
  double tangential_velocity = 0;  // m/s, of the centre: v_t - mu (1 + e) v_n
  double angular_velocity = 0;     // rad/s: 5 mu (1 + e) v_n / (2 r)
  bool slips_throughout = false;   // v_t >= 7/2 mu (1 + e) v_n: the contact point never comes to rest
};
SlidingImpact sliding_impact(double normal_speed, double tangential_speed, double radius, double restitution,
                             double friction);

// Restitution under eq. (1): exp(-pi z / sqrt(1 - z^2)), z = damping / (2 sqrt(spring m*)); 0 where z >= 1.
double linear_restitution(double spring, double damping, double effective_mass);

}  // namespace warpgrain
