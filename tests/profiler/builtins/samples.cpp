#include "tests/profiler/builtins/samples.hpp"

#include <bit>
#include <cmath>
#include <type_traits>

#include "tests/profiler/builtins/random.hpp"

namespace warpgrain::profiler::builtins {
namespace {

template <class T>
std::vector<T> with_both_signs(const std::vector<T>& values) {
  std::vector<T> both;
  for (const T value : values) both.insert(both.end(), {value, -value});
  return both;
}

template <class T>
std::vector<T> few_edges() {
  using L = std::numeric_limits<T>;
  return with_both_signs<T>({0, L::denorm_min(), L::min(), T(0.5), 1, T(1.5), 2, 3, L::max() / 2, L::max(),
                             L::infinity(), L::quiet_NaN()});
}

template <class T>
std::vector<T> edges() {
  using L = std::numeric_limits<T>;
  const T one = 1;
  std::vector<T> values{
      0, L::denorm_min(), 3 * L::denorm_min(), L::min() - L::denorm_min(), L::min(), L::min() * 2,
      L::epsilon(), L::epsilon() / 2, std::sqrt(L::min()), std::sqrt(L::max()), L::max() / 4, L::max() / 2,
      std::nextafter(L::max(), T(0)), L::max(), L::infinity(), L::quiet_NaN(),
      // around one and the halves, which rounding looks at
      std::nextafter(one, T(0)), one, std::nextafter(one, T(2)), std::nextafter(T(0.5), T(0)), T(0.5),
      std::nextafter(T(0.5), one), T(1.5), 2, T(2.5), 3, T(3.5), 4, 5, 6, 7, 8, 10, 11, 12, 17, 20, 33, 34,
      35, 36, 100, T(0.1), T(0.25), T(0.75), T(0.9), T(1.1), T(1e-3), T(1e-5), T(1e-10), 1000, 4096, 65536,
      T(1e5), T(1e10),
      // where integers end, and where fractions do
      1 / L::epsilon() - T(0.5), 1 / L::epsilon(), 1 / L::epsilon() + 1, 2 / L::epsilon(), 4 / L::epsilon(),
      T(0x1p31), T(0x1p32), T(0x1p63), T(0x1p64),
      // angles
      T(M_PI), T(M_PI_2), T(M_PI_4), T(3 * M_PI_4), T(2 * M_PI), T(1.5 * M_PI), T(100 * M_PI), T(105615),
      T(1e6),
      // where powers overflow and vanish
      T(M_LN2), T(1 / M_LN2), T(88.7228), T(88.7229), T(103.9721), T(87.3366), T(709.7827), T(709.7828),
      T(745.1333), 127, 128, 149, 150, 1023, 1024, 1074, 1075, T(38.5318), T(44.8534), T(308.2547),
      T(323.3062),
      // the least value of the gamma function
      T(1.4616321449683622)};
  for (const T whole : {one, T(2), T(M_PI), T(4)})
    values.insert(values.end(), {std::nextafter(whole, T(0)), std::nextafter(whole, L::max())});
  return with_both_signs(values);
}

template <class T>
T any_bits(Random& random) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<T>(static_cast<Bits>(random.bits()));
}

// Half of the values from the range of interest, the others of every size.
template <class T>
T value_of(Random& random, double from, double to) {
  switch (random.below(8)) {
    case 0:
      return any_bits<T>(random);
    case 1:
      return static_cast<T>(std::ldexp(random.between(-2, 2), static_cast<int>(random.below(60)) - 40));
    case 2:
      return static_cast<T>(1 + std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(24))));
    case 3:
      return static_cast<T>(std::rint(random.between(-40, 40)) * 0.5);
    default:
      return static_cast<T>(random.between(from, to));
  }
}

int integer_of(Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<int>(random.bits());
    case 1:
      return static_cast<int>(random.below(4000)) - 2000;
    default:
      return static_cast<int>(random.below(40)) - 20;
  }
}

template <class T>
void add(Samples<T>& samples, T x, T y = 0, T z = 0, int n = 0) {
  samples.x.push_back(x);
  samples.y.push_back(y);
  samples.z.push_back(z);
  samples.n.push_back(n);
}

template <class T>
void add_edges(Samples<T>& samples, Inputs inputs) {
  const std::vector<T> all = edges<T>(), few = few_edges<T>();
  const int smallest = std::numeric_limits<int>::min(), largest = std::numeric_limits<int>::max();
  switch (inputs) {
    case Inputs::x:
      for (const T x : all) add(samples, x);
      break;
    case Inputs::xy:
      for (const T x : all)
        for (const T y : few) {
          add(samples, x, y);
          add(samples, y, x);
        }
      break;
    case Inputs::xyz:
      for (const T x : few)
        for (const T y : few)
          for (const T z : few)
            if ((x == y) + (y == z) < 2) add(samples, x, y, z);
      break;
    case Inputs::xn:
      for (const T x : all)
        for (const int n :
             {smallest, smallest + 1, -2099, -1075, -1074, -1023, -277, -150, -149, -127,   -126,
              -25,      -24,          -3,    -2,    -1,    0,     1,    2,    3,    4,      24,
              25,       127,          128,   254,   277,   1023,  1024, 2046, 2099, largest})
          add(samples, x, T(0), T(0), n);
      break;
  }
}

// y such that x^y is a number: most pairs overflow or vanish.
template <class T>
T exponent_for(Random& random, T x) {
  const double widest = std::numeric_limits<T>::max_exponent;
  const double magnitude = std::abs(std::log2(std::abs(static_cast<double>(x))));
  return static_cast<T>(random.between(-widest, widest) / std::max(magnitude, 1e-30));
}

}  // namespace

template <class T>
Samples<T> samples_for(const MathFunction& function) {
  Samples<T> samples;
  add_edges(samples, function.inputs);
  Random random;
  const double widening = sizeof(T) == sizeof(double) ? function.details.widening : 1;
  const double from = widening * function.details.from, to = widening * function.details.to;
  const auto value = [&] { return value_of<T>(random, from, to); };
  for (int i = 0; i < 1500; ++i) {
    const T x = value();
    const T y = value();
    add(samples, x, y, value(), integer_of(random));
    if (function.inputs == Inputs::xy) add(samples, x, exponent_for(random, x));
    // Nearly all of the product cancels.
    if (function.inputs == Inputs::xyz)
      add(samples, x, y, std::nextafter(-x * y, static_cast<T>(random.between(-1, 1))));
  }
  return samples;
}

template Samples<float> samples_for<float>(const MathFunction&);
template Samples<double> samples_for<double>(const MathFunction&);

}  // namespace warpgrain::profiler::builtins
