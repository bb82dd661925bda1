// Fits the constants of the cost model (analysis/cost_constants.hpp) to measured times of small kernels:
//
//   fit_cost_model MACHINE FOLDER [--write FILE]
//
// FOLDER holds NAME.report.json (of `warpgrain profile --machine MACHINE`) and NAME.measured.json (of
// `warpgrain measure`) for each launch, as scripts/measure_cost.sh makes them; NAME.row.json, where there is
// one, is of launches in a row. Prints the constants, and how far the model is off for each launch; --write
// puts them into a machine file.
//
// What is made small is the sum over launches of a function of r = ln(predicted / measured) that grows as r^2
// near zero and as |r| beyond 0.2, so that a launch which the model cannot explain does not bend all others.
// Every constant is above zero, so its logarithm is what is varied.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>
#include <vector>

#include "analysis/cost_model.hpp"
#include "analysis/prediction_error.hpp"
#include "analysis/statistics.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/measured_report.hpp"
#include "reports/report_json.hpp"

namespace warpgrain {
namespace {

struct Reading {
  std::string name;
  profiler::LaunchCounters counters;
  double working_set = 0, seconds = 0;
};

// Not fitted but taken from launches in a row.
constexpr std::string_view next_launch = "next_launch";

double seconds_a_launch(const std::filesystem::path& file) {
  const reports::MeasuredReport measured = reports::read_measured(file);
  if (measured.kernels.size() != 1) throw_input_error(file.string(), "not one kernel", "one launch");
  return median(measured.kernels[0].seconds) / static_cast<double>(measured.kernels[0].calls);
}

// The constants that are varied.
std::vector<CostKey> fitted_keys() {
  std::vector<CostKey> keys;
  for (std::size_t k = n_limits; k < cost_keys.size(); ++k)
    if (cost_keys[k].key != next_launch) keys.push_back(cost_keys[k]);
  return keys;
}

CostConstants with(CostConstants cost, const Eigen::VectorXd& logarithms) {
  const std::vector<CostKey> keys = fitted_keys();
  for (std::size_t k = 0; k < keys.size(); ++k)
    (cost.*keys[k].value).value = std::exp(logarithms[static_cast<Eigen::Index>(k)]);
  cost.overlap.value = std::max(cost.overlap.value, 1.0);
  return cost;
}

double predicted_seconds(const Reading& reading, const Machine& machine) {
  return predict_time(reading.counters, machine, reading.working_set, LaunchPlace::alone)->seconds;
}

struct Residuals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  int inputs() const { return static_cast<int>(fitted_keys().size()); }
  int values() const { return static_cast<int>(readings->size()); }
  int operator()(const Eigen::VectorXd& logarithms, Eigen::VectorXd& residuals) const {
    Machine varied = *machine;
    varied.cost = with(*machine->cost, logarithms);
    for (std::size_t k = 0; k < readings->size(); ++k) {
      constexpr double bend = 0.2;
      const double r = std::log(predicted_seconds((*readings)[k], varied) / (*readings)[k].seconds) / bend;
      residuals[static_cast<Eigen::Index>(k)] =
          std::copysign(std::sqrt(2 * (std::sqrt(1 + r * r) - 1)), r) * bend;
    }
    return 0;
  }

  const std::vector<Reading>* readings;
  const Machine* machine;
};

std::vector<Reading> read_folder(const std::filesystem::path& folder, double& row_gain) {
  constexpr std::string_view suffix = ".report.json";
  std::vector<Reading> readings;
  std::vector<double> gains;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(suffix)) continue;
    const std::string name = file.substr(0, file.size() - suffix.size());
    const std::filesystem::path measured = folder / (name + ".measured.json"),
                                row = folder / (name + ".row.json");
    if (!std::filesystem::exists(measured))
      throw_input_error(measured.string(), "no file", "its measurement");
    const reports::Report report = reports::read_report(entry.path());
    if (report.launches.size() != 1 || !report.launches[0].counters.footprint)
      throw_input_error(entry.path().string(), "no footprint", "a report of one launch with --machine");
    // Before each run `measure` copies the first contents of every buffer to the buffer itself, which the
    // second cache has then used last. What was copied from is not counted: with it the fit would ask for
    // more bytes than an H100's second cache has.
    readings.push_back({name, report.launches[0].counters, static_cast<double>(report.buffer_bytes),
                        seconds_a_launch(measured)});
    if (std::filesystem::exists(row)) gains.push_back(readings.back().seconds - seconds_a_launch(row));
  }
  if (readings.empty()) throw_input_error(folder.string(), "no *.report.json", "one for each launch");
  if (gains.empty()) throw_input_error(folder.string(), "no *.row.json", "launches in a row");
  std::ranges::sort(readings, {}, &Reading::name);
  row_gain = median(gains);
  return readings;
}

void fit(const Machine& machine, const std::vector<Reading>& readings, CostConstants& cost) {
  const std::vector<CostKey> keys = fitted_keys();
  Eigen::VectorXd logarithms(static_cast<Eigen::Index>(keys.size()));
  for (std::size_t k = 0; k < keys.size(); ++k)
    logarithms[static_cast<Eigen::Index>(k)] = std::log((cost.*keys[k].value).value);
  const Residuals residuals{&readings, &machine};
  Eigen::NumericalDiff<Residuals, Eigen::Central> differentiable(residuals, 1e-6);
  Eigen::LevenbergMarquardt<decltype(differentiable)> solver(differentiable);
  solver.parameters.maxfev = 4000;
  solver.minimize(logarithms);
  cost = with(cost, logarithms);
}

void print(const Machine& machine, const std::vector<Reading>& readings) {
  std::vector<double> predicted, measured;
  for (const Reading& reading : readings) {
    const PredictedTime time =
        *predict_time(reading.counters, machine, reading.working_set, LaunchPlace::alone);
    predicted.push_back(time.seconds);
    measured.push_back(reading.seconds);
    fmt::print(
        "{:32} measured {:8.2f} us, predicted {:8.2f} {:+6.1f} %  start {:.2f} issue {:.2f} sfu {:.2f} lines "
        "{:.2f} memory {:.2f} latency {:.2f}\n",
        reading.name, 1e6 * reading.seconds, 1e6 * time.seconds, 100 * (time.seconds / reading.seconds - 1),
        1e6 * time.start, 1e6 * time.issue, 1e6 * time.sfu, 1e6 * time.lines, 1e6 * time.memory,
        1e6 * time.latency);
  }
  const PredictionError error = prediction_error(predicted, measured);
  fmt::print("{} launches, median error {:.1f} %, largest {:.1f} %\n", readings.size(), 100 * error.median,
             100 * error.largest);
  for (const CostKey& key : cost_keys) {
    const MachineValue& value = *machine.cost.*key.value;
    fmt::print("{:20} {:.4g}\n", key.key, value.value);
  }
}

void write(const std::filesystem::path& file, const CostConstants& cost, const std::string& source) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_text_file(file, std::uintmax_t{1} << 20));
  for (std::size_t k = n_limits; k < cost_keys.size(); ++k) {
    nlohmann::ordered_json& value = json["cost"][std::string(cost_keys[k].key)];
    value["value"] = nlohmann::ordered_json::parse(fmt::format("{:.4g}", (cost.*cost_keys[k].value).value));
    value["source"] = source;
  }
  write_file_atomically(file, json.dump(2) + "\n");
}

int run(std::span<char* const> words) {
  if (words.size() != 3 && !(words.size() == 5 && std::string_view(words[3]) == "--write"))
    throw_input_error("fit_cost_model", fmt::format("{} arguments", words.size() - 1),
                      "MACHINE FOLDER [--write FILE]");
  Machine machine = load_machine(words[1]);
  if (!machine.cost) throw_input_error(words[1], "no 'cost'", "limits, and constants to start from");
  double row_gain = 0;
  const std::vector<Reading> readings = read_folder(words[2], row_gain);
  // Twice: a path that begins far off may stop short.
  for (int round = 0; round < 2; ++round) {
    const Machine start = machine;
    fit(start, readings, *machine.cost);
  }
  machine.cost->next_launch.value = machine.cost->launch.value - row_gain;
  print(machine, readings);
  if (words.size() == 5)
    write(words[4], *machine.cost,
          fmt::format("fit_cost_model over {} launches of bench/cost", readings.size()));
  return 0;
}

}  // namespace
}  // namespace warpgrain

int main(int argc, char** argv) {
  try {
    return warpgrain::run(std::span<char* const>(argv, static_cast<std::size_t>(argc)));
  } catch (const warpgrain::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
