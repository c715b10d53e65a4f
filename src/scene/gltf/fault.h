#pragma once
// What the loader throws and notes while it reads a file.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::scene {

/// Why a glTF file cannot be drawn. load() puts the file's name before it and makes a UserError of it.
class Fault : public std::runtime_error {
 public:
  explicit Fault(const std::string& reason, std::string mend = "export the scene again")
      : std::runtime_error(reason), mend_(std::move(mend)) {}
  [[nodiscard]] const std::string& mend() const { return mend_; }

 private:
  std::string mend_;
};

/// The file asks for more work than any file needs.
class TooLarge : public Fault {
 public:
  TooLarge() : Fault("is too large to be drawn", "simplify the scene") {}
};

/// A file names another that lies outside its own folder.
class OutsideFault : public Fault {
 public:
  explicit OutsideFault(const std::string& name = {})
      : Fault(name + "lies outside the scene's folder", "put it beside the scene, or allow it explicitly") {}
};

/// A file requires extensions that crsh does not do.
class NeedsExtensions : public Fault {
 public:
  explicit NeedsExtensions(const std::string& reason)
      : Fault(reason, "export the scene without, or draw the rest of it") {}
};

/// Text from a file, made fit for one line of a terminal: no control characters, no more than `limit` bytes.
[[nodiscard]] std::string printable(std::string_view text, size_t limit = 120);

/// The same in single quotes.
[[nodiscard]] std::string in_quotes(std::string_view text, size_t limit = 120);

/// Short clauses about what the file asks for and crsh does not do, each once.
class Notes {
 public:
  explicit Notes(std::vector<std::string>& list) : list_(list) {}
  void add(std::string_view clause);

 private:
  std::vector<std::string>& list_;
};

}  // namespace crsh::scene
