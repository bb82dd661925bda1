// `warpgrain sweep`: every combination of the axes on one scene, one report a case, one index.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <future>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/app.hpp"
#include "cli/bed.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/profile_options.hpp"
#include "cli/run_loop.hpp"
#include "cli/sweep_case.hpp"
#include "cli/sweep_plan.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/html/sweep_page.hpp"
#include "reports/merged_sweeps.hpp"
#include "reports/sweep_columns.hpp"
#include "reports/sweep_index.hpp"
#include "reports/text_sweep.hpp"

namespace warpgrain::cli {
namespace {

struct SweepOptions {
  SceneOptions scene;
  std::vector<std::string> axis;
  DeviceOptions device;
  SimulatorOptions simulator;
  OutputOptions output;
  std::string out;
  std::uint64_t at_step = 0, sample_every = 0;
  std::uint64_t steps = 100, bed = default_bed_particles;
  bool resume = false;
  std::string shard = "1/1";
  unsigned jobs = 1;
};

// The index on disk: rewritten after every case, so that an interrupted sweep leaves what it has.
class IndexFile {
 public:
  IndexFile(std::filesystem::path folder, reports::SweepIndex index)
      : folder_(std::move(folder)), index_(std::move(index)) {}

  // Cases of an earlier sweep of the same state; throws InputError when the folder holds a sweep of another
  // one.
  void resume() {
    const auto path = folder_ / reports::sweep_index_name;
    if (!std::filesystem::exists(path)) return;
    const reports::SweepIndex earlier = reports::read_sweep(path);
    reports::require_same_state(path.string(), earlier, index_);
    for (const reports::SweepCase& c : earlier.cases)
      if (c.status == reports::CaseStatus::done) index_.cases.push_back(c);
  }
  bool has(const Variant& variant) const {
    for (const reports::SweepCase& c : index_.cases)
      if (c.variant == variant.name()) return true;
    return false;
  }
  void put(reports::SweepCase done) {
    index_.cases.push_back(std::move(done));
    write_file_atomically(folder_ / reports::sweep_index_name, reports::sweep_json(index_));
  }
  // In the order of the tables, whoever came first.
  void sort(const std::vector<Variant>& order) {
    std::map<std::string, std::size_t> position;
    for (std::size_t k = 0; k < order.size(); ++k) position[order[k].name()] = k;
    const auto place = [&](const reports::SweepCase& row) {
      const auto found = position.find(row.variant);
      return found == position.end() ? order.size() : found->second;
    };
    std::stable_sort(index_.cases.begin(), index_.cases.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
    write_file_atomically(folder_ / reports::sweep_index_name, reports::sweep_json(index_));
  }
  const reports::SweepIndex& index() const { return index_; }

 private:
  std::filesystem::path folder_;
  reports::SweepIndex index_;
};

// What a sweep goes through; one object a call.
class Sweep {
 public:
  explicit Sweep(const SweepOptions& options)
      : options_(options), progress_(options.output.quiet), variants_(swept_variants(options.axis)) {
    const Shard shard = Shard::parse(options.shard);
    for (std::size_t k = 0; k < variants_.size(); ++k)
      if (shard.has(k)) cases_.push_back(variants_[k]);
  }

  int run() {
    const InterruptWatch watch;
    open_index();
    prepare_common_state();
    time_all();
    profile_all();
    progress_.clear();
    return finish();
  }

 private:
  struct Pending {
    Variant variant;
    reports::SweepCase row;
  };

  void open_index() {
    if (options_.sample_every != 0 && options_.at_step == 0)
      throw_input_error("--sample-every", "no steps to sample on the way", "--at-step");
    setting_.scene = options_.scene.load();
    setting_.at_step = options_.at_step;
    setting_.timed_steps = options_.steps;
    setting_.bed = options_.bed;
    setting_.backend = options_.device.backend_options();
    setting_.profile = options_.simulator.profile_options(options_.device, progress_);
    setting_.machine = options_.simulator.load_machine();
    setting_.folder = options_.out;

    reports::SweepIndex index;
    index.generator = reports::this_generator();
    index.command_line = command_line();
    index.scene = setting_.scene.name;
    index.particles = setting_.scene.particles.size();
    index.seed = setting_.scene.seed;
    index.step = options_.at_step;
    make_folder(setting_.folder);
    index_.emplace(setting_.folder, std::move(index));
    if (options_.resume) index_->resume();
    n_cases_before_ = index_->index().cases.size();
    for (const Variant& variant : cases_)
      if (!index_->has(variant)) pending_.push_back({variant, row_of(variant)});
  }

  static reports::SweepCase row_of(const Variant& variant) {
    reports::SweepCase row;
    row.variant = variant.name();
    for (std::size_t a = 0; a < n_axes; ++a)
      row.axes.emplace(axes()[a].name, variant.value(static_cast<AxisId>(a)));
    return row;
  }

  void prepare_common_state() {
    if (pending_.empty()) return;
    if (options_.sample_every == 0) {
      setting_.scene = advanced(setting_.scene, Variant{}, setting_.backend, options_.at_step, progress_);
      return;
    }
    const RunGoal goal{options_.at_step, {}, options_.sample_every};
    const RunOutcome outcome =
        advance(setting_.scene, Variant{}, setting_.backend, goal, progress_, [&](std::uint64_t step) {
          setting_.passed.push_back({step, setting_.scene.particles});
        });
    if (outcome.interrupted) throw Interrupted();
  }

  // Notes in the case's row why it failed, so that the others go on.
  template <class Work>
  static void attempt(reports::SweepCase& row, Work&& work) {
    if (row.status != reports::CaseStatus::done) return;
    try {
      work();
    } catch (const InputError& error) {
      row.status = reports::CaseStatus::failed;
      row.message = error.what();
    }
  }

  // One after the other, whatever --jobs says: a timing beside other work measures the other work.
  void time_all() {
    ReferenceForces reference(setting_);
    for (std::size_t k = 0; k < pending_.size(); ++k) {
      progress_.update("timing", static_cast<double>(k) / static_cast<double>(pending_.size()),
                       pending_[k].variant.name());
      if (interrupted()) throw Interrupted();
      attempt(pending_[k].row,
              [&] { pending_[k].row.backends = time_and_check(setting_, pending_[k].variant, reference); });
    }
  }

  void profile_all() {
    const unsigned jobs = std::max(1u, options_.jobs);
    SweepSetting setting = setting_;
    if (setting.profile.threads == 0 && jobs > 1)
      setting.profile.threads = std::max(1u, std::thread::hardware_concurrency() / jobs);
    setting.profile.progress = nullptr;  // the cases are the unit of progress here
    std::mutex mutex;
    std::size_t next = 0, finished = 0;
    const auto worker = [&] {
      for (;;) {
        std::unique_lock lock(mutex);
        if (next == pending_.size() || interrupted()) return;
        Pending& pending = pending_[next++];
        progress_.update("profiling", static_cast<double>(finished) / static_cast<double>(pending_.size()),
                         pending.variant.name());
        lock.unlock();
        attempt(pending.row, [&] {
          ProfiledCase profiled = profile_case(setting, pending.variant);
          pending.row.report_file = std::move(profiled.report_file);
          pending.row.headline = profiled.headline;
          pending.row.samples = std::move(profiled.samples);
          pending.row.device_bytes_per_particle = profiled.device_bytes_per_particle;
        });
        lock.lock();
        ++finished;
        index_->put(pending.row);
      }
    };
    std::vector<std::future<void>> workers;  // whose get() hands on what a worker threw
    for (unsigned k = 0; k < jobs; ++k) workers.push_back(std::async(std::launch::async, worker));
    for (std::future<void>& done : workers) done.get();
  }

  int finish() {
    index_->sort(variants_);
    const reports::SweepIndex& index = index_->index();
    write_file_atomically(setting_.folder / "index.html", reports::sweep_page(index));
    if (!options_.output.json.empty()) write_output(options_.output.json, reports::sweep_json(index));
    if (options_.output.summary())
      std::cout << reports::text_sweep(index)
                << "\nreports: " << (setting_.folder / reports::sweep_index_name).string() << ", "
                << (setting_.folder / "index.html").string() << ", and a report a case beside them\n";
    for (const std::string& trouble : reports::troubles_of(index)) std::cerr << trouble << '\n';
    if (index.cases.size() < n_cases_before_ + pending_.size())
      return say_interrupted("sweep", fmt::format("after {} of its cases", index.cases.size()), options_.out);
    for (const reports::SweepCase& row : index.cases)
      if (row.status == reports::CaseStatus::failed) return 2;
    return 0;
  }

  const SweepOptions& options_;
  Progress progress_;
  std::vector<Variant> variants_;  // of the whole sweep
  std::vector<Variant> cases_;     // of this shard
  SweepSetting setting_;
  std::optional<IndexFile> index_;
  std::size_t n_cases_before_ = 0;  // by an earlier call
  std::vector<Pending> pending_;
};

}  // namespace

void add_sweep_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App& command = *app.add_subcommand("sweep", help_text().summary("sweep"));
  options->scene.add_to(command)->required();
  add_option(command, "--axis", options->axis);
  add_option(command, "--out", options->out)->required();
  add_option(command, "--at-step", options->at_step);
  add_option(command, "--sample-every", options->sample_every);
  add_option(command, "--bed", options->bed);
  add_option(command, "--steps", options->steps);
  add_flag(command, "--resume", options->resume);
  add_option(command, "--shard", options->shard);
  add_option(command, "--jobs", options->jobs);
  options->simulator.add_to(command);
  options->device.add_to(command);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return Sweep(*options).run(); }; });
}

}  // namespace warpgrain::cli
