#pragma once
// Materials, and what follows from a pair of them for a contact (physics: eqs. 8-10 and the closed forms
// below).

#include <cstddef>
#include <string>
#include <vector>

namespace warpgrain {

struct Material {
  std::string name;
  double density = 0;         // kg/m^3
  double youngs_modulus = 0;  // Pa
  double poisson_ratio = 0;
};

// Coefficients of the practical model for one pair of materials.
struct ContactParameters {
  double normal_parameter = 0;      // C_kn [Pa]; k_n = C_kn sqrt(overlap R*), eq. (8); 4/3 E* from materials
  double tangential_parameter = 0;  // C_kt [Pa]; k_t = C_kt sqrt(overlap R*), eq. (9); 8 G* from materials
  double damping_parameter = 0;     // alpha; eta = alpha sqrt(k_n m*), eq. (10)
  double friction_coefficient = 0;  // mu, eq. (5)
};

// 1/E* = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j  [Pa]
double effective_youngs_modulus(const Material& i, const Material& j);
// 1/G* = 2(2-nu_i)(1+nu_i)/E_i + 2(2-nu_j)(1+nu_j)/E_j  [Pa]
double effective_shear_modulus(const Material& i, const Material& j);
// alpha = -sqrt(5) ln e / sqrt(pi^2 + ln^2 e): restitution e independent of speed for this law (Antypov &
// Elliott's closed form of Tsuji's damping). Takes 0 < e <= 1.
double damping_parameter_of_restitution(double restitution);

// Parameters by pair of material indices, symmetric.
class ContactTable {
 public:
  ContactTable() = default;
  explicit ContactTable(std::size_t n_materials) : n_(n_materials), parameters_(n_materials * n_materials) {}
  std::size_t n_materials() const { return n_; }
  const ContactParameters& at(std::size_t i, std::size_t j) const { return parameters_[i * n_ + j]; }
  void set(std::size_t i, std::size_t j, const ContactParameters& p) {
    parameters_[i * n_ + j] = p;
    parameters_[j * n_ + i] = p;
  }

 private:
  std::size_t n_ = 0;
  std::vector<ContactParameters> parameters_;  // [n_materials * n_materials]
};

}  // namespace warpgrain
