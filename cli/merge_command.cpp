// `warpgrain merge`: the shards of a sweep as one folder.

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/html/sweep_page.hpp"
#include "reports/merged_sweeps.hpp"
#include "reports/text_sweep.hpp"

namespace warpgrain::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;
  OutputOptions output;
};

// Everything but the indices: reports, their pages and their PTX. Files of one name are of one case.
void copy_files(const std::filesystem::path& from, const std::filesystem::path& to) {
  for (const auto& entry : std::filesystem::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == reports::sweep_index_name || name == "index.html") continue;
    std::error_code error;
    std::filesystem::copy_file(entry.path(), to / name, std::filesystem::copy_options::overwrite_existing,
                               error);
    if (error) throw_input_error(entry.path().string(), error.message(), "a file that can be copied");
  }
}

int merge(const MergeOptions& options) {
  const auto shards = reports::read_shards(options.folders);
  reports::SweepIndex index = reports::merged(shards);
  index.command_line = command_line();
  index.generator = reports::this_generator();
  make_folder(options.out);
  // The first folder's cases win, so it is copied last.
  for (auto shard = shards.rbegin(); shard != shards.rend(); ++shard)
    if (!std::filesystem::equivalent(shard->folder, options.out)) copy_files(shard->folder, options.out);
  const std::filesystem::path out = options.out;
  write_file_atomically(out / reports::sweep_index_name, reports::sweep_json(index));
  write_file_atomically(out / "index.html", reports::sweep_page(index));
  if (!options.output.json.empty()) write_output(options.output.json, reports::sweep_json(index));
  if (options.output.summary()) std::cout << reports::text_sweep(index);
  return 0;
}

}  // namespace

void add_merge_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App& command = *app.add_subcommand("merge", help_text().summary("merge"));
  add_option(command, "folders", options->folders)->required();
  add_option(command, "--out", options->out)->required();
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return merge(*options); }; });
}

}  // namespace warpgrain::cli
