#include "reports/document_format.hpp"

#include "core/file_io.hpp"
#include "reports/json_fields.hpp"

namespace warpgrain::reports {

std::string format_of(const std::filesystem::path& file) {
  return JsonReader::parse(read_text_file(file, document_size_limit), file.string()).at("format").string();
}

}  // namespace warpgrain::reports
