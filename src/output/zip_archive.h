#pragma once
// ZIP archives in memory.

#include <memory>
#include <string>
#include <utility>
#include <vector>

struct zip;

namespace crsh::output {

/// Files by name. The same files give the same bytes.
[[nodiscard]] std::string encode_zip(const std::vector<std::pair<std::string, std::string>>& files);

/// An archive that is read file by file.
class ZipReader {
 public:
  /// Throws UserError that begins with `name` where the bytes are no archive, or a broken one.
  ZipReader(std::string bytes, std::string name);

  [[nodiscard]] bool has(const std::string& file) const;
  /// The bytes of a file of the archive. Throws UserError where they are broken.
  [[nodiscard]] std::string read(const std::string& file) const;

 private:
  struct Discard {
    void operator()(zip* archive) const;
  };
  std::string bytes_, name_;
  std::unique_ptr<zip, Discard> archive_;
};

}  // namespace crsh::output
