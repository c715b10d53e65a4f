#include "output/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <new>

#include "crsh/assertion.h"
#include "crsh/error.h"

namespace crsh::output {
namespace {

constexpr uint32_t quick = 1;                // level of deflate: half the time of zlib's default, a tenth more bytes
constexpr uint16_t first_date = 1 << 5 | 1;  // 1 January 1980, where ZIP's time begins

/// The bytes of the archive that was written to this source.
std::string bytes_of(zip_source_t* source) {
  zip_stat_t status;
  CRSH_ASSERT(zip_source_open(source) == 0 && zip_source_stat(source, &status) == 0, "a ZIP archive in memory");
  std::string bytes(status.size, '\0');
  CRSH_ASSERT(zip_source_read(source, bytes.data(), bytes.size()) == zip_int64_t(bytes.size()),
              "a ZIP archive in memory");
  zip_source_close(source);
  return bytes;
}

void add(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  CRSH_ASSERT(index >= 0, "a file joins a ZIP archive");
  zip_set_file_compression(archive, zip_uint64_t(index), ZIP_CM_DEFLATE, quick);
  zip_file_set_dostime(archive, zip_uint64_t(index), 0, first_date, 0);
}

/// Closes the file at the end of a scope.
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

std::string encode_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_t* archive = target ? zip_open_from_source(target, ZIP_TRUNCATE, nullptr) : nullptr;
  if (!archive) throw std::bad_alloc();
  zip_source_keep(target);
  for (const auto& [name, bytes] : files) add(archive, name, bytes);
  if (zip_close(archive) != 0) throw std::bad_alloc();
  std::string bytes = bytes_of(target);
  zip_source_free(target);
  return bytes;
}

void ZipReader::Discard::operator()(zip* archive) const { zip_discard(archive); }

ZipReader::ZipReader(std::string bytes, std::string name) : bytes_(std::move(bytes)), name_(std::move(name)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes_.data(), bytes_.size(), 0, &error);
  if (source) archive_.reset(zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error));
  const std::string reason = archive_ ? "" : zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive_) return;
  zip_source_free(source);
  throw UserError(fmt::format("{}: is not a whole ZIP archive ({})", name_, reason));
}

bool ZipReader::has(const std::string& file) const { return zip_name_locate(archive_.get(), file.c_str(), 0) >= 0; }

std::string ZipReader::read(const std::string& file) const {
  const auto refuse = [&](const char* reason) {
    throw UserError(fmt::format("{}: {} cannot be read ({})", name_, file, reason));
  };
  zip_stat_t status;
  const std::unique_ptr<zip_file_t, CloseFile> open(zip_fopen(archive_.get(), file.c_str(), 0));
  if (!open || zip_stat(archive_.get(), file.c_str(), 0, &status) != 0) refuse(zip_strerror(archive_.get()));
  std::string bytes;
  // A part at a time, so that a file that claims to be huge takes no memory. libzip checks the sum when it reads the
  // last, empty part.
  for (zip_int64_t length = 1; length > 0;) {
    const size_t before = bytes.size();
    bytes.resize(before + (size_t(1) << 20));
    length = zip_fread(open.get(), bytes.data() + before, bytes.size() - before);
    if (length < 0) refuse(zip_file_strerror(open.get()));
    bytes.resize(before + size_t(length));
  }
  if (bytes.size() != status.size) refuse("it ends early");
  return bytes;
}

}  // namespace crsh::output
