#include "random_bed.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace warpgrain {
namespace {

constexpr double largest_radius = 0.005;

class BedMaker {
 public:
  explicit BedMaker(const BedOptions& options) : options_(options), random_(options.seed) {}

  Scene make() {
    scene_.name = "random_bed";
    scene_.gravity = {0.3, -0.4, -9.81};
    scene_.time_step = 1e-5;
    scene_.end.steps = 1;
    scene_.model.simple = {.k_spring = 2000, .k_damping = 0.3, .k_shear = 0.2};
    scene_.materials = {{"glass", 2500, 1e7, 0.3}, {"steel", 7800, 4e7, 0.25}};
    scene_.contacts = ContactTable(2);
    scene_.contacts.set(0, 0, {7.3e6, 1.2e7, 0.4, 0.5});
    scene_.contacts.set(0, 1, {1.1e7, 1.6e7, 0.2, 0.1});
    scene_.contacts.set(1, 1, {2.8e7, 4.1e7, 0.1, 0.3});
    const auto per_edge = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(options_.n_particles))));
    pitch_ = options_.spacing * largest_radius;
    edge_ = pitch_ * per_edge;
    scene_.domain = {Vector3d::Constant(-0.5 * pitch_), Vector3d::Constant(edge_ + 0.5 * pitch_)};
    place_particles(per_edge);
    place_walls();
    if (options_.history) remember_contacts();
    return scene_;
  }

 private:
  double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(random_); }
  Vector3d uniform_vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

  std::vector<std::uint32_t> shuffled_from(std::uint32_t first) {
    std::vector<std::uint32_t> numbers(options_.n_particles);
    std::iota(numbers.begin(), numbers.end(), first);
    std::shuffle(numbers.begin(), numbers.end(), random_);
    return numbers;
  }

  void place_particles(int per_edge) {
    ParticleState& p = scene_.particles;
    const std::vector<std::uint32_t> ids = shuffled_from(100), cells = shuffled_from(0);
    for (std::size_t k = 0; k < options_.n_particles; ++k) {
      const auto cell = static_cast<int>(cells[k]);
      const Vector3d corner(cell % per_edge, cell / per_edge % per_edge, cell / per_edge / per_edge);
      const auto material = static_cast<std::uint32_t>(random_() % 2);
      const double radius = uniform(0.8, 1.0) * largest_radius;
      p.id.push_back(ids[k]);
      p.material.push_back(material);
      p.radius.push_back(radius);
      p.mass.push_back(scene_.materials[material].density * 4 / 3 * std::numbers::pi * std::pow(radius, 3));
      p.position.push_back((corner + Vector3d::Constant(0.5)) * pitch_ +
                           uniform_vector(0.15 * largest_radius));
      p.velocity.push_back(uniform_vector(0.5));
      p.angular_velocity.push_back(uniform_vector(50));
    }
  }

  // A floor, a tilted plane through an edge, two rectangles that meet inside the bed at a right angle, and
  // one whose corner ends there.
  void place_walls() {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const Vector3d tilted = Vector3d(1, 0, 1).normalized();
    const double half = 0.5 * edge_ + 0.4 * pitch_;
    const auto rectangle = [&](std::uint32_t material, const Vector3d& corner, const Vector3d& u,
                               const Vector3d& v) {
      scene_.walls.push_back({WallKind::rectangle, material, corner, u.cross(v).normalized(), u, v});
    };
    scene_.walls.push_back(
        {WallKind::plane, 1, Vector3d(0, 0, 0.1 * pitch_), z, Vector3d::Zero(), Vector3d::Zero()});
    scene_.walls.push_back(
        {WallKind::plane, 0, Vector3d(0.3 * pitch_, 0, 0), tilted, Vector3d::Zero(), Vector3d::Zero()});
    rectangle(0, {half, half, half}, 0.3 * edge_ * x, 0.4 * edge_ * y);
    rectangle(1, {half, half, half}, 0.4 * edge_ * y, 0.3 * edge_ * z);
    rectangle(0, {-pitch_, -pitch_, half}, (half + pitch_) * x, (half + pitch_) * y);
  }

  // Most neighbours and some walls, whether they touch or not; both directions of a pair as the format asks.
  void remember_contacts() {
    ParticleState& p = scene_.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = i + 1; j < p.size(); ++j) {
        const double distance = (p.position[j] - p.position[i]).norm();
        if (distance > 1.02 * (p.radius[i] + p.radius[j]) || uniform(0, 1) < 0.3) continue;
        const Vector3d displacement = uniform_vector(2e-5);
        p.contact_history.push_back({p.id[i], p.id[j], displacement});
        p.contact_history.push_back({p.id[j], p.id[i], -displacement});
      }
      for (std::uint32_t wall = 0; wall < scene_.walls.size(); ++wall) {
        if (uniform(0, 1) < 0.5)
          p.contact_history.push_back({p.id[i], wall_partner_bit | wall, uniform_vector(2e-5)});
      }
    }
    std::sort(p.contact_history.begin(), p.contact_history.end(),
              [](const ContactRecord& a, const ContactRecord& b) {
                return std::pair(a.particle_id, a.partner_id) < std::pair(b.particle_id, b.partner_id);
              });
  }

  BedOptions options_;
  std::mt19937_64 random_;
  Scene scene_;
  double pitch_ = 0, edge_ = 0;
};

}  // namespace

Scene random_bed(const BedOptions& options) { return BedMaker(options).make(); }

}  // namespace warpgrain
