#include "cli/accuracy/convergence_study.hpp"

#include <array>
#include <fmt/format.h>

#include "analysis/convergence.hpp"
#include "analysis/impact_theory.hpp"
#include "cli/accuracy/single_impact.hpp"

namespace warpgrain::cli {
namespace {

// Halved from row to row; the last one stands for the limit.
constexpr std::array steps_a_contact{25, 50, 100, 200, 400, 800, 1600, 12800};

double spin_after(SlipHistory history, double angle, double restitution, int steps) {
  Scene scene = load_scene("impact_4_alumina");
  set_angle(scene, angle);
  ContactParameters contact = scene.contacts.at(0, 1);
  contact.damping_parameter = damping_parameter_of_restitution(restitution);
  scene.contacts.set(0, 1, contact);
  scene.model.slip_history = history;
  const ParticleState& p = scene.particles;
  scene.time_step =
      hertz_impact(contact.normal_parameter, p.radius[0], p.mass[0], -p.velocity[0].z()).duration / steps;
  Variant reference;
  reference.set("precision", "fp64");
  BackendOptions options;
  options.threads = 1;
  return single_impact(scene, backend("host"), reference, options, 1).after.angular_velocity[0].y();
}

reports::StudyReport::Table table_of(double angle, double restitution) {
  reports::StudyReport::Table table{
      fmt::format("Spin [rad/s] after an impact at {:g} degrees with restitution {:g}, by steps a contact",
                  angle, restitution),
      "",
      {"slip_history"},
      {}};
  for (const int steps : steps_a_contact) table.columns.push_back(fmt::format("{}", steps));
  table.columns.emplace_back("order");
  for (std::size_t k = 0; k < slip_history_names.size(); ++k) {
    std::vector<reports::StudyReport::Value> row{std::string(slip_history_names[k])};
    std::vector<double> spins;
    for (const int steps : steps_a_contact) {
      spins.push_back(spin_after(static_cast<SlipHistory>(k), angle, restitution, steps));
      row.emplace_back(spins.back());
    }
    const auto order = convergence_order(spins);
    row.push_back(order ? reports::StudyReport::Value(*order) : reports::StudyReport::Value());
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

std::vector<reports::StudyReport::Table> convergence_tables() {
  std::vector<reports::StudyReport::Table> tables;
  for (const double restitution : {0.98, 0.5})
    for (const double angle : {15, 30, 60}) tables.push_back(table_of(angle, restitution));
  tables.back().note =
      "The order is the slope of log |spin - spin at the finest| over log(step). 1 and above: the "
      "integrator's own; "
      "below, the contact changes between sticking and slipping as steps become smaller.";
  return tables;
}

}  // namespace warpgrain::cli
